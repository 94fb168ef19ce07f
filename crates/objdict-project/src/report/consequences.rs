//! The findings that other findings explain, so that a report only contains the cause.
//!
//! Only findings of no higher severity are omitted, so the exit code never changes.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::Subject;
use objdict_eds::eds;
use objdict_model::diagnostic::{At, Diagnostic, Reach, Severity, Text};
use objdict_model::model::{Field, ObjectList};
use objdict_model::source::Span;

/// The findings without those that others among them explain.
pub(super) fn without_consequences(subject: Subject<'_>, findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    if findings.iter().all(|finding| finding.rule.explains.is_empty()) {
        return findings;
    }
    let places = Places::new(subject, &findings);
    let is_explained = places.explained(&findings);
    let mut is_explained = is_explained.into_iter();
    findings.into_iter().filter(|_| !is_explained.next().unwrap_or_default()).collect()
}

/// The scope of a cause.
enum CauseExtent<'a> {
    All,
    /// Findings that contain this offset.
    At(u32),
    /// Findings that start after the first offset, and not after the second.
    Behind(u32, u32),
    Section(usize),
    Object(u16),
    /// Findings that show a key of the section in the text.
    Keys(&'a Text),
    /// Like [`Self::Behind`], and findings that name the object or section.
    Header(u32, u32, Option<u16>, String),
}

impl CauseExtent<'_> {
    /// An object, and findings that name it.
    fn named(index: u16) -> Self {
        Self::Header(0, 0, Some(index), format!("{index:04X}h"))
    }
}

/// The combined scope of all causes of one rule and severity, so that a finding is not compared with each of
/// them.
#[derive(Default)]
struct CauseScope<'a> {
    is_all: bool,
    /// Sorted by [`Self::sort`].
    offsets: Vec<u32>,
    /// Like [`CauseExtent::Behind`]; [`Self::sort`] extends each end to the farthest one so far.
    ranges: Vec<(u32, u32)>,
    sections: HashSet<usize>,
    objects: HashSet<u16>,
    /// Texts that name the sections of the affected keys; there are no more than such sections.
    keys: Vec<&'a Text>,
    /// The names in messages, by length.
    names: BTreeMap<usize, HashSet<Vec<u8>>>,
}

impl<'a> CauseScope<'a> {
    fn add(&mut self, extent: &CauseExtent<'a>) {
        match extent {
            CauseExtent::All => self.is_all = true,
            CauseExtent::At(offset) => self.offsets.push(*offset),
            CauseExtent::Behind(start, end) => self.ranges.push((*start, *end)),
            CauseExtent::Section(number) => drop(self.sections.insert(*number)),
            CauseExtent::Object(index) => drop(self.objects.insert(*index)),
            CauseExtent::Keys(message) => self.keys.push(message),
            CauseExtent::Header(start, end, index, name) => {
                self.ranges.push((*start, *end));
                self.objects.extend(index);
                self.names.entry(name.len()).or_default().insert(name.clone().into_bytes());
            }
        }
    }

    fn sort(&mut self) {
        self.offsets.sort_unstable();
        self.ranges.sort_unstable();
        let mut farthest = 0;
        for (_, end) in &mut self.ranges {
            farthest = farthest.max(*end);
            *end = farthest;
        }
    }

    fn covers(&self, finding: &Diagnostic, text: &str, span: Span, section: usize) -> bool {
        let has_offset = || {
            let first = self.offsets.partition_point(|&offset| offset < span.start);
            self.offsets.get(first).is_some_and(|&offset| offset <= span.end)
        };
        let is_in_range = || {
            let before = self.ranges.partition_point(|&(start, _)| start < span.start);
            before.checked_sub(1).is_some_and(|last| span.start <= self.ranges[last].1)
        };
        let is_key = || {
            let key = Field::from_name(span.of(text));
            self.keys.iter().any(|message| message.names_part(|part| eds::is_key_of(part, &key)))
        };
        let is_named = || {
            let message = finding.message.shown();
            let is_in = |(length, names): (&usize, &HashSet<Vec<u8>>)| {
                message.as_bytes().windows(*length).any(|part| names.contains(part))
            };
            self.names.iter().any(is_in)
        };
        self.is_all
            || has_offset()
            || is_in_range()
            || self.sections.contains(&section)
            || index_of(finding).is_some_and(|index| self.objects.contains(&index))
            || !self.keys.is_empty() && is_key()
            || !self.names.is_empty() && is_named()
    }
}

/// The positions of the findings, and the limits of scopes in the text.
struct Places<'a> {
    text: &'a str,
    has_no_objects: bool,
    spans: Vec<Span>,
    /// The starts of section headers.
    headers: Vec<u32>,
    /// The only object that is listed or has sub-indexes but lacks its own section.
    lost: Option<u16>,
    /// The only object that belongs in a list, or in none, and is not listed.
    unlisted: HashMap<Option<ObjectList>, Option<u16>>,
    /// The starts and ends of object tags in an XDD.
    object_tags: [Vec<u32>; 2],
}

impl<'a> Places<'a> {
    fn new(subject: Subject<'a>, findings: &[Diagnostic]) -> Self {
        let text = subject.source().text();
        let starts =
            |mark: &str| text.match_indices(mark).filter_map(|(at, _)| u32::try_from(at).ok()).collect();
        let span = |finding: &Diagnostic| {
            finding.labels.first().map_or(Span::empty(0), |label| subject.span_of(&label.at))
        };
        let mut unlisted = HashMap::new();
        for index in of_rule(findings, "object-not-listed").filter_map(index_of) {
            let only = unlisted.entry(ObjectList::of(index)).or_insert(Some(index));
            *only = only.filter(|&first| first == index);
        }
        Self {
            text,
            has_no_objects: subject.description().is_some_and(|read| read.device().objects.is_empty()),
            spans: findings.iter().map(span).collect(),
            headers: starts("\n["),
            lost: only(findings.iter().filter_map(lost_object)),
            unlisted,
            object_tags: [OBJECT_START, OBJECT_END].map(starts),
        }
    }

    /// Which of the findings are explained by others.
    fn explained(&self, findings: &[Diagnostic]) -> Vec<bool> {
        let mut scopes: HashMap<(&str, Severity), CauseScope<'_>> = HashMap::new();
        let located = || findings.iter().zip(&self.spans).filter(|(finding, _)| !finding.labels.is_empty());
        for (finding, span) in located() {
            for one in finding.rule.explains {
                let Some(extent) = self.extent(one.reach, finding, *span) else { continue };
                // a cause of a lower severity would change the result of a run
                let severities = [Severity::Note, Severity::Warning, Severity::Error];
                for severity in severities.into_iter().filter(|severity| *severity <= finding.severity) {
                    for rule in one.rules {
                        scopes.entry((rule, severity)).or_default().add(&extent);
                    }
                }
            }
        }
        scopes.values_mut().for_each(CauseScope::sort);
        let is_explained = |(finding, span): (&Diagnostic, &Span)| {
            let scope = scopes.get(&(finding.rule.name(), finding.severity));
            let covers =
                |scope: &CauseScope<'_>| scope.covers(finding, self.text, *span, self.section(*span));
            !finding.labels.is_empty() && scope.is_some_and(covers)
        };
        findings.iter().zip(&self.spans).map(is_explained).collect()
    }

    /// The number of the section that a span starts in.
    fn section(&self, span: Span) -> usize {
        self.headers.partition_point(|&header| header < span.start)
    }

    fn extent<'b>(&self, reach: Reach, finding: &'b Diagnostic, cause: Span) -> Option<CauseExtent<'b>> {
        let line = || line(self.text, cause.start);
        match reach {
            Reach::File => Some(CauseExtent::All),
            Reach::NoObjects => self.has_no_objects.then_some(CauseExtent::All),
            Reach::Around => Some(CauseExtent::At(cause.start)),
            Reach::Section => Some(CauseExtent::Section(self.section(cause))),
            Reach::Object => match (index_of(finding), self.index_of_section(cause)) {
                (Some(index), _) => Some(CauseExtent::Object(index)),
                (None, Some(index)) => Some(CauseExtent::named(index)),
                (None, None) => self.object_of(cause),
            },
            Reach::Keys => Some(CauseExtent::Keys(&finding.message)),
            Reach::Lost => self.lost.map(CauseExtent::named),
            Reach::List => {
                let name = self.header_above(cause)?;
                let list = ObjectList::ALL.into_iter().find(|list| list.name().eq_ignore_ascii_case(name));
                self.unlisted.get(&list).copied().flatten().map(CauseExtent::Object)
            }
            Reach::Value => value_of(line()).map(CauseExtent::Object),
            Reach::Header if line().trim_end().ends_with(']') => {
                let name = line().trim_matches(|c: char| !c.is_ascii_alphanumeric());
                let name = name.rsplit('[').next().unwrap_or_default();
                let index = name.get(..4).and_then(|index| u16::from_str_radix(index, 16).ok());
                let end = self.headers.get(self.section(cause)).map_or(u32::MAX, |&next| next);
                let name = index.map_or(name.to_owned(), |index| format!("{index:04X}h"));
                (name.len() > 3).then_some(CauseExtent::Header(cause.start, end, index, name))
            }
            Reach::Header => None,
        }
    }

    /// The name in the previous header; `None` in an XDD.
    fn header_above(&self, cause: Span) -> Option<&str> {
        let header = *self.headers.get(self.section(cause).checked_sub(1)?)?;
        line(self.text, header + 1).strip_prefix('[')?.split(']').next().map(str::trim)
    }

    fn index_of_section(&self, cause: Span) -> Option<u16> {
        u16::from_str_radix(self.header_above(cause)?.get(..4)?, 16).ok()
    }

    fn object_of(&self, cause: Span) -> Option<CauseExtent<'static>> {
        let [starts, ends] = &self.object_tags;
        let length = u32::try_from(OBJECT_START.len()).ok()?;
        let start = starts.partition_point(|&start| start + length <= cause.start).checked_sub(1)?;
        let end = ends.partition_point(|&end| end < cause.start);
        Some(CauseExtent::Behind(starts[start], *ends.get(end)?))
    }
}

/// The start of the tag of an object in an XDD.
const OBJECT_START: &str = "CANopenObject ";

/// The end of the tag after an object in an XDD.
const OBJECT_END: &str = "CANopenObject>";

/// The number at the end of a line.
fn value_of(line: &str) -> Option<u16> {
    let from = line.rfind(['x', 'X', '='])?;
    u16::from_str_radix(line.get(from + 1..)?.trim(), 16).ok()
}

/// The text of a line from an offset on.
fn line(text: &str, offset: u32) -> &str {
    text.get(offset as usize..).and_then(|rest| rest.lines().next()).unwrap_or_default()
}

fn of_rule<'a>(findings: &'a [Diagnostic], name: &'a str) -> impl Iterator<Item = &'a Diagnostic> {
    findings.iter().filter(move |finding| finding.rule.name() == name)
}

/// The object whose section is missing according to a finding.
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

/// The common value of all items; `None` if they differ, or there are none.
fn only(mut items: impl Iterator<Item = u16>) -> Option<u16> {
    let first = items.next()?;
    items.all(|item| item == first).then_some(first)
}

fn index_of(finding: &Diagnostic) -> Option<u16> {
    match &finding.labels.first()?.at {
        At::Place(place) => place.part.object(),
        At::Span(_) | At::Node(..) | At::Patch(..) => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::report::grouped;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::diagnostic::Explained;
    use objdict_model::source::SourceFile;

    const EDS: &str = include_str!("../../../../fixtures/eds/io-401.eds");
    const XDD: &str = include_str!("../../../../fixtures/xdd/io-401.xdd");

    /// The rules shown in a report about a text.
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

    /// A cause is examined once, not for each finding that it may explain.
    #[test]
    fn many_conflicts_do_not_take_long() {
        let conflicts: String =
            (0..1200).map(|number| format!("<<<<<<< {number}\n") + &"x=1\n".repeat(100)).collect();
        let text = format!("[FileInfo]\n{conflicts}");
        assert!(shown("a.eds", &text, Format::Eds).contains(&"cia306/junk-line"));
    }

    /// The keys of a section without its header are not separate findings; those of others are.
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
