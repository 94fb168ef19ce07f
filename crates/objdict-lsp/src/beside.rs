//! New files beside a description: in another syntax, and as a node of a network.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::json;

use super::file::CheckedFile;
use super::protocol::{TextEdit, WorkspaceEdit};
use super::uri::of_path;
use super::workspace::EditorWorkspace;
use objdict_format::{Description, Format, Syntax, WriteOptions, convert};
use objdict_model::diagnostic::Severity;
use objdict_model::model::{Access, DeviceKind, Value};
use objdict_model::source::{SourceFile, SourceOptions, is_file};
use objdict_network_file::node_name;

/// A new file with the description in another syntax.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum OtherSyntax {
    /// EDS or DCF.
    Ini,
    /// XDD or XDC.
    Xml,
}

/// What a description can be converted to: another syntax whose file is not there.
pub(super) fn targets(file: &CheckedFile, description: &Description) -> Vec<OtherSyntax> {
    if description.device_count() > 1 || description.device().objects.is_empty() {
        return Vec::new();
    }
    let syntax = description.format().syntax();
    let targets = [(Syntax::Ini, OtherSyntax::Ini), (Syntax::Xml, OtherSyntax::Xml)].into_iter();
    let others = targets.filter(|(other, _)| *other != syntax).map(|(_, target)| target);
    others.filter(|target| !is_file(&target.path(file))).collect()
}

impl OtherSyntax {
    fn format(self, file: &CheckedFile) -> Format {
        let kind = file.description().map_or(DeviceKind::Type, |description| description.device().kind);
        Format::of(if matches!(self, Self::Ini) { Syntax::Ini } else { Syntax::Xml }, kind)
    }

    /// `a.xdd` of `a.eds` and of `a.device.toml`.
    fn path(self, file: &CheckedFile) -> PathBuf {
        let path = Path::new(file.source().name());
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let stem = stem.strip_suffix(".device").unwrap_or(&stem);
        path.with_file_name(format!("{stem}.{}", self.format(file).name().to_ascii_lowercase()))
    }

    pub(super) fn title(self, file: &CheckedFile) -> String {
        let path = self.path(file);
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        format!("convert to {} in `{name}`", self.format(file).name())
    }

    /// The new file; `None` where it is there by now, or the description cannot be written so.
    pub(super) fn edit(self, file: &CheckedFile) -> Option<WorkspaceEdit> {
        let (path, format) = (self.path(file), self.format(file));
        let device = file.description()?.device().clone();
        let options = WriteOptions { embed: true, ..WriteOptions::default() };
        let written = convert(device, &path, format, false, &options).ok()?;
        let encoding = SourceOptions { max_size: u64::MAX, ..SourceOptions::default() };
        let source = SourceFile::from_bytes(path.display().to_string(), written.bytes, &encoding).ok()?;
        (!is_file(&path)).then(|| created(&path, source.text()))?
    }
}

/// The edit that creates a file; it fails in the editor where the file is there.
pub(super) fn created(path: &Path, text: &str) -> Option<WorkspaceEdit> {
    let uri = of_path(path)?;
    let edit = TextEdit { new_text: text.to_owned(), ..TextEdit::default() };
    let options = json!({ "overwrite": false, "ignoreIfExists": false });
    let document_changes = json!([
        { "kind": "create", "uri": uri, "options": options },
        { "textDocument": { "uri": uri, "version": null }, "edits": [edit] },
    ]);
    Some(WorkspaceEdit { document_changes: Some(document_changes), ..WorkspaceEdit::default() })
}

/// Whether a description is that of a node which a network can have.
pub(super) fn is_node(description: &Description) -> bool {
    description.device().node_id().is_some() && description.device_count() == 1
}

/// Adds the node of a DCF to the network of its folder, or begins one: the description of its type with the configured values, where
/// the network takes them, else the DCF.
pub(super) fn add_node(file: &CheckedFile, workspace: &mut EditorWorkspace) -> Option<WorkspaceEdit> {
    let description = file.description()?;
    let folder = Path::new(file.source().name()).parent()?.to_owned();
    let network = workspace.network_in(&folder);
    let taken: Vec<String> = match network.as_ref().and_then(|network| network.analysis.network()?.network())
    {
        Some(network) => network.nodes.iter().map(|node| node.name.value.clone()).collect(),
        None => Vec::new(),
    };
    let stated = description.device().commissioning.as_ref().and_then(|node| node.node_name.clone());
    let stem = Path::new(file.name()).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let name = node_name(&stated.filter(|name| !name.trim().is_empty()).or(stem)?);
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let name = std::iter::once(name.clone()).chain(numbered).find(|name| !taken.contains(name))?;
    let with_values = description.origin().map(|origin| of_type(&name, description, origin));
    let as_it_is = format!("[node.{name}]\nfile = {}\n", objdict_model::json::text(&file.name()).ok()?);
    let Some(network) = network else {
        let path = folder.join("network.toml");
        let text = with_values.unwrap_or(as_it_is);
        return if is_file(&path) { None } else { created(&path, &text) };
    };
    let text = network.text();
    let separator = if text.is_empty() || text.ends_with('\n') { "\n" } else { "\n\n" };
    let errors = |file: &CheckedFile| {
        let findings = file.analysis.findings.iter().flatten();
        findings.filter(|finding| finding.severity == Severity::Error).count() + file.analysis.errors.len()
    };
    let is_sound = |edited: &String| {
        let after = workspace.reading(|| network.again(edited));
        let has_node = after
            .analysis
            .network()
            .and_then(|network| network.network())
            .is_some_and(|network| network.nodes.iter().any(|node| node.name.value == name));
        has_node && errors(&after) <= errors(&network)
    };
    let texts = with_values.into_iter().chain([as_it_is]).map(|node| format!("{text}{separator}{node}"));
    let edited = texts.into_iter().find(is_sound)?;
    Some(network.workspace_edit(network.edits_to(&edited)))
}

/// A node by the description of its type, with the values that its DCF has and the type has not.
fn of_type(name: &str, description: &Description, origin: &Description) -> String {
    let quoted = |text: &str| objdict_model::json::text(&text).unwrap_or_default();
    let file = origin.source().name().rsplit(['/', '\\']).next().unwrap_or_default();
    let device = description.device();
    let node_id = device.node_id().unwrap_or_default();
    let mut text = format!("[node.{name}]\nfile = {}\nid = {node_id}\n", quoted(file));
    let mut values = String::new();
    for (&index, object) in &device.objects {
        let has_subs = object.object_type().has_subs();
        for (sub, entry) in object.entries() {
            let default = origin.device().object(index).and_then(|object| object.value(sub));
            let value = entry.configured_value().filter(|value| Some(*value) != default.as_deref());
            let is_writable = entry.implied_access().is_some_and(Access::is_writable);
            let Some(value) = value.filter(|_| is_writable) else { continue };
            let address = if has_subs { format!("{index:04X}:{sub:X}") } else { format!("{index:04X}") };
            let shown = match (value, value.as_integer()) {
                (Value::NodeId(base), _) => quoted(&format!("$NODEID+0x{base:X}")),
                (_, Some(number)) => number.to_string(),
                (value, None) => quoted(&value.to_string()),
            };
            let _ = writeln!(
                values,
                "\"{address}\" = {shown}  # {}",
                objdict_model::diagnostic::one_line(&entry.name)
            );
        }
    }
    if !values.is_empty() {
        let _ = write!(text, "\n[node.{name}.set]\n{values}");
    }
    text
}
