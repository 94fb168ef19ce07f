//! What is made of a device.

use std::borrow::Cow;
use std::path::Path;

use super::super::annotation::DescribedStream;
use super::super::args::ConvertArgs;
use super::super::ending::{Failure, note, tell};
use super::super::input::{FileKind, name_of};
use super::super::node::{commissioning, former_node_id, restated, valid_node_id};
use super::Job;
use objdict_format as format;
use objdict_format::{Description, Format, Loss, LossKind, Syntax, WriteOptions, Written, json, stated_name};
use objdict_model::diagnostic::plural;
use objdict_model::diagnostic::{counted, series};
use objdict_model::model::{Commissioning, Device, DeviceKind, Part, Place};
use objdict_model::source::Folder;
use objdict_node::concise;
use objdict_node::configure::rebase;
use objdict_node::download::{ConciseDcf, NeededFile, Plan, PlanError, PlanOptions, Scope, Skipped};

/// What a file became.
pub(super) struct ConvertedFile {
    pub bytes: Vec<u8>,
    pub losses: Vec<Loss>,
}

impl ConvertedFile {
    /// Of which nothing is lost.
    pub(super) fn whole(bytes: Vec<u8>) -> Self {
        Self { bytes, losses: Vec::new() }
    }
}

/// What a new text keeps of data that its format has no place for.
#[derive(Clone, Copy)]
pub(super) struct KeptData {
    /// All, where objdict finds it again.
    pub embed: bool,
    /// Units, factors and descriptions that an EDS states in keys of python-canopen.
    pub meanings: bool,
}

/// A description is edited where its syntax stays, and written anew where it does not.
pub(super) fn of_description(
    args: &ConvertArgs,
    job: &Job,
    description: Description,
    from: FileKind,
) -> Result<ConvertedFile, Failure> {
    let max_losses = args.input.max_losses(description.source().text().len());
    let device = description.described();
    if *device == (Device { kind: device.kind, ..Device::default() }) {
        let failure = Failure::new(format_args!("`{}` does not describe a device", name_of(&job.input)));
        return Err(failure.help("run `objdict check` to see what is missing"));
    }
    let is_edited = job.to.format().is_some_and(|to| to.syntax() == description.format().syntax());
    refuse_unknown_text(job, &description, is_edited && !args.canonical.is_asked())?;
    let anew = |description: Description, embed: bool| {
        let mut unread = format::unread(&description);
        let kept = KeptData { embed, meanings: format::has_meaning_keys(&description) };
        let mut converted = of_device(args, job, description.into_described(), kept, max_losses)?;
        // comments are of a description, not of its model or values
        unread.retain(|loss| job.to.format().is_some() || loss.kind == LossKind::Lost);
        unread.append(&mut converted.losses);
        Ok(ConvertedFile { losses: unread, ..converted })
    };
    if description.is_project() || description.is_network() || description.is_composed() {
        return anew(description, !args.no_embed);
    }
    let Some(to) = job.to.format().filter(|to| to.syntax() == description.format().syntax()) else {
        return anew(description, !args.no_embed);
    };
    if args.canonical.is_asked() || args.expand.implicit_pdos || args.xdd_version.is_some() {
        // an EDS takes every text of another, an XDD only those that are valid, and other tools not all of them
        let is_narrower = to.syntax() == Syntax::Xml || args.canonical.dialect.is_other();
        return anew(description, !args.no_embed && is_narrower);
    }
    warn_of_violations(job, &description);
    if from == job.to && (to.kind() == DeviceKind::Type || !args.changes_node()) {
        warn_of_node_id(args, job, description.device());
        if to == Format::Xdc {
            valid_node_id(description.device().commissioning.as_ref().and_then(|node| node.node_id))?;
        }
        return Ok(ConvertedFile::whole(description.source().to_bytes()));
    }
    let file_name = base_name(&job.output);
    let node = match to.kind() {
        DeviceKind::Node => node(args, job, description.device())?,
        DeviceKind::Type => None,
    };
    let bytes = match to.kind() {
        DeviceKind::Node => description.to_node(&file_name, &node.clone().unwrap_or_default())?,
        DeviceKind::Type => description.to_type(&file_name)?,
    };
    let encoding = description.source().encoding();
    let mut expected = description.into_described();
    if to.kind() == DeviceKind::Node {
        expected.kind = DeviceKind::Node;
        expected.commissioning = node;
        expected.file_info.get_or_insert_default();
    }
    if let Some(info) = &mut expected.file_info {
        info.file_name = Some(file_name);
    }
    let mut options = WriteOptions { max_losses, ..WriteOptions::default() };
    options.eds.encoding = Some(encoding);
    let losses = format::losses(&expected, &bytes, to, &options)?;
    Ok(ConvertedFile { bytes, losses })
}

/// Refuses a file that refers to texts that it does not have, unless the output keeps the references.
fn refuse_unknown_text(job: &Job, description: &Description, is_kept: bool) -> Result<(), Failure> {
    let unknown = description.findings().iter().filter(|finding| finding.rule.id == "xml/unknown-entity");
    let count = unknown.count();
    let (file, entities) = (name_of(&job.input), counted(count, "unknown entity", "unknown entities"));
    match count {
        0 => Ok(()),
        _ if is_kept => {
            tell(&format!("warning: `{file}` has {entities}, which the output keeps\n"));
            Ok(())
        }
        _ => {
            let failure = Failure::new(format_args!("`{file}` has {entities}, whose text is unknown"));
            Err(failure.help("`objdict check` shows them; replace them with their text"))
        }
    }
}

/// Says that a text is not valid that the output will have.
fn warn_of_violations(job: &Job, description: &Description) {
    let count = description.violations().len();
    if count > 0 {
        let (file, places) = (name_of(&job.input), plural(count, "place"));
        tell(&format!(
            "warning: `{file}` violates CiA 311 in {places}, which the output keeps\n  help: `objdict check` shows them; `--canonical` rewrites the file to be valid\n"
        ));
    }
}

/// A device that has no text, or whose text has another syntax.
pub(super) fn of_device(
    args: &ConvertArgs,
    job: &Job,
    device: Device,
    kept: KeptData,
    max_losses: usize,
) -> Result<ConvertedFile, Failure> {
    let expanded = match args.expand.device(&device) {
        Cow::Owned(expanded) => Some(expanded),
        Cow::Borrowed(_) => None,
    };
    let device = expanded.unwrap_or(device);
    match job.to {
        FileKind::Json => Ok(ConvertedFile::whole(json::write_device(&device).into_bytes())),
        FileKind::CanopenEditorJson => {
            let Written { bytes, losses, .. } = format::canopeneditor::write(&device, max_losses)?;
            Ok(ConvertedFile { bytes, losses })
        }
        FileKind::Cdcf => {
            let (configuration, losses) = configuration(args, job, &device)?;
            Ok(ConvertedFile { bytes: configuration.write().map_err(Failure::new)?, losses })
        }
        FileKind::CdcfText => {
            let (configuration, losses) = configuration(args, job, &device)?;
            let described =
                DescribedStream { device: Some(&device), node_id: args.node_id.or(device.node_id()) };
            let text = concise::print(&configuration, |download| described.annotate(download));
            Ok(ConvertedFile { bytes: text.into_bytes(), losses })
        }
        FileKind::Cpj | FileKind::Dbc | FileKind::CanopenNode | FileKind::Objdictgen | FileKind::Esi => {
            Err(Failure::new(format_args!("a {} cannot be created from one description", job.to.name())))
        }
        description => {
            let mut device = device;
            if description.format().map(Format::kind) == Some(DeviceKind::Node) {
                device.commissioning = node(args, job, &device)?;
                device.kind = DeviceKind::Node;
            }
            anew(args, job, device, kept, max_losses)
        }
    }
}

/// A new text, written from the model alone.
fn anew(
    args: &ConvertArgs,
    job: &Job,
    device: Device,
    kept: KeptData,
    max_losses: usize,
) -> Result<ConvertedFile, Failure> {
    let mut options = args.canonical.options(args.input.encoding);
    options.embed = kept.embed;
    options.eds.meanings |= kept.meanings && !args.canonical.dialect.is_other();
    options.max_losses = max_losses;
    options.xdd_version = args.xdd_version.unwrap_or_default();
    let format = job.to.format().unwrap_or(Format::Eds);
    let written = format::convert(device, &job.output, format, args.keep_disabled, &options)?;
    Ok(ConvertedFile { bytes: written.bytes, losses: written.losses })
}

fn base_name(path: &Path) -> String {
    stated_name(&path.file_name().unwrap_or_default().to_string_lossy())
}

/// The node of the output. A DCF or XDC may leave it to the network which node-ID a device gets.
fn node(args: &ConvertArgs, job: &Job, device: &Device) -> Result<Option<Commissioning>, Failure> {
    let wanted = Commissioning {
        node_id: args.node_id,
        baud_rate: args.bit_rate,
        node_name: args.name.clone(),
        ..Commissioning::default()
    };
    // a DCF may leave it out, and an XDC has to state it
    let is_demanded = device.kind == DeviceKind::Type || job.to == FileKind::Xdc;
    warn_of_node_id(args, job, device);
    if !is_demanded && wanted.node_id.or(device.node_id()).is_none() {
        let is_stated = wanted != Commissioning::default() || device.commissioning.is_some();
        return Ok(is_stated.then(|| restated(device, &wanted)));
    }
    let node = commissioning(device, &wanted, job.to.name())?;
    let former = former_node_id(device, &node);
    if let Some(former) = former.filter(|&former| !rebase(device, former).assignments.is_empty()) {
        print_note(&format!(
            "the CAN-IDs of the former node-ID {former} are unchanged; update them with `objdict configure --node-id`"
        ));
    }
    Ok(Some(node))
}

/// Says that a DCF will have a node-ID that no node has; an XDC is not written with one.
fn warn_of_node_id(args: &ConvertArgs, job: &Job, device: &Device) {
    let stated = device.commissioning.as_ref().and_then(|node| node.node_id);
    // 255 is a node that LSS configures
    let invalid = stated.filter(|node_id| !matches!(node_id, 1..=127 | 255));
    if let Some(node_id) = invalid.filter(|_| args.node_id.is_none() && job.to == FileKind::Dcf) {
        let file = name_of(&job.input);
        tell(&format!(
            "warning: `{file}` has the invalid node-ID {node_id}, which the output keeps\n  help: set it with `--node-id`\n"
        ));
    }
}

/// The downloads that configure a node as the device says, and the entries that none of them writes.
fn configuration(args: &ConvertArgs, job: &Job, device: &Device) -> Result<(ConciseDcf, Vec<Loss>), Failure> {
    let scope = if args.all { Scope::All } else { Scope::Changed };
    let options = PlanOptions { node_id: args.node_id, scope, ..PlanOptions::default() };
    let plan = ConciseDcf::plan(&device.without_disabled(), &options).map_err(|error| refusal(&error))?;
    tell_empty(&plan);
    let disabled = device.objects.iter().filter(|(_, object)| object.is_disabled()).map(|(&index, _)| {
        let reason = "the object is disabled".to_owned();
        left_out(device, &Place::object(index), LossKind::LeftOut, reason)
    });
    let left_out = plan.skipped.iter().map(|skipped| {
        let reason = format!("not part of the stream: {}", skipped.reason);
        left_out(device, &skipped.place, LossKind::LeftOut, reason)
    });
    let losses = disabled.chain(left_out).collect();
    let folder = args.network.paths.folder_of(&job.input);
    Ok((plan.into_concise(|file| read_data(&folder, file))?, losses))
}

/// An entry whose value a file for other data does not have.
pub(super) fn left_out(device: &Device, place: &Place, kind: LossKind, reason: String) -> Loss {
    let (path, value) = match place.part {
        Part::Entry(index, sub) => {
            let object = device.object(index);
            let sub_path = match object.and_then(|object| object.subs.get(sub)) {
                Some(_) => format!("/subs/0x{sub:02X}"),
                None => String::new(),
            };
            let entry = object.and_then(|object| object.entry(sub));
            let is_configured = entry.as_ref().is_some_and(|entry| entry.configured_value().is_some());
            let field = if is_configured { "configured/value" } else { "default" };
            let value = entry.as_ref().and_then(|entry| entry.value());
            let path = format!("/objects/0x{index:04X}{sub_path}/{field}");
            (path, serde_json::to_value(value).unwrap_or_default())
        }
        _ => (String::new(), serde_json::Value::Null),
    };
    Loss { place: place.clone(), path, kind, value: value.into(), becomes: None, reason: Some(reason) }
}

/// A plan that cannot be made.
pub(crate) fn refusal(error: &PlanError) -> Failure {
    let failure = Failure::of_lines(error.to_string().lines());
    match error.help() {
        Some(help) => failure.help(help),
        None => failure,
    }
}

/// The data of a DOMAIN, from the file that the description names.
pub(crate) fn read_data(folder: &Folder, file: &NeededFile) -> Result<Vec<u8>, Failure> {
    folder.read(&file.name).map_err(|error| {
        let entry = format!("0x{:04X}sub{:X}", file.index, file.sub);
        let failure = Failure::new(format_args!("the data of {entry}: {error}"));
        match error.help() {
            Some(help) => failure.help(help),
            None => failure,
        }
    })
}

/// Says what a plan leaves out, each reason once.
pub(crate) fn tell_skipped(plan: &Plan) {
    const SHOWN: usize = 4;
    let mut rest: Vec<&Skipped> = plan.skipped.iter().collect();
    while let Some(reason) = rest.first().map(|skipped| skipped.reason) {
        let (same, others): (Vec<_>, Vec<_>) = rest.into_iter().partition(|skipped| skipped.reason == reason);
        let more = same.len().checked_sub(SHOWN).filter(|&more| more > 0).map(|more| format!("{more} more"));
        let places = same.iter().take(SHOWN).map(|skipped| skipped.place.to_string());
        print_note(&format!("{}: not part of the stream: {reason}", series(places.chain(more))));
        rest = others;
    }
    tell_empty(plan);
}

fn tell_empty(plan: &Plan) {
    if plan.steps.is_empty() {
        print_note("every value equals its default, so the stream is empty; write all values with `--all`");
    }
}

fn print_note(text: &str) {
    note(&format!("note: {text}\n"));
}
