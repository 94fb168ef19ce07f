//! The objects of SARIF 2.1.0 that are written, with the names of the standard.

use std::collections::BTreeMap;
use std::io::{self, Write};

use serde::Serialize;

use super::level;
use crate::report::Fingerprint;
use objdict_model::diagnostic::{Applicability, FixSafety, HOME, RuleInfo};

/// The schema of a log.
pub(super) const SCHEMA: &str =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// The base of relative paths, with the name that services support.
pub(super) const SOURCE_ROOT: &str = "%SRCROOT%";

/// The properties of a run that follow the results (§3.14).
pub(super) struct Run<'a> {
    driver: Driver,
    artifacts: &'a [Artifact],
    bases: BTreeMap<&'static str, BaseFolder>,
    invocation: Invocation<'a>,
}

/// The folder of a base id (§3.14.14); its path is omitted, so that a run is the same on every machine.
#[derive(Serialize)]
struct BaseFolder {
    description: Message,
}

/// The tool (§3.19).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Driver {
    name: &'static str,
    version: &'static str,
    semantic_version: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    information_uri: Option<&'static str>,
    rules: Vec<Rule>,
}

/// A rule (§3.49).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Rule {
    id: &'static str,
    name: &'static str,
    short_description: Message,
    full_description: Message,
    help: Help,
    #[serde(skip_serializing_if = "Option::is_none")]
    help_uri: Option<String>,
    default_configuration: Configuration,
    properties: RuleProperties,
}

#[derive(Serialize)]
struct Help {
    text: String,
    markdown: String,
}

#[derive(Serialize)]
struct Configuration {
    level: &'static str,
}

#[derive(Serialize)]
struct RuleProperties {
    tags: [&'static str; 1],
    #[serde(skip_serializing_if = "Option::is_none")]
    fix: Option<FixSafety>,
}

/// A message (§3.11).
#[derive(Debug, Serialize)]
pub(super) struct Message {
    pub(super) text: String,
}

/// A file (§3.24).
#[derive(Debug, Serialize)]
pub(super) struct Artifact {
    pub(super) location: ArtifactLocation,
    pub(super) encoding: &'static str,
    pub(super) roles: [&'static str; 1],
}

/// The location of a file (§3.4).
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct ArtifactLocation {
    pub(super) uri: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) uri_base_id: Option<&'static str>,
    pub(super) index: usize,
}

/// How the run ended (§3.20).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Invocation<'a> {
    pub(super) execution_successful: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) exit_code: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) exit_code_description: Option<&'static str>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub(super) tool_execution_notifications: &'a [Notification],
}

/// A message about the tool itself (§3.58).
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Notification {
    pub(super) level: &'static str,
    pub(super) message: Message,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) associated_rule: Option<AssociatedRule>,
}

/// The rule that a notification is about (§3.52).
#[derive(Debug, Serialize)]
pub(super) struct AssociatedRule {
    pub(super) id: &'static str,
    pub(super) index: usize,
}

/// A finding (§3.27).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Result {
    pub(super) rule_id: &'static str,
    pub(super) rule_index: usize,
    pub(super) level: &'static str,
    pub(super) message: Message,
    pub(super) locations: Vec<Location>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) related_locations: Vec<Location>,
    pub(super) partial_fingerprints: BTreeMap<&'static str, Fingerprint>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) fixes: Vec<Fix>,
}

/// A place (§3.28).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Location {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) id: Option<usize>,
    pub(super) physical_location: PhysicalLocation,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) logical_locations: Vec<LogicalLocation>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) message: Option<Message>,
}

/// A place in a file (§3.29).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct PhysicalLocation {
    pub(super) artifact_location: ArtifactLocation,
    pub(super) region: Region,
}

/// A part of a text (§3.30), and of the bytes if the text is UTF-8.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Region {
    pub(super) start_line: u32,
    pub(super) start_column: u32,
    pub(super) end_line: u32,
    pub(super) end_column: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) byte_offset: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) byte_length: Option<u32>,
}

/// A place in the object dictionary (§3.33).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct LogicalLocation {
    pub(super) name: String,
    pub(super) fully_qualified_name: String,
    pub(super) kind: &'static str,
}

/// A fix (§3.55).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Fix {
    pub(super) description: Message,
    pub(super) artifact_changes: [ArtifactChange; 1],
    pub(super) properties: FixProperties,
}

#[derive(Serialize)]
pub(super) struct FixProperties {
    pub(super) safety: Applicability,
}

/// The edits of a file (§3.56).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct ArtifactChange {
    pub(super) artifact_location: ArtifactLocation,
    pub(super) replacements: Vec<Replacement>,
}

/// An edit (§3.57).
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Replacement {
    pub(super) deleted_region: Region,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) inserted_content: Option<Content>,
}

/// The inserted text of an edit (§3.3).
#[derive(Serialize)]
pub(super) struct Content {
    pub(super) text: String,
}

impl<'a> Run<'a> {
    /// The end of a run with these rules and files. `has_relative`: whether a path is relative to the source
    /// root.
    pub(super) fn new(
        rules: &[&'static RuleInfo],
        artifacts: &'a [Artifact],
        has_relative: bool,
        invocation: Invocation<'a>,
    ) -> Self {
        let version = env!("CARGO_PKG_VERSION");
        let rules = rules.iter().map(|rule| Rule::new(rule)).collect();
        let description = Message { text: "the folder that objdict was started in".to_owned() };
        let base = has_relative.then_some((SOURCE_ROOT, BaseFolder { description }));
        Self {
            driver: Driver {
                name: "objdict",
                version,
                semantic_version: version,
                information_uri: HOME,
                rules,
            },
            artifacts,
            bases: base.into_iter().collect(),
            invocation,
        }
    }

    /// Writes the properties after `results`.
    pub(super) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(b",\n\"tool\":{\"driver\":")?;
        objdict_model::json::write(&mut *out, &self.driver)?;
        out.write_all(b"},\n\"artifacts\":")?;
        objdict_model::json::write(&mut *out, self.artifacts)?;
        if !self.bases.is_empty() {
            out.write_all(b",\n\"originalUriBaseIds\":")?;
            objdict_model::json::write(&mut *out, &self.bases)?;
        }
        out.write_all(b",\n\"invocations\":[")?;
        objdict_model::json::write(&mut *out, &self.invocation)?;
        out.write_all(b"]")
    }
}

impl Rule {
    fn new(rule: &RuleInfo) -> Self {
        let page = rule.page();
        let markdown = page.split_once('\n').map_or("", |(_, body)| body).trim().to_owned();
        Self {
            id: rule.id,
            name: rule.name(),
            short_description: Message { text: rule.summary.to_owned() },
            full_description: Message { text: rule.checks.to_owned() },
            help: Help { text: plain(&markdown), markdown },
            help_uri: rule.address(),
            default_configuration: Configuration { level: level(rule.severity) },
            properties: RuleProperties { tags: [rule.group()], fix: rule.fix },
        }
    }
}

/// Markdown without the marks of headings and code blocks.
fn plain(markdown: &str) -> String {
    let lines = markdown.lines().filter(|line| !line.starts_with("```"));
    let lines: Vec<&str> = lines.map(|line| line.trim_start_matches("## ")).collect();
    lines.join("\n")
}

/// The meaning of an exit code.
pub(super) fn exit_code_description(code: u8) -> &'static str {
    match code {
        0 => "success",
        1 => "findings were reported",
        _ => "not every file could be checked",
    }
}
