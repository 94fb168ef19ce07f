//! `check --vendor-report`: a page for the vendor of a description, who has not heard of objdict.

use std::collections::BTreeMap;
use std::path::Path;

use super::ending::Failure;
use super::written_files::save;
use objdict_format::Description;
use objdict_format::patch::make;
use objdict_lint::{Options, PORTABILITY};
use objdict_model::diagnostic::{Applicability, Diagnostic, Severity, Tool, counted, printable_lines};
use objdict_project::compat::{Effect, REACTIONS};
use objdict_project::report::{Location, Subject, grouped};

/// So many problems are explained.
const MAX_PROBLEMS: usize = 10;

/// The pages of the descriptions of a run.
#[derive(Default)]
pub(super) struct VendorReport {
    text: String,
}

impl VendorReport {
    /// Adds the page of a description.
    pub(super) fn add(&mut self, description: &Description, options: &Options) {
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        self.text.push_str(&page(description, options));
    }

    /// Writes the pages.
    pub(super) fn write(&self, path: &Path) -> Result<(), Failure> {
        save(path, self.text.as_bytes()).map(|_| ())
    }
}

fn page(patched: &Description, options: &Options) -> String {
    // the vendor has the file without the patches
    let original = patched.patched().and_then(|_| patched.with_bytes(patched.print()));
    let description = original.as_ref().unwrap_or(patched);
    let subject = Subject::from(description);
    let all = Options { tools: Tool::ALL.to_vec(), ..options.clone() };
    let is_portability = |finding: &Diagnostic| finding.rule.group() == PORTABILITY;
    let mut findings =
        objdict_project::check_with(description, &Options { tools: Vec::new(), ..options.clone() });
    let of_tools = objdict_project::check_with(description, &all);
    findings.append(of_tools.filter_map(|finding| is_portability(&finding).then_some(finding)));
    let findings = grouped(subject, findings);
    let mut problems: Vec<(Option<Effect>, &Diagnostic)> =
        findings.iter().map(|finding| (worst(description, finding), finding)).collect();
    let rank = |effect: Option<Effect>| effect.map_or(0, |effect| u8::from(effect == Effect::Refused) + 1);
    // what the standards say comes before what tools do
    problems.sort_by_key(|(effect, finding)| {
        std::cmp::Reverse((finding.severity, !is_portability(finding), rank(*effect)))
    });
    problems.retain(|(effect, finding)| finding.severity >= Severity::Warning || effect.is_some());
    let of_standards = findings.iter().filter(|finding| !is_portability(finding));
    let mut text = head(description, of_standards, problems.is_empty());
    for (number, (_, finding)) in (1..).zip(problems.iter().take(MAX_PROBLEMS)) {
        problem(&mut text, subject, description, finding, number);
    }
    if problems.len() > MAX_PROBLEMS {
        let rest = problems.len() - MAX_PROBLEMS;
        text.push_str(&format!(
            "{} not shown here; `objdict check --all` lists them.\n\n",
            counted(rest, "further problem is", "further problems are")
        ));
    }
    corrections(&mut text, patched, &all);
    text
}

/// What the page is about.
fn head<'f>(
    description: &Description,
    findings: impl Iterator<Item = &'f Diagnostic>,
    is_empty: bool,
) -> String {
    let device = description.device();
    let info = device.device_info.as_ref();
    let name = description.source().name().rsplit(['/', '\\']).next().unwrap_or_default();
    let mut text = format!("# Problems in `{}`\n\n", quoted(name));
    let identity = device.identity();
    let number = |number: Option<u32>| number.map(|number| format!("0x{number:08X}"));
    let facts = [
        ("Vendor", info.and_then(|info| info.vendor_name.clone())),
        ("Product", info.and_then(|info| info.product_name.clone())),
        ("Vendor-ID", number(identity.vendor_id.or(info.and_then(|info| info.vendor_number)))),
        ("Product code", number(identity.product_code.or(info.and_then(|info| info.product_number)))),
        ("Revision number", number(identity.revision_number.or(info.and_then(|info| info.revision_number)))),
    ];
    for (what, fact) in facts {
        if let Some(fact) = fact {
            text.push_str(&format!("- {what}: {}\n", quoted(&fact)));
        }
    }
    let (mut errors, mut warnings) = (0, 0);
    for finding in findings {
        errors += usize::from(finding.severity == Severity::Error);
        warnings += usize::from(finding.severity == Severity::Warning);
    }
    text.push_str(&format!(
        "\nThe file was checked against the CiA documents with objdict {}: {}, {}.{}\n\n",
        env!("CARGO_PKG_VERSION"),
        counted(errors, "error", "errors"),
        counted(warnings, "warning", "warnings"),
        if is_empty { "" } else { " The most important problems:" },
    ));
    text
}

fn problem(
    text: &mut String,
    subject: Subject<'_>,
    description: &Description,
    finding: &Diagnostic,
    number: usize,
) {
    let line = Location::start_of(subject, finding).line;
    let message = quoted(&finding.message.to_string());
    text.push_str(&format!("## {number}. {message}\n\nLine {line}, {}", finding.severity));
    if finding.also.len() > 1 {
        text.push_str(&format!(", at {} places", finding.also.len() + 1));
    }
    text.push_str(&format!(". {}\n", finding.rule.why));
    if let Some(help) = &finding.help {
        text.push_str(&format!("\nCorrection: {}.\n", quoted(&help.to_string())));
    }
    if finding.rule.group() != PORTABILITY {
        let mut tools: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for reaction in REACTIONS.iter().filter(|reaction| concerns(description, finding, reaction)) {
            tools.entry(reaction.what).or_default().extend(reaction.tools.iter().map(|tool| tool.name()));
        }
        if !tools.is_empty() {
            text.push('\n');
        }
        for (what, names) in tools {
            text.push_str(&format!("- {}: {what}\n", names.join(", ")));
        }
    }
    text.push_str(&format!("\nSource: {}\n\n", finding.rule.source));
}

fn concerns(
    description: &Description,
    finding: &Diagnostic,
    reaction: &objdict_project::compat::Reaction,
) -> bool {
    reaction.rule == finding.rule.id && reaction.when.is_none_or(|when| (when.holds)(description, finding))
}

/// The most severe effect of a finding on a tool.
fn worst(description: &Description, finding: &Diagnostic) -> Option<Effect> {
    let reactions = REACTIONS.iter().filter(|reaction| concerns(description, finding, reaction));
    reactions
        .map(|reaction| reaction.effect)
        .max_by_key(|effect| (effect.severity(), *effect == Effect::Refused))
}

/// The patches that were made, else one with what objdict can correct without review.
fn corrections(text: &mut String, description: &Description, options: &Options) {
    let mut patches: Vec<String> = Vec::new();
    for (patch, _) in description.patched().iter().flat_map(|patched| patched.by_patch()) {
        patches.push(patch.source().text().to_owned());
    }
    if patches.is_empty()
        && let Some(original) = description.with_bytes(description.print())
    {
        let check = |description: &Description| objdict_project::check_with(description, options);
        let fixed = objdict_project::fix(original, Applicability::Safe, check);
        let patch = make(description.device(), fixed.description.device());
        patches.extend(Some(patch).filter(|patch| patch.contains("[[")));
    }
    for patch in patches {
        text.push_str("## Corrections\n\nEach change gives the address, the value in the file and the correct value. Apply them with `objdict patch apply`.\n\n");
        let fence = "`".repeat(patch.split(|c| c != '`').map(str::len).max().unwrap_or(0).max(2) + 1);
        text.push_str(&format!("{fence}toml\n{}\n{fence}\n", printable_lines(patch.trim_end())));
    }
}

/// A text of the file in Markdown: on one line, and without marks but the backticks of messages.
fn quoted(text: &str) -> String {
    objdict_model::diagnostic::one_line(text).replace('<', "&lt;")
}
