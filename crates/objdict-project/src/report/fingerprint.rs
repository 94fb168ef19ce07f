//! Identity of a finding when the file is edited around it: baselines and CI services match findings with it.

use std::cell::OnceCell;
use std::collections::HashMap;

use serde::{Serialize, Serializer};

use super::Subject;
use objdict_eds::ini::{Document, LineKind};
use objdict_format::Description;
use objdict_model::diagnostic::{At, Diagnostic, Findings};
use objdict_model::model::{Field, ModulePart, Part, Place};
use objdict_model::source::{Fnv, Span};

/// The name and version of the method, for outputs that name their fingerprints. Changing the method requires a new
/// version; otherwise users of stored fingerprints would get all findings as new ones.
pub const FINGERPRINT_NAME: &str = "objdict/v2";

/// The maximum number of bytes of a line that are included. An XDD may consist of one line, and a distant
/// change does not change the finding.
const MAX_LINE: usize = 400;

/// The number of bytes on each side of a label that are included in a longer line.
const CONTEXT: usize = 80;

/// A hash of the subject of a finding, independent of its position: the rule, the place in the model, the values and
/// quotations in the message, and a number among equal ones. If the finding is about the text itself, the section and
/// the text of the line, without spaces, replace the place. Moving lines, renumbering list members, adding similar
/// places and rewording have no effect.
///
/// The name of the file is not included.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fingerprint(u64);

impl Fingerprint {
    /// The fingerprint of the `number`th finding that is equal otherwise, counted from 0.
    pub(super) fn repeated(self, number: u32) -> Self {
        if number == 0 {
            return self;
        }
        let mut hash = Fnv(self.0);
        hash.field(&number.to_be_bytes());
        Self(hash.0)
    }
}

// 16 hex digits.
objdict_model::messages! { Fingerprint: { Self(number) => "{number:016x}"; } }

impl std::str::FromStr for Fingerprint {
    type Err = std::num::ParseIntError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        u64::from_str_radix(text, 16).map(Self)
    }
}

impl Serialize for Fingerprint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(feature = "schema")]
objdict_model::inline_schemas! {
    Fingerprint: |_| schemars::json_schema!({ "type": "string", "pattern": "^[0-9a-f]{16}$" });
}

/// The fingerprint of a finding that has no equal before it; see [`fingerprints`].
pub fn fingerprint<'a>(subject: impl Into<Subject<'a>>, finding: &Diagnostic) -> Fingerprint {
    let subject = subject.into();
    base(subject, &Sections::default(), finding)
}

/// The fingerprints of findings, in their order. Equal ones are numbered, so pass all findings of a file, and
/// filter later.
pub fn fingerprints<'a, 's>(
    subject: impl Into<Subject<'s>>,
    findings: impl IntoIterator<Item = &'a Diagnostic>,
) -> Vec<Fingerprint> {
    let mut findings = findings.into_iter().peekable();
    if findings.peek().is_none() {
        return Vec::new();
    }
    let subject = subject.into();
    let sections = Sections::default();
    let mut seen: HashMap<Fingerprint, u32> = HashMap::new();
    findings
        .map(|finding| {
            let base = base(subject, &sections, finding);
            let number = seen.entry(base).or_default();
            let fingerprint = base.repeated(*number);
            *number = number.saturating_add(1);
            fingerprint
        })
        .collect()
}

/// The findings that a report lists, each with its fingerprint.
pub(super) fn listed<'a>(
    subject: Subject<'_>,
    findings: &'a Findings,
) -> impl Iterator<Item = (&'a Diagnostic, Fingerprint)> {
    let prints = fingerprints(subject, findings);
    let mut is_listed = findings.listed().peekable();
    findings
        .iter()
        .zip(prints)
        .filter(move |(finding, _)| is_listed.next_if(|listed| std::ptr::eq(*listed, *finding)).is_some())
}

fn base(subject: Subject<'_>, sections: &Sections, finding: &Diagnostic) -> Fingerprint {
    let mut hash = Fnv::new();
    hash.field(finding.rule.id.as_bytes());
    if let Some(number) = subject.description().map(Description::number).filter(|number| *number > 0) {
        hash.field(&(number as u64).to_be_bytes());
    }
    if let Some(label) = finding.labels.first() {
        match &label.at {
            At::Place(place) | At::Node(_, place) => at_place(subject, place, &mut hash),
            At::Span(span) | At::Patch(_, span) => at_line(subject, sections, *span, &mut hash),
        }
        hash.field(label.text.shown().as_bytes());
    }
    finding.message.each_value(&mut |value| hash.text(value));
    Fingerprint(hash.0)
}

/// The address; for a list member, its text, because members are renumbered when one is added or removed.
fn at_place(subject: Subject<'_>, place: &Place, hash: &mut Fnv) {
    let is_list = matches!(
        place.part,
        Part::List(_) | Part::Links(_) | Part::Module(_, ModulePart::FixedObjects | ModulePart::SubExtends)
    );
    let member =
        matches!(place.field, Some(Field::Item(_)) if is_list).then(|| subject.description()?.locate(place));
    match member.flatten() {
        Some(span) => {
            hash.field(place.part.to_string().as_bytes());
            hash.text(span.of(subject.source().text()));
        }
        None => hash.field(place.to_string().as_bytes()),
    }
}

/// The section and the line, or the text around the span of a long line.
fn at_line(subject: Subject<'_>, sections: &Sections, span: Span, hash: &mut Fnv) {
    let source = subject.source();
    let text = source.text();
    let line = source.lines().line_span(text, source.lines().line_of(text, span.start));
    hash.field(sections.at(subject, span.start).as_bytes());
    if line.len() as usize <= MAX_LINE {
        hash.text(line.of(text));
    } else {
        let from = (span.start as usize).saturating_sub(CONTEXT).max(line.start as usize);
        let to = (span.end as usize).min(span.start as usize + MAX_LINE).saturating_add(CONTEXT);
        let to = to.min(line.end as usize);
        let mut boundaries = (from..=to.max(from)).filter(|&at| text.is_char_boundary(at));
        let from = boundaries.next().unwrap_or(from);
        hash.text(text.get(from..boundaries.next_back().unwrap_or(from)).unwrap_or_default());
    }
}

/// The headers of an INI file, in order; empty for XML. Only findings about the text need them.
#[derive(Default)]
struct Sections(OnceCell<Vec<Span>>);

impl Sections {
    /// The name of the section at an offset.
    fn at<'s>(&self, subject: Subject<'s>, offset: u32) -> &'s str {
        let headers = self.0.get_or_init(|| {
            let document = subject.description().and_then(Description::document);
            let names = document.into_iter().flat_map(Document::headers).filter_map(|line| match line.kind {
                LineKind::Section { name } => Some(name),
                _ => None,
            });
            names.collect()
        });
        let behind = headers.partition_point(|name| name.start <= offset);
        behind.checked_sub(1).map_or("", |number| headers[number].of(subject.source().text()))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::source::SourceFile;

    const BROKEN: &str = include_str!("../../../../fixtures/broken/octal.eds");

    /// Rule, message and fingerprint of each finding.
    fn prints(text: &str) -> Vec<(&'static str, String, Fingerprint)> {
        let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
        let findings = crate::check(&description);
        let prints = fingerprints(&description, &findings);
        findings.iter().zip(prints).map(|(f, print)| (f.rule.id, f.message.to_string(), print)).collect()
    }

    #[test]
    fn moved_lines_and_blanks_change_nothing() {
        let text = BROKEN.replace("\r\n", "\n");
        let before = prints(&text);
        assert!(before.len() > 3, "{before:?}");
        let moved = text.replacen('[', ";\n;\n[", 1).replace("\n[", "\n\n[");
        assert_eq!(prints(&moved), before);
        let junk = |line: &str| prints(&format!("[Comments]\n{line}\n")).last().map(|(.., print)| *print);
        assert_eq!(junk("no key at all"), junk("  no key  at all "));
        assert_ne!(junk("no key at all"), junk("nor here"));
    }

    #[test]
    fn equal_findings_are_distinguished() {
        let text = "[2000]\njunk\njunk\n[2001]\njunk\n";
        let all = prints(text);
        let distinct: HashSet<Fingerprint> = all.iter().map(|(.., print)| *print).collect();
        assert_eq!(distinct.len(), all.len(), "{all:?}");
        let fewer = prints("[2000]\njunk\n[2001]\njunk\n");
        let gone = all.iter().filter(|item| !fewer.contains(item)).count();
        assert_eq!(gone, 1, "the rest are the same:\n{all:?}\n{fewer:?}");
    }

    #[test]
    fn a_place_and_what_is_there_tell_findings_apart() {
        let prints_of = |places: &[(&str, &str)]| {
            let object = |(index, access): &(&str, &str)| {
                format!("[{index}]\nParameterName=A\nObjectType=7\nDataType=5\nAccessType={access}\n")
            };
            let all = prints(&places.iter().map(object).collect::<String>());
            let all = all.into_iter().filter(|(rule, ..)| *rule == "cia306/invalid-value");
            all.map(|(.., print)| print).collect::<Vec<_>>()
        };
        let two = prints_of(&[("2000", "rq"), ("2001", "rq")]);
        let three = prints_of(&[("2000", "rq"), ("2001", "rq"), ("2002", "rq")]);
        assert_eq!(two.len(), 2);
        assert_eq!(three[..2], two, "a third place changes nothing at the others");
        let other = prints_of(&[("2000", "rq"), ("2001", "rz")]);
        assert_eq!(other[0], two[0]);
        assert_ne!(other[1], two[1], "another mistake at the same place");
    }

    #[test]
    fn list_members_are_known_by_their_text() {
        let list = |members: &str| {
            let text = format!("[OptionalObjects]\nSupportedObjects=2\n{members}\n[1000]\nParameterName=A\n");
            let all = prints(&text);
            let mut wanted = all.into_iter().filter(|(rule, ..)| *rule == "cia306/listed-object-missing");
            wanted.next().map(|(.., print)| print)
        };
        let first = list("1=0x1000\n2=0x3FFF");
        assert!(first.is_some());
        assert_eq!(first, list("1=0x3FFF\n2=0x1000"));
    }

    #[test]
    fn a_change_far_away_in_a_long_line_changes_nothing() {
        let print = |front: usize| {
            let text = format!("{}junk{}", "a".repeat(front), "b".repeat(2000));
            let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
            let at = Span::new(front as u32, front as u32 + 4);
            let finding = Diagnostic::new(crate::registry::rules()[0], at, "m");
            fingerprint(&description, &finding)
        };
        assert_eq!(print(1000), print(1500));
    }

    #[test]
    fn the_text_of_a_fingerprint_is_read_again() {
        let print = Fingerprint(0x12AB);
        assert_eq!(print.to_string(), "00000000000012ab");
        assert_eq!(print.to_string().parse(), Ok(print));
    }
}
