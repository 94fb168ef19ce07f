//! Which findings another one explains, so that a report says the cause alone.

use super::Subject;
use crate::diagnostic::{At, Diagnostic};
use crate::model::{Part, Place};
use crate::source::Span;

/// Findings of some rules that a finding of another rule explains.
struct Consequence {
    cause: &'static str,
    explains: &'static [&'static str],
    /// Where the explained findings are.
    scope: Scope,
}

#[derive(Clone, Copy)]
enum Scope {
    /// Anywhere in the file.
    File,
    /// Anywhere in a file of which no object was read.
    NoObjects,
    /// At an element or line that the cause is in.
    Around,
    /// In the section of the cause.
    Section,
    /// At the object that the line of the cause names as its value.
    Value,
    /// Between the marks of a merge conflict, the first of which is the cause.
    Conflict,
    /// At the line below the cause, which looks like a header.
    Header,
}

const CONSEQUENCES: &[Consequence] = &[
    // what is behind the element is read as a part of it
    Consequence {
        cause: "xml/unclosed-element",
        explains: &[
            "cia311/unknown-element",
            "cia311/missing-element",
            "cia311/missing-profile",
            "cia311/dangling-unique-id-ref",
        ],
        scope: Scope::File,
    },
    // an object takes its data type, access and value from the parameter
    Consequence {
        cause: "cia311/dangling-unique-id-ref",
        explains: &["cia306/missing-key", "cia301/device-type-without-value", "cia306/missing-constant"],
        scope: Scope::Around,
    },
    Consequence {
        cause: "cia311/missing-profile",
        explains: &["cia301/missing-mandatory-object", "cia306/no-baud-rate"],
        scope: Scope::NoObjects,
    },
    // one number of a list twice, and another one missing
    Consequence { cause: "cia306/duplicate-key", explains: &["cia306/wrong-count"], scope: Scope::Section },
    Consequence {
        cause: "cia306/duplicate-key",
        explains: &["cia306/object-not-listed"],
        scope: Scope::Value,
    },
    Consequence { cause: "cia306/junk-line", explains: &["cia306/duplicate-key"], scope: Scope::Conflict },
    Consequence { cause: "cia306/junk-line", explains: &["cia306/key-before-section"], scope: Scope::Header },
];

/// The findings without those that others among them explain.
pub(super) fn without_consequences(subject: Subject<'_>, findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let places = Places::new(subject, &findings);
    let mut is_explained = vec![false; findings.len()];
    for Consequence { cause, explains, scope } in CONSEQUENCES {
        let causes = findings
            .iter()
            .zip(&places.spans)
            .filter(|(finding, _)| finding.rule.id == *cause && !finding.labels.is_empty());
        let reaches: Vec<Reach> = causes.filter_map(|(_, span)| places.reach(*scope, *span)).collect();
        if reaches.is_empty() {
            continue;
        }
        for ((finding, span), explained) in findings.iter().zip(&places.spans).zip(&mut is_explained) {
            if explains.contains(&finding.rule.id) && !finding.labels.is_empty() && !*explained {
                let section = places.section(*span);
                *explained = reaches.iter().any(|reach| reach.covers(finding, *span, section));
            }
        }
    }
    let mut is_explained = is_explained.into_iter();
    findings.into_iter().filter(|_| !is_explained.next().unwrap_or_default()).collect()
}

/// What one cause explains. It is made once for each cause, because a file may have many of them.
enum Reach {
    All,
    /// What has this offset in it.
    At(u32),
    /// What starts behind the first offset, and not behind the second.
    Behind(u32, u32),
    Section(usize),
    Object(u16),
}

impl Reach {
    fn covers(&self, finding: &Diagnostic, span: Span, section: usize) -> bool {
        match *self {
            Self::All => true,
            Self::At(offset) => (span.start..=span.end).contains(&offset),
            Self::Behind(start, end) => span.start > start && span.start <= end,
            Self::Section(number) => number == section,
            Self::Object(index) => index_of(finding) == Some(index),
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
            conflict_ends: starts("\n>>>>>>>"),
        }
    }

    /// The number of the section that a span starts in.
    fn section(&self, span: Span) -> usize {
        self.headers.partition_point(|&header| header < span.start)
    }

    fn reach(&self, scope: Scope, cause: Span) -> Option<Reach> {
        let line = || line(self.text, cause.start);
        match scope {
            Scope::File => Some(Reach::All),
            Scope::NoObjects => self.has_no_objects.then_some(Reach::All),
            Scope::Around => Some(Reach::At(cause.start)),
            Scope::Section => Some(Reach::Section(self.section(cause))),
            Scope::Value => {
                let value = line().split_once('=').map_or("", |(_, value)| value.trim());
                let value = value.strip_prefix("0x").or(value.strip_prefix("0X")).unwrap_or(value);
                u16::from_str_radix(value, 16).ok().map(Reach::Object)
            }
            Scope::Conflict if line().starts_with("<<<<<<<") => {
                let next = self.conflict_ends.partition_point(|&end| end < cause.start);
                self.conflict_ends.get(next).map(|&end| Reach::Behind(cause.start, end))
            }
            Scope::Header if line().contains('[') && line().trim_end().ends_with(']') => {
                Some(Reach::Behind(cause.start, u32::MAX))
            }
            Scope::Conflict | Scope::Header => None,
        }
    }
}

/// The text of a line from an offset.
fn line(text: &str, offset: u32) -> &str {
    text.get(offset as usize..).and_then(|rest| rest.lines().next()).unwrap_or_default()
}

fn index_of(finding: &Diagnostic) -> Option<u16> {
    match finding.labels.first()?.at {
        At::Place(Place { part: Part::Object(index), .. }) => Some(index),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let is_rule = |id: &&str| crate::registry::rules().iter().any(|rule| rule.id == *id);
        for Consequence { cause, explains, .. } in CONSEQUENCES {
            assert!(is_rule(cause), "{cause}");
            assert!(explains.iter().all(is_rule), "{explains:?}");
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

    #[test]
    fn an_element_without_its_end_is_the_cause_of_the_rest() {
        let text = XDD.replacen("</q1:DeviceIdentity>", "", 1);
        let rules = shown("io-401.xdd", &text, Format::Xdd);
        assert!(rules.contains(&"xml/unclosed-element") && rules.len() < 4, "{rules:?}");
        let text = XDD.replacen("uniqueIDRef=\"UID_OBJ_1000\"", "uniqueIDRef=\"UID_0\"", 1);
        let rules = shown("io-401.xdd", &text, Format::Xdd);
        assert!(rules.contains(&"cia311/dangling-unique-id-ref"), "{rules:?}");
        assert!(!rules.contains(&"cia306/missing-key"), "{rules:?}");
    }
}
