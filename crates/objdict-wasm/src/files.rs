//! Files that are made of a device, as the command makes them.

use std::path::Path;

use objdict::document::dbc::{self, BusNode, DbcOptions};
use objdict::document::{self, CodeName, Finding, Form, Identifiers, Options, Subject};
use objdict::download::{ConciseDcf, PlanOptions, Scope};
use objdict::format::input::refuse_errors;
use objdict::format::{self, Description, Format, LossKind, WriteOptions};
use objdict::generate::{self, Target};
use objdict::model::{Commissioning, DeviceKind};
use objdict::report::{Location, grouped};
use objdict::source::hash;
use objdict::workspace;
use serde::{Deserialize, Serialize};

use crate::answer::BadRequest;

/// A file, and what it does not have of the device.
#[derive(Debug, Default)]
pub(crate) struct PageFile {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
}

/// Files that were made, as an answer lists them.
#[derive(Debug, Serialize)]
pub(crate) struct Made {
    /// Their names, in the order in which `take` numbers them.
    pub(crate) files: Vec<String>,
    /// What they do not have of the device, or assume.
    pub(crate) notes: Vec<String>,
}

/// The files and the notes about them.
pub(crate) type Files = Result<(Vec<PageFile>, Vec<String>), BadRequest>;

/// What a node needs to be one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RequestedNode {
    pub(crate) node_id: Option<u8>,
    /// In kbit/s.
    pub(crate) bit_rate: Option<u16>,
}

/// How entries of objects in compact storage are written when a file is written anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum CompactStorage {
    /// As `CompactSubObj`.
    Compact,
    /// A section for each entry.
    Expanded,
}

/// A description as a file of a format, as `objdict convert` writes it.
pub(crate) fn save(
    description: &Description,
    name: &str,
    node: RequestedNode,
    storage: Option<CompactStorage>,
) -> Files {
    let format = Format::from_name(name).ok_or_else(|| {
        BadRequest::new(format_args!("`{name}` has no ending of a known format"))
            .help("`.eds`, `.dcf`, `.xdd`, `.xdc` and `.toml` are known")
    })?;
    let is_node = format.kind() == DeviceKind::Node;
    let own = description.device().commissioning.clone().unwrap_or_default();
    let commissioning = Commissioning {
        node_id: node.node_id.or(own.node_id),
        baud_rate: node.bit_rate.or(own.baud_rate),
        ..own
    };
    if is_node && !commissioning.node_id.is_some_and(|node_id| (1..=127).contains(&node_id)) {
        return Err(BadRequest::new("a DCF or XDC is for one node").help("state its node-ID, from 1 to 127"));
    }
    if format != description.format() {
        refuse_errors(description, workspace::judge(description))?;
    }
    let has_text = !description.is_project() && !description.is_network();
    let mut notes = Vec::new();
    let bytes = if storage.is_none() && has_text && format == description.format() && !is_node {
        description.print()
    } else if storage.is_none() && has_text && format.syntax() == description.format().syntax() {
        match is_node {
            true => description.to_node(name, &commissioning),
            false => description.to_type(name),
        }
        .map_err(BadRequest::new)?
    } else {
        let mut device = description.described().clone();
        if is_node {
            (device.commissioning, device.kind) = (Some(commissioning), DeviceKind::Node);
        }
        let mut options = WriteOptions { embed: true, ..WriteOptions::default() };
        options.eds.compact = storage == Some(CompactStorage::Compact);
        let written =
            format::convert(device, Path::new(name), format, false, &options).map_err(BadRequest::new)?;
        let lost = written.losses.iter().filter(|loss| loss.kind == LossKind::Lost);
        notes.extend(lost.map(ToString::to_string));
        written.bytes
    };
    Ok((vec![PageFile { name: name.to_owned(), bytes }], notes))
}

/// The tables of a target, as `objdict generate` writes them.
pub(crate) fn tables(description: &Description, target: &str) -> Files {
    let target = Target::named(target).map_err(BadRequest::new)?;
    let findings = objdict::check(description);
    if let Some(stopping) = findings.iter().find(|finding| finding.stops(target.name())) {
        let message = format!("tables would be wrong: {}", stopping.message);
        return Err(BadRequest::new(message).help("correct the errors first"));
    }
    let source = description.source();
    let options = generate::Options {
        file_stem: stem(source.name()).to_owned(),
        source_hash: Some(hash(source.text().as_bytes())),
        ..generate::Options::default()
    };
    refuse_errors(description, workspace::judge(description))?;
    let made = generate::generate(description.device(), target, &options).map_err(BadRequest::new)?;
    let files = made.files.into_iter().map(|file| PageFile { name: file.path, bytes: file.contents });
    Ok((files.collect(), made.notes.iter().map(ToString::to_string).collect()))
}

/// The documentation, as `objdict docs` writes it.
pub(crate) fn page(description: &Description, extension: &str) -> Files {
    let form = Form::of_extension(extension)
        .ok_or_else(|| BadRequest::new(format_args!("`{extension}` is not a form of documentation")))?;
    let findings = grouped(description, objdict::check(description));
    let findings: Vec<Finding> = findings
        .iter()
        .map(|finding| Finding::new(finding, Location::line_of(description.into(), finding)))
        .map(|finding| finding.on_page_of(description.device()))
        .collect();
    let names = generate::identifiers(description.device()).unwrap_or_default();
    let identifiers: Identifiers =
        names.into_iter().map(|of| ((of.index, of.sub), CodeName { rust: of.rust, c: of.c })).collect();
    let name = description.source().name();
    let subject = Subject {
        device: description.device(),
        file: name,
        format: description.format().name(),
        findings: Some(&findings),
        identifiers: &identifiers,
    };
    let text = document::write(&subject, form, &Options::default());
    let name = format!("{}.{extension}", stem(name));
    Ok((vec![PageFile { name, bytes: text.into_bytes() }], Vec::new()))
}

/// The messages of the node, as `objdict convert … -o FILE.dbc` writes them.
pub(crate) fn dbc(description: &Description, node: RequestedNode) -> Files {
    let device = description.device();
    let node_id = node_id(description, node)?;
    let name = device.commissioning.as_ref().and_then(|node| node.node_name.as_deref());
    let bus = [BusNode { device, node_id, name, is_counterpart: false }];
    let written = dbc::write(&bus, DbcOptions { sdo: false, bits: false });
    let lost = written.omissions.iter().filter(|omission| omission.is_lost);
    let notes = lost.map(|omission| format!("{}: {}", omission.place, omission.reason)).collect();
    let name = format!("{}.dbc", stem(description.source().name()));
    Ok((vec![PageFile { name, bytes: written.bytes }], notes))
}

/// The downloads that configure the node.
pub(crate) fn concise(description: &Description, node: RequestedNode, all: bool) -> Files {
    let scope = if all { Scope::All } else { Scope::Changed };
    let options = PlanOptions { node_id: node.node_id, scope, ..PlanOptions::default() };
    let plan = ConciseDcf::plan(description.device(), &options).map_err(|error| {
        let help = error.help().map(ToString::to_string);
        BadRequest { help, ..BadRequest::new(error) }
    })?;
    let mut notes: Vec<String> =
        plan.skipped.iter().map(|skipped| format!("{}: {}", skipped.place, skipped.reason)).collect();
    if plan.steps.is_empty() {
        notes.push("nothing is configured to another value than its default: the stream is empty".to_owned());
    }
    let missing = |file: &objdict::download::NeededFile| {
        Err(BadRequest::new(format_args!(
            "the data of {:04X}h:{:02X} are in the file `{}`",
            file.index, file.sub, file.name
        ))
        .help("make the concise DCF with the command beside that file"))
    };
    let configuration = plan.into_concise(missing)?;
    let bytes = configuration.write().map_err(BadRequest::new)?;
    Ok((vec![PageFile { name: format!("{}.cdcf", stem(description.source().name())), bytes }], notes))
}

fn node_id(description: &Description, node: RequestedNode) -> Result<u8, BadRequest> {
    let node_id = node.node_id.or(description.device().node_id());
    node_id
        .filter(|node_id| (1..=127).contains(node_id))
        .ok_or_else(|| BadRequest::new("missing node-ID").help("state the node-ID, from 1 to 127"))
}

/// The name of a file without its last ending.
pub(crate) fn stem(name: &str) -> &str {
    let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}
