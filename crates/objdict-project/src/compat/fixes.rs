//! The fixes that depend on the selected tools: a change that helps one tool may harm another.
//!
//! Without tools, only fixes that harm no tool are safe. With tools, a fix is safe if it helps one of them and harms
//! none; a fix that harms one of them is not offered.

use super::reactions::{is_of_comments, is_of_one_byte, shown};
use objdict_eds::eds;
use objdict_eds::ini::{Line, LineKind};
use objdict_format::Description;
use objdict_model::diagnostic::{Applicability, Change, Diagnostic, Fix, Tool, say};
use objdict_model::model::{Device, Field, Part};
use objdict_model::source::Span;

/// A section with more lines is not changed.
const MAX_LINES: usize = 1000;

use Tool::{CanOpenEditor, DcfTools, NodeCanopen, PythonCanopen};

/// The existing fixes of a rule, which are safe for the first tools and harm the others.
struct FixChoice {
    rule: &'static str,
    better: &'static [Tool],
    worse: &'static [Tool],
    /// Whether the fix can be safe for this finding.
    when: fn(&Description, &Diagnostic) -> bool,
}

const fn choice(rule: &'static str, better: &'static [Tool], worse: &'static [Tool]) -> FixChoice {
    FixChoice { rule, better, worse, when: |_, _| true }
}

const CHOICES: [FixChoice; 11] = [
    FixChoice {
        // without its header, a section would be read as part of the previous one
        when: |description, finding| {
            let line = shown(description, finding);
            line.contains('[') || !line.contains(']')
        },
        ..choice("cia306/junk-line", &[DcfTools, PythonCanopen, CanOpenEditor], &[])
    },
    choice("cia306/limit-above-type", &[DcfTools, PythonCanopen], &[]),
    // all other readers of lists ignore the missing objects, which have no entries
    choice("cia306/listed-object-missing", &[DcfTools], &[]),
    FixChoice {
        // other misspelt keys may belong to a value
        when: |description, finding| shown(description, finding).contains(' '),
        ..choice("cia306/misspelt-key", &[DcfTools], &[])
    },
    FixChoice {
        // a fix that keeps `SubNumber` adds the counted sub-indexes
        when: |_, finding| finding.fix.as_ref().is_some_and(|fix| fix.changes.len() == 1),
        ..choice("cia306/missing-sub-0", &[DcfTools], &[])
    },
    choice("cia306/nested-structure", &[NodeCanopen], &[]),
    FixChoice {
        when: |description, _| is_refused_for_its_letters(description),
        ..choice("cia306/not-ascii", &[DcfTools, PythonCanopen, CanOpenEditor, NodeCanopen], &[])
    },
    choice("cia306/quoted-string", &[CanOpenEditor, PythonCanopen], &[DcfTools]),
    choice("cia306/real-as-bits", &[PythonCanopen, NodeCanopen], &[DcfTools]),
    choice("cia306/sub-number-mismatch", &[DcfTools], &[]),
    choice("portability/real-as-decimal", &[DcfTools], &[PythonCanopen, NodeCanopen]),
];

/// The finding with its fix adapted to the tools; `None` if it is already suitable.
pub(super) fn choose(
    mut finding: Diagnostic,
    description: &Description,
    tools: &[Tool],
) -> Option<Diagnostic> {
    let has = |of: &[Tool]| of.iter().any(|tool| tools.contains(tool));
    // the bits of a REAL are the only spelling that dcf-tools reads, so only its users need this
    if finding.rule.id == "cia306/real-as-bits" && !has(&[PythonCanopen, NodeCanopen]) {
        if has(&[DcfTools]) {
            return None;
        }
        finding.fix = None;
    }
    if let Some(choice) = CHOICES.iter().find(|choice| choice.rule == finding.rule.id) {
        let is_safe = has(choice.better) && (choice.when)(description, &finding);
        if has(choice.worse) {
            finding.fix = None;
        } else if let Some(fix) = finding.fix.as_mut().filter(|_| is_safe) {
            fix.safety = Applicability::Safe;
        }
    }
    // unread but possibly intended content is kept as a comment
    let is_unsafe = finding.fix.as_ref().is_some_and(|fix| fix.safety != Applicability::Safe);
    if is_unsafe && is_unread(&finding, tools) {
        finding.fix = comment_unread(&finding, description);
    }
    if finding.fix.is_none() {
        finding.fix = match finding.rule.id {
            "cia306/key-before-section" if has(&[DcfTools, PythonCanopen]) => comment_stray_keys(description),
            "cia306/unknown-key" if has(&[DcfTools]) => {
                comment_key(&finding, description, has(&[PythonCanopen, CanOpenEditor]))
            }
            "cia306/unknown-section" if has(&[DcfTools]) => comment_unknown_section(&finding, description),
            "cia306/missing-section" if has(&[CanOpenEditor]) => add_section(&finding, description.device()),
            _ => None,
        };
    }
    Some(finding)
}

/// Whether tools reject or misread the encoding although all values of the device are in ISO 646.
fn is_refused_for_its_letters(description: &Description) -> bool {
    let has_value = |line: Line, text: &str| match line.kind {
        LineKind::Entry { key, .. } => {
            let key = key.of(text).to_ascii_lowercase();
            let names = ["value", "file", "filename", "lasteds"];
            key.bytes().all(|byte| byte.is_ascii_digit()) || names.iter().any(|name| key.ends_with(name))
        }
        _ => false,
    };
    is_of_one_byte(description)
        && description.document().is_some_and(|document| {
            let text = document.text();
            !document.lines().any(|line| !line.span.of(text).is_ascii() && has_value(line, text))
        })
}

/// Whether other tools read a key beyond the standard.
fn is_read_by_others(name: &str) -> bool {
    let is = |key: &str| name.eq_ignore_ascii_case(key);
    is("StorageLocation") || is("TPDODetectCos") || eds::is_meaning_key(name)
}

/// Comments out a key that the standard does not define; `is_needed` returns whether one of the tools is among those
/// that read some of them.
fn comment_key(finding: &Diagnostic, description: &Description, is_needed: bool) -> Option<Fix> {
    let name = shown(description, finding);
    // a key of a different section may be one that the tool reads there
    if eds::is_key(name) || is_of_comments(description, finding) {
        return None;
    }
    if is_needed && is_read_by_others(name) {
        return None;
    }
    let fix = Fix::safe(say!("comment out `{}`", name));
    comment_line(fix, start_of(finding, description)?, description)
}

/// Comments out the keys before the first section, which belong to no part of the device.
fn comment_stray_keys(description: &Description) -> Option<Fix> {
    let is_header = |line: &Line| matches!(line.kind, LineKind::Section { .. });
    let stray = description.document()?.lines().take_while(|line| !is_header(line));
    let keys: Vec<Line> = stray.filter(|line| matches!(line.kind, LineKind::Entry { .. })).collect();
    let fix = Fix::safe("comment out the keys before the first section");
    let fix = keys.iter().fold(fix, |fix, key| fix.with(Change::CommentOut(key.span)));
    (keys.len() <= MAX_LINES).then_some(fix)
}

/// Comments out the lines of a section that the standard does not define.
fn comment_unknown_section(finding: &Diagnostic, description: &Description) -> Option<Fix> {
    let name = shown(description, finding);
    if name.eq_ignore_ascii_case("TypeDefinitions") {
        return None;
    }
    let fix = Fix::safe(say!("comment out the lines of `[{}]`", name));
    comment_section(fix, start_of(finding, description)?, description)
}

/// Whether a finding is about a line that is unread according to the standard but rejected by a tool.
fn is_unread(finding: &Diagnostic, tools: &[Tool]) -> bool {
    let is_compact = finding.message.names(&Field::CompactSubObj);
    finding.rule.id == "cia306/unsupported-key" && is_compact && tools.contains(&NodeCanopen)
}

/// Comments out a line that is not read.
fn comment_unread(finding: &Diagnostic, description: &Description) -> Option<Fix> {
    let start = start_of(finding, description)?;
    let line = description.document()?.line_at(start)?;
    let setting = line.span.of(description.source().text()).trim();
    comment_line(Fix::safe(say!("comment out `{}`", setting)), start, description)
}

fn comment_line(fix: Fix, start: u32, description: &Description) -> Option<Fix> {
    let line = description.document()?.line_at(start)?;
    Some(fix.replace(Span::empty(line.span.start), "; "))
}

fn comment_section(fix: Fix, start: u32, description: &Description) -> Option<Fix> {
    let document = description.document()?;
    let header = document.line_at(start)?.span.start;
    let section = document.section_at(header)?;
    if section.entries.len() > MAX_LINES {
        return None;
    }
    let starts = std::iter::once(header).chain(section.entries.iter().map(|entry| entry.key.start));
    let lines = starts.filter_map(|start| document.line_at(start));
    Some(lines.fold(fix, |fix, line| fix.replace(Span::empty(line.span.start), "; ")))
}

/// Adds a section that CANopenEditor cannot do without.
fn add_section(finding: &Diagnostic, device: &Device) -> Option<Fix> {
    let is_missing = |part: Part| finding.message.names_part(|named| *named == part);
    let count = |range: std::ops::RangeInclusive<u16>| device.objects.range(range).count().to_string();
    let change = if is_missing(Part::FileInfo) {
        Change::Add(Part::FileInfo, vec![(Field::EdsVersion, "4.0".to_owned())])
    } else if is_missing(Part::DeviceInfo) {
        let rpdos = (Field::NrOfRxPdo, count(0x1400..=0x15FF));
        Change::Add(Part::DeviceInfo, vec![rpdos, (Field::NrOfTxPdo, count(0x1800..=0x19FF))])
    } else {
        return None;
    };
    Some(Fix::safe(say!("add the {section} with the known values")).with(change))
}

fn start_of(finding: &Diagnostic, description: &Description) -> Option<u32> {
    Some(description.span_of(&finding.labels.first()?.at).start)
}
