//! Which findings another one explains, so that a report says the cause alone.

use super::Subject;
use crate::diagnostic::{At, Diagnostic, Reach, Severity, Text};
use crate::format::eds;
use crate::model::{Field, ObjectList};
use crate::source::Span;

/// The findings without those that others among them explain.
pub(super) fn without_consequences(subject: Subject<'_>, findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let places = Places::new(subject, &findings);
    let located = || findings.iter().zip(&places.spans).filter(|(finding, _)| !finding.labels.is_empty());
    let mut explained: Vec<(&[&str], Severity, Extent<'_>)> = Vec::new();
    for (finding, span) in located() {
        let extents = finding.rule.explains.iter();
        explained.extend(extents.filter_map(|one| {
            Some((one.rules, finding.severity, places.extent(one.reach, finding, *span)?))
        }));
    }
    let is_explained = |(finding, span): (&Diagnostic, &Span)| {
        let section = places.section(*span);
        // a cause of a lower severity would change what fails a run
        let is_it = |(rules, severity, extent): &(&[&str], Severity, Extent<'_>)| {
            rules.contains(&finding.rule.name())
                && finding.severity <= *severity
                && extent.covers(finding, places.text, *span, section)
        };
        !finding.labels.is_empty() && explained.iter().any(is_it)
    };
    let is_explained: Vec<bool> = findings.iter().zip(&places.spans).map(is_explained).collect();
    let mut is_explained = is_explained.into_iter();
    findings.into_iter().filter(|_| !is_explained.next().unwrap_or_default()).collect()
}

/// What one cause explains. It is made once for each cause, because a file may have many of them.
enum Extent<'a> {
    All,
    /// What has this offset in it.
    At(u32),
    /// What starts behind the first offset, and not behind the second.
    Behind(u32, u32),
    Section(usize),
    Object(u16),
    /// What shows a key of a section that the text names.
    Keys(&'a Text),
    /// As [`Self::Behind`], and what names the object or section.
    Header(u32, u32, Option<u16>, String),
}

impl Extent<'_> {
    /// An object, and what names it.
    fn named(index: u16) -> Self {
        Self::Header(0, 0, Some(index), format!("{index:04X}h"))
    }

    fn covers(&self, finding: &Diagnostic, text: &str, span: Span, section: usize) -> bool {
        match self {
            Self::All => true,
            Self::At(offset) => (span.start..=span.end).contains(offset),
            Self::Behind(start, end) => span.start > *start && span.start <= *end,
            Self::Section(number) => *number == section,
            Self::Object(index) => index_of(finding) == Some(*index),
            Self::Keys(message) => {
                let key = Field::from_name(span.of(text));
                message.names_part(|part| eds::is_key_of(part, &key))
            }
            Self::Header(start, end, index, name) => {
                (span.start > *start && span.start <= *end)
                    || index.is_some() && index_of(finding) == *index
                    || finding.message.to_string().contains(name)
            }
        }
    }
}

/// Where the findings are, and what in the text limits the scopes.
struct Places<'a> {
    text: &'a str,
    has_no_objects: bool,
    spans: Vec<Span>,
    /// Where the headers of sections start.
    headers: Vec<u32>,
    /// The only object that is listed or has sub-indexes, and has no section of its own.
    lost: Option<u16>,
    /// The objects that are not listed.
    unlisted: Vec<u16>,
    /// Where the last marks of merge conflicts start.
    conflict_ends: Vec<u32>,
}

impl<'a> Places<'a> {
    fn new(subject: Subject<'a>, findings: &[Diagnostic]) -> Self {
        let text = subject.source().text();
        let starts =
            |mark: &str| text.match_indices(mark).filter_map(|(at, _)| u32::try_from(at).ok()).collect();
        let span = |finding: &Diagnostic| {
            finding.labels.first().map_or(Span::empty(0), |label| subject.span_of(&label.at))
        };
        Self {
            text,
            has_no_objects: subject.description().is_some_and(|read| read.device().objects.is_empty()),
            spans: findings.iter().map(span).collect(),
            headers: starts("\n["),
            lost: only(findings.iter().filter_map(lost_object)),
            unlisted: of_rule(findings, "object-not-listed").filter_map(index_of).collect(),
            conflict_ends: starts("\n>>>>>>>"),
        }
    }

    /// The number of the section that a span starts in.
    fn section(&self, span: Span) -> usize {
        self.headers.partition_point(|&header| header < span.start)
    }

    fn extent<'b>(&self, reach: Reach, finding: &'b Diagnostic, cause: Span) -> Option<Extent<'b>> {
        let line = || line(self.text, cause.start);
        match reach {
            Reach::File => Some(Extent::All),
            Reach::NoObjects => self.has_no_objects.then_some(Extent::All),
            Reach::Around => Some(Extent::At(cause.start)),
            Reach::Section => Some(Extent::Section(self.section(cause))),
            Reach::Object => match (index_of(finding), self.index_of_section(cause)) {
                (Some(index), _) => Some(Extent::Object(index)),
                (None, Some(index)) => Some(Extent::named(index)),
                (None, None) => self.object_of(cause),
            },
            Reach::Keys => Some(Extent::Keys(&finding.message)),
            Reach::Lost => self.lost.map(Extent::named),
            Reach::List => {
                let name = self.header_above(cause)?;
                let list = ObjectList::ALL.into_iter().find(|list| list.name().eq_ignore_ascii_case(name));
                let unlisted = self.unlisted.iter().copied();
                only(unlisted.filter(|&index| ObjectList::of(index) == list)).map(Extent::Object)
            }
            Reach::Value => value_of(line()).map(Extent::Object),
            Reach::Conflict if line().starts_with("<<<<<<<") => {
                let next = self.conflict_ends.partition_point(|&end| end < cause.start);
                self.conflict_ends.get(next).map(|&end| Extent::Behind(cause.start, end))
            }
            Reach::Header if line().trim_end().ends_with(']') => {
                let name = line().trim_matches(|c: char| !c.is_ascii_alphanumeric());
                let name = name.rsplit('[').next().unwrap_or_default();
                let index = name.get(..4).and_then(|index| u16::from_str_radix(index, 16).ok());
                let end = self.headers.get(self.section(cause)).map_or(u32::MAX, |&next| next);
                let name = index.map_or(name.to_owned(), |index| format!("{index:04X}h"));
                (name.len() > 3).then_some(Extent::Header(cause.start, end, index, name))
            }
            Reach::Conflict | Reach::Header => None,
        }
    }

    /// The name in the header above a place; `None` in an XDD.
    fn header_above(&self, cause: Span) -> Option<&str> {
        let header = *self.headers.get(self.section(cause).checked_sub(1)?)?;
        line(self.text, header + 1).strip_prefix('[')?.split(']').next().map(str::trim)
    }

    fn index_of_section(&self, cause: Span) -> Option<u16> {
        u16::from_str_radix(self.header_above(cause)?.get(..4)?, 16).ok()
    }

    fn object_of(&self, cause: Span) -> Option<Extent<'static>> {
        let (before, behind) = self.text.split_at_checked(cause.start as usize)?;
        let (start, end) = (before.rfind("CANopenObject ")?, behind.find("CANopenObject>")?);
        let end = u32::try_from(end).ok()?.checked_add(cause.start)?;
        Some(Extent::Behind(u32::try_from(start).ok()?, end))
    }
}

/// The number at the end of a line.
fn value_of(line: &str) -> Option<u16> {
    let from = line.rfind(['x', 'X', '='])?;
    u16::from_str_radix(line.get(from + 1..)?.trim(), 16).ok()
}

/// The text of a line from an offset.
fn line(text: &str, offset: u32) -> &str {
    text.get(offset as usize..).and_then(|rest| rest.lines().next()).unwrap_or_default()
}

fn of_rule<'a>(findings: &'a [Diagnostic], name: &'a str) -> impl Iterator<Item = &'a Diagnostic> {
    findings.iter().filter(move |finding| finding.rule.name() == name)
}

/// The object whose section a finding misses.
fn lost_object(finding: &Diagnostic) -> Option<u16> {
    match finding.rule.id {
        "cia306/sub-without-object" => index_of(finding),
        "cia306/listed-object-missing" => {
            let message = finding.message.shown();
            u16::from_str_radix(message.get(..4)?, 16).ok()
        }
        _ => None,
    }
}

/// What all items are; `None` where they differ, or are none.
fn only(mut items: impl Iterator<Item = u16>) -> Option<u16> {
    let first = items.next()?;
    items.all(|item| item == first).then_some(first)
}

fn index_of(finding: &Diagnostic) -> Option<u16> {
    match &finding.labels.first()?.at {
        At::Place(place) => place.part.object(),
        At::Span(_) | At::Node(..) => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::diagnostic::Explained;
    use crate::format::{self, Format};
    use crate::report::grouped;
    use crate::source::SourceFile;

    const EDS: &str = include_str!("../../fixtures/eds/io-401.eds");
    const XDD: &str = include_str!("../../fixtures/xdd/io-401.xdd");

    /// The rules of what a report shows of a text.
    fn shown(name: &str, text: &str, format: Format) -> Vec<&'static str> {
        let description = format::read(SourceFile::from_text(name, text), format);
        let findings = grouped(&description, crate::check(&description));
        findings.iter().map(|finding| finding.rule.id).collect()
    }

    #[test]
    fn every_rule_is_one() {
        let rules = crate::registry::rules();
        let is_rule = |name: &&str| rules.iter().any(|rule| rule.name() == *name);
        for Explained { rules, .. } in rules.iter().flat_map(|rule| rule.explains) {
            assert!(rules.iter().all(is_rule), "{rules:?}");
        }
    }

    #[test]
    fn one_mistake_is_one_finding() {
        let eds = EDS.replace("\r\n", "\n");
        let conflict = "<<<<<<< HEAD\nProductName=A\n=======\nProductName=B\n>>>>>>> other\n";
        let (start, rest) = eds.split_once("ProductName=").unwrap();
        let conflict = format!("{start}{conflict}{}", rest.split_once('\n').unwrap().1);
        for (text, rule) in [
            (eds.replacen("\n3=0x1018\n", "\n2=0x1018\n", 1), "cia306/duplicate-key"),
            (eds.replacen("[FileInfo]", "50[FileInfo]", 1), "cia306/junk-line"),
            (eds.replacen("[1003sub2]", "1003sub2]", 1), "cia306/junk-line"),
            (eds.replacen("[1008]", "50[1008]", 1), "cia306/junk-line"),
            (eds.replacen("[1003sub2]\n", "", 1), "cia306/missing-header"),
            (eds.replacen("[1008]\n", "", 1), "cia306/missing-header"),
            (eds.replacen("\n2=0x1001\n", "\n", 1), "cia306/list-numbering"),
            (eds.replacen("\n3=0x1018\n", "\n", 1), "cia306/wrong-count"),
            (eds.replacen("ObjectType=0x7\n", "ObjectType 0x7\n", 1), "cia306/junk-line"),
            (eds.replacen("AccessType=ro\n", "AccessType ro\n", 1), "cia306/junk-line"),
            (eds.replacen("\n5=0x1010\n", "\n5 0x1010\n", 1), "cia306/junk-line"),
            (conflict, "cia306/junk-line"),
        ] {
            assert_eq!(shown("io-401.eds", &text, Format::Eds), [rule], "{text}");
        }
    }

    /// A cause is looked at once, not for each finding that it may explain.
    #[test]
    fn many_conflicts_do_not_take_long() {
        let conflicts: String =
            (0..1200).map(|number| format!("<<<<<<< {number}\n") + &"x=1\n".repeat(100)).collect();
        let text = format!("[FileInfo]\n{conflicts}");
        assert!(shown("a.eds", &text, Format::Eds).contains(&"cia306/junk-line"));
    }

    /// The keys of a section without its header are not each a finding; those of others are.
    #[test]
    fn a_missing_section_explains_its_own_keys() {
        let eds = EDS.replace("\r\n", "\n").replacen("[1001]\n", "[1001]\nUnit=V\n", 1);
        for section in ["DeviceInfo", "DummyUsage", "OptionalObjects"] {
            let text = eds.replacen(&format!("[{section}]\n"), "", 1);
            let rules = shown("io-401.eds", &text, Format::Eds);
            assert_eq!(rules, ["cia306/missing-section", "cia306/unknown-key"], "{section}");
        }
    }

    #[test]
    fn an_element_without_its_end_is_the_cause_of_the_rest() {
        let text = XDD.replacen("</q1:DeviceIdentity>", "", 1);
        let rules = shown("io-401.xdd", &text, Format::Xdd);
        assert!(rules.contains(&"xml/unclosed-element") && rules.len() < 4, "{rules:?}");
        let text = XDD.replacen("<q2:CANopenObjectList>", "", 1);
        let rules = shown("io-401.xdd", &text, Format::Xdd);
        assert!(rules.contains(&"xml/stray-end-tag") && rules.len() < 3, "{rules:?}");
        let start = XDD.rfind("<ISO15745Profile>").unwrap();
        let end = XDD.rfind("</ISO15745Profile>").unwrap() + "</ISO15745Profile>".len();
        let text = [&XDD[..start], &XDD[end..]].concat();
        assert_eq!(shown("io-401.xdd", &text, Format::Xdd), ["cia311/missing-profile"]);
        let text = XDD.replacen("uniqueIDRef=\"UID_OBJ_1000\"", "uniqueIDRef=\"UID_0\"", 1);
        let rules = shown("io-401.xdd", &text, Format::Xdd);
        assert!(rules.contains(&"cia311/dangling-unique-id-ref"), "{rules:?}");
        assert!(!rules.contains(&"cia306/missing-key"), "{rules:?}");
    }
}
