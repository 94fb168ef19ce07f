//! `objdict dcf pack`.

use std::path::Path;

use super::super::annotation::Described;
use super::super::args::PackArgs;
use super::super::convert::{read_data, refusal, tell_skipped};
use super::super::input::{Input, name_of};
use super::super::output::Output;
use super::super::{Failure, Outcome, tell};
use super::{count, deliver, device, stream, verify};
use crate::download::{ConciseDcf, PlanOptions, Scope};
use crate::format::concise::BlobSpelling;
use crate::format::input::{FileKind, Reading};
use crate::model::Device;
use crate::source::Folder;

pub(super) fn run(args: &PackArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let eds = args.eds.as_ref().map(|path| device(path, &args.input, &args.expand)).transpose()?;
    let (configuration, own) = match own_device(args)? {
        Some(device) => (planned(args, &device, eds.as_ref())?, Some(device)),
        None => (stream(&args.file, &args.input, node_id(args, None, eds.as_ref()))?, None),
    };
    let mut outcome = Outcome::Clean;
    if let Some(against) = eds.as_ref().or(own.as_ref()) {
        let node_id = node_id(args, own.as_ref(), eds.as_ref());
        let verification = configuration.verify(against, node_id);
        tell(&verify::text(&verification, Described { device: Some(against), node_id }));
        if !verification.is_accepted() {
            let refused = verification.refusals().count();
            if !args.force {
                let message =
                    format!("the node refuses {refused} of {}, so nothing is written", count(&configuration));
                Failure::new(message)
                    .help("mend the values; `--force` writes the stream all the same")
                    .print();
                return Ok(Outcome::Findings);
            }
            outcome = Outcome::Findings;
        }
    }
    let stream = configuration.write().map_err(Failure::new)?;
    let spelled = BlobSpelling::from(args.format).spell(&stream, &stem(args));
    let what = format!("{}, {} bytes", count(&configuration), stream.len());
    deliver(args.output.as_deref(), &spelled, &what, out)?;
    Ok(outcome)
}

/// The device in the file; `None` where it is a stream in one of its spellings.
fn own_device(args: &PackArgs) -> Result<Option<Device>, Failure> {
    let bytes = args.input.size.bytes(&args.file)?;
    let reading = args.input.reading();
    let name = name_of(&args.file);
    match reading.kind(&name, &bytes)? {
        FileKind::Cdcf | FileKind::CdcfText => return Ok(None),
        _ => {}
    }
    let reading = Reading { node_id: args.node_id, ..reading };
    Ok(match reading.read_one(&name, bytes)? {
        (_, Input::Description(description)) => Some(args.expand.device(description.device()).into_owned()),
        (_, Input::Device(device)) => Some(args.expand.device(&device).into_owned()),
        _ => None,
    })
}

/// The downloads that bring a node to what the device says.
fn planned(args: &PackArgs, device: &Device, eds: Option<&Device>) -> Result<ConciseDcf, Failure> {
    let scope = if args.all { Scope::All } else { Scope::Changed };
    let node_id = node_id(args, Some(device), eds);
    let options = PlanOptions { node_id, scope, ..PlanOptions::default() };
    let rebased = eds.map(|eds| ConciseDcf::rebased(device, eds));
    let plan =
        ConciseDcf::plan(rebased.as_ref().unwrap_or(device), &options).map_err(|error| refusal(&error))?;
    tell_skipped(&plan);
    let mut folder = Folder::of(&args.file);
    for allowed in &args.allow_path {
        folder = folder.allow(allowed);
    }
    plan.into_concise(|file| read_data(&folder, file))
}

fn node_id(args: &PackArgs, own: Option<&Device>, eds: Option<&Device>) -> Option<u8> {
    args.node_id.or_else(|| own?.node_id()).or_else(|| eds?.node_id())
}

/// What an identifier is made of.
fn stem(args: &PackArgs) -> String {
    let path = args.output.as_deref().unwrap_or(&args.file);
    let name = path.file_name().filter(|_| path != Path::new("-")).unwrap_or_default().to_string_lossy();
    name.split('.').next().unwrap_or_default().to_owned()
}
