//! What is made of a description: other formats, code, pages, changes.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;

use objdict::document::dbc::{self, BusNode, DbcOptions};
use objdict::document::{self, CodeName, Finding, Form, Identifiers, Subject};
use objdict::download::{ConciseDcf, NeededFile, PlanOptions};
use objdict::format::{self, Format, WriteOptions, json};
use objdict::generate::{self as code, Generated, Options, Target};
use objdict::lint::changes::compare;
use objdict::model::{Commissioning, Device, DeviceKind};
use objdict::report::Location;
use objdict::source::Folder;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::dictionary::NativeDictionary;
use super::findings::findings_of;
use super::raised;
use super::shared::{Described, SharedDescription};
use super::value::NodeId;

/// A file of another format, and what it does not have of the device.
type Converted = (Vec<u8>, Vec<String>);

/// The description as a file of this name in another format, and what that does not have of it, a line each.
#[pyfunction]
#[pyo3(signature = (of, to, name, node_id=None, bit_rate=None, embed=true))]
pub(crate) fn convert<'py>(
    py: Python<'py>,
    of: &NativeDictionary,
    to: &str,
    name: &str,
    node_id: Option<NodeId>,
    bit_rate: Option<u16>,
    embed: bool,
) -> PyResult<(Bound<'py, PyBytes>, Vec<String>)> {
    let shared = of.now();
    let node = OutputNode { node_id: node_id.map(|node| node.0).or(shared.node_id), bit_rate };
    let (bytes, lost) = py.detach(|| converted(&shared, to, name, &node, embed))?;
    Ok((PyBytes::new(py, &bytes), lost))
}

/// The files of a target by their names, and the notes about them.
#[pyfunction]
pub(crate) fn generate(
    py: Python<'_>,
    of: &NativeDictionary,
    target: &str,
) -> PyResult<(BTreeMap<String, String>, Vec<String>)> {
    let shared = of.now();
    shared.refuse_errors()?;
    let target = Target::named(target).map_err(raised)?;
    let mut options = Options::default();
    options.node_id = shared.node_id;
    let stem = Path::new(shared.source().name()).file_stem();
    options.file_stem = stem.map_or_else(|| "device".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let Generated { files, notes, .. } =
        py.detach(|| code::generate(shared.device(), target, &options)).map_err(raised)?;
    let text = |contents: Vec<u8>| String::from_utf8(contents).map_err(raised);
    let files = files.into_iter().map(|file| Ok((file.path, text(file.contents)?)));
    Ok((files.collect::<PyResult<_>>()?, notes.iter().map(ToString::to_string).collect()))
}

/// The documentation as a page: `html`, `md` or `csv`.
#[pyfunction]
#[pyo3(signature = (of, form, language=None))]
pub(crate) fn docs(
    py: Python<'_>,
    of: &NativeDictionary,
    form: &str,
    language: Option<String>,
) -> PyResult<String> {
    let form = Form::of_extension(form).ok_or_else(|| raised(format_args!("there is no form `{form}`")))?;
    py.detach(|| page(&of.now(), form, language))
}

/// The changes from one device to another: rule, index, sub-index, old, new, verdict and message of each.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a row of a table, which Python gives names")]
pub(crate) fn changes(
    py: Python<'_>,
    old: &NativeDictionary,
    new: &NativeDictionary,
) -> Vec<(String, Option<u16>, Option<u8>, Option<String>, Option<String>, &'static str, String)> {
    let row = |change: objdict::lint::changes::DeviceChange| {
        let (verdict, message) = (change.verdict().name(), change.message.to_string());
        let rule = change.rule.info.id.to_owned();
        (rule, change.index, change.sub, change.old, change.new, verdict, message)
    };
    let (old, new) = (old.now(), new.now());
    py.detach(|| compare(old.device(), new.device()).into_iter().map(row).collect())
}

/// The node that a description of one is for.
struct OutputNode {
    node_id: Option<u8>,
    bit_rate: Option<u16>,
}

impl OutputNode {
    /// What the description says of its node, but for what is wanted otherwise.
    fn commissioning(&self, stated: Option<&Commissioning>) -> PyResult<Commissioning> {
        let mut node = stated.cloned().unwrap_or_default();
        (node.node_id, node.baud_rate) = (Some(self.node_id()?), self.bit_rate.or(node.baud_rate));
        Ok(node)
    }

    fn node_id(&self) -> PyResult<u8> {
        self.node_id.ok_or_else(|| {
            PyValueError::new_err("the node-ID is missing: give `node_id`, 1 to 127, to `load` or here")
        })
    }
}

fn converted(
    shared: &SharedDescription,
    to: &str,
    name: &str,
    node: &OutputNode,
    embed: bool,
) -> PyResult<Converted> {
    shared.refuse_errors()?;
    let device = shared.whole();
    match to {
        "json" => return Ok((json::write_device(device).into_bytes(), Vec::new())),
        "cdcf" => return Ok((concise(shared, node)?, Vec::new())),
        "dbc" => return dbc(device, node.node_id()?),
        _ => {}
    }
    let format = Format::from_name(to).ok_or_else(|| raised(format_args!("there is no format `{to}`")))?;
    if let Some(bytes) = edited(shared, format, name, node)? {
        return Ok((bytes, Vec::new()));
    }
    let mut device = device.clone();
    if format.kind() == DeviceKind::Node {
        device.commissioning = Some(node.commissioning(device.commissioning.as_ref())?);
        device.kind = DeviceKind::Node;
    }
    let mut options = WriteOptions::default();
    options.embed = embed;
    let written = format::convert(device, Path::new(name), format, false, &options).map_err(raised)?;
    Ok((written.bytes, written.losses.iter().map(ToString::to_string).collect()))
}

/// The text with what must change in it, so that comments and order stay; `None` where the format has another syntax.
fn edited(
    shared: &SharedDescription,
    to: Format,
    name: &str,
    node: &OutputNode,
) -> PyResult<Option<Vec<u8>>> {
    let Described::Text(description) = &shared.described else { return Ok(None) };
    let is_read_only =
        description.is_project() || description.is_network() || description.variant().is_some();
    if is_read_only || description.format().syntax() != to.syntax() {
        return Ok(None);
    }
    let is_same = description.format() == to && node.bit_rate.is_none() && shared.revision == 0;
    let is_node_kept = node.node_id == description.device().node_id();
    Ok(Some(match to.kind() {
        _ if is_same && (is_node_kept || to.kind() == DeviceKind::Type) => description.print(),
        DeviceKind::Type => description.to_type(name).map_err(raised)?,
        DeviceKind::Node => {
            let stated = description.device().commissioning.as_ref();
            description.to_node(name, &node.commissioning(stated)?).map_err(raised)?
        }
    }))
}

/// The frames of the node as a DBC, and what is on the bus and not in it.
fn dbc(device: &Device, node_id: u8) -> PyResult<Converted> {
    let name = device.commissioning.as_ref().and_then(|node| node.node_name.as_deref());
    let bus = [BusNode { device, node_id, name, is_counterpart: false }];
    let written = dbc::write(&bus, DbcOptions::default());
    let lost = written.omissions.iter().filter(|omission| omission.is_lost);
    let lost = lost.map(|omission| format!("{}: {}", omission.place, omission.reason)).collect();
    Ok((written.bytes, lost))
}

/// The downloads that configure the node. Files that they need are beside the description.
fn concise(shared: &SharedDescription, node: &OutputNode) -> PyResult<Vec<u8>> {
    let mut options = PlanOptions::default();
    options.node_id = node.node_id;
    let plan = ConciseDcf::plan(shared.device(), &options).map_err(raised)?;
    let folder = shared.path.as_deref().map(Folder::of);
    let read = |file: &NeededFile| match &folder {
        Some(folder) => folder.read(&file.name).map_err(raised),
        None => Err(raised(format_args!("`{}` is needed, and bytes are in no folder", file.name))),
    };
    plan.into_concise(read)?.write().map_err(raised)
}

fn page(shared: &SharedDescription, form: Form, language: Option<String>) -> PyResult<String> {
    let (subject, findings) = findings_of(shared)?;
    let line = |finding| Location::line_of(subject, finding);
    let findings: Vec<_> = findings
        .iter()
        .map(|finding| Finding::new(finding, line(finding)).on_page_of(shared.device()))
        .collect();
    let names = code::identifiers(shared.device()).unwrap_or_default();
    let names = names.into_iter().map(|of| ((of.index, of.sub), CodeName { rust: of.rust, c: of.c }));
    Ok(with_subject(shared, Some(&findings), &names.collect(), |subject| {
        let mut options = document::Options::default();
        (options.node_id, options.language) = (shared.node_id, language);
        document::write(subject, form, &options)
    }))
}

fn with_subject(
    shared: &SharedDescription,
    findings: Option<&[Finding]>,
    identifiers: &Identifiers,
    write: impl FnOnce(&Subject<'_>) -> String,
) -> String {
    let name = Path::new(shared.source().name()).file_name();
    let file = name.map_or(Cow::Borrowed(""), |name| name.to_string_lossy());
    let format = shared.kind().name();
    write(&Subject { device: shared.device(), file: &file, format, findings, identifiers })
}

/// The card at the top of the documentation.
#[pyfunction]
pub(crate) fn card(of: &NativeDictionary) -> String {
    with_subject(&of.now(), None, &Identifiers::new(), |subject| document::card(subject, &Default::default()))
}
