//! `objdict dcf pack`.

use std::path::Path;

use super::super::annotation::DescribedStream;
use super::super::args::{BlobFormat, PackArgs};
use super::super::convert::{read_data, refusal, tell_skipped};
use super::super::ending::{Failure, Outcome, tell};
use super::super::input::{ExpandArgs, Input, InputArgs, source_name};
use super::super::settings::ConfigFileArgs;
use super::super::stdout::Output;
use super::{count, deliver, device, hex_of, stream_of, verify};
use objdict_format::input::{FileKind, Reading};
use objdict_model::model::Device;
use objdict_node::concise;
use objdict_node::download::{ConciseDcf, PlanOptions, Scope};

pub(super) fn run(args: &PackArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let eds = args.eds.as_ref().map(|path| device(path, &args.input, &args.expand)).transpose()?;
    let stream_node_id = node_id(args, None, eds.as_ref());
    let (configuration, own) = match content(&args.file, &args.input, &args.expand, stream_node_id)? {
        PackedContent::Device(device) => (planned(args, &device, eds.as_ref())?, Some(device)),
        PackedContent::Stream(configuration) => (configuration, None),
    };
    let mut outcome = Outcome::Clean;
    let node_id = node_id(args, own.as_deref(), eds.as_ref());
    let described = DescribedStream { device: eds.as_ref().or(own.as_deref()), node_id };
    if let Some(against) = described.device {
        let verification = configuration.verify(against, node_id);
        tell(&verify::text(&verification, described));
        if !verification.is_accepted() {
            let refused = verification.refusals().count();
            if !args.force {
                let message = format!(
                    "the node would reject {refused} of {}, so nothing is written",
                    count(&configuration)
                );
                Failure::new(message).help("fix the values; `--force` writes the stream anyway").print();
                return Ok(Outcome::Findings);
            }
            outcome = Outcome::Findings;
        }
    }
    let stream = configuration.write().map_err(Failure::new)?;
    let spelled = match format(args).spelling() {
        Some(spelling) => spelling.spell(&stream, &stem(args)),
        None => concise::print(&configuration, |download| described.annotate(download)).into_bytes(),
    };
    let what = format!("{}, {} bytes", count(&configuration), stream.len());
    deliver(args.output.as_deref(), &spelled, &what, out)?;
    Ok(outcome)
}

/// What is in the file of a configuration.
pub(crate) enum PackedContent {
    Device(Box<Device>),
    /// In any of its spellings.
    Stream(ConciseDcf),
}

/// Reads a configuration; the formulas of a text are for `node_id`.
pub(crate) fn content(
    path: &Path,
    input: &InputArgs,
    expand: &ExpandArgs,
    node_id: Option<u8>,
) -> Result<PackedContent, Failure> {
    let name = source_name(path);
    let bytes = input.size.read(path)?; // once: it may be the standard input
    let reading =
        Reading { is_node: true, ..input.reading_with(&ConfigFileArgs::default().patches_of(path)?) };
    let is_stream = hex_of(&bytes, input).is_some()
        || matches!(reading.recognised(&name, bytes.clone())?.0, FileKind::Cdcf | FileKind::CdcfText);
    if is_stream {
        return stream_of(&name, bytes, input, node_id).map(PackedContent::Stream);
    }
    match reading.read_one(&name, bytes)? {
        (_, Input::Description(description)) => {
            Ok(PackedContent::Device(Box::new(expand.device(description.device()).into_owned())))
        }
        (_, Input::Device(device)) => {
            Ok(PackedContent::Device(Box::new(expand.device(&device).into_owned())))
        }
        (_, Input::Concise(configuration)) => Ok(PackedContent::Stream(configuration)),
        (_, Input::NodeList(_)) => {
            Err(Failure::new(format_args!("`{name}` is a node list and contains no values"))
                .help(format!("`objdict show {name}` lists the files of its nodes")))
        }
    }
}

/// The downloads that bring a node to what the device says.
fn planned(args: &PackArgs, device: &Device, eds: Option<&Device>) -> Result<ConciseDcf, Failure> {
    let options = PlanOptions {
        node_id: node_id(args, Some(device), eds),
        scope: match (args.all, args.pdos) {
            (true, _) => Scope::All,
            (_, true) => Scope::Pdos,
            _ => Scope::Changed,
        },
        order: args.order,
        only: (!args.only.is_empty()).then(|| args.only.iter().cloned().flatten().collect()),
        ..PlanOptions::default()
    };
    let rebased = eds.map(|eds| ConciseDcf::rebased(device, eds));
    let plan =
        ConciseDcf::plan(rebased.as_ref().unwrap_or(device), &options).map_err(|error| refusal(&error))?;
    tell_skipped(&plan);
    let folder = args.paths.folder_of(&args.file);
    plan.into_concise(|file| read_data(&folder, file))
}

fn node_id(args: &PackArgs, own: Option<&Device>, eds: Option<&Device>) -> Option<u8> {
    args.node_id.or_else(|| own?.node_id()).or_else(|| eds?.node_id())
}

/// What is written: a file of texts holds a text.
fn format(args: &PackArgs) -> BlobFormat {
    let named = args.output.as_deref().and_then(FileKind::of);
    args.to.unwrap_or(if named == Some(FileKind::CdcfText) { BlobFormat::Text } else { BlobFormat::Bin })
}

/// What an identifier is made of.
fn stem(args: &PackArgs) -> String {
    let path = args.output.as_deref().unwrap_or(&args.file);
    let name = path.file_name().filter(|_| path != Path::new("-")).unwrap_or_default().to_string_lossy();
    name.split('.').next().unwrap_or_default().to_owned()
}
