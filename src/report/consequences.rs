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
    let spans = |rules: &[&str]| -> Vec<(usize, Span)> {
        let of_rules = findings.iter().enumerate().filter(|(_, finding)| rules.contains(&finding.rule.id));
        of_rules.filter_map(|(number, f)| Some((number, subject.span_of(&f.labels.first()?.at)))).collect()
    };
    let mut is_explained = vec![false; findings.len()];
    for Consequence { cause, explains, scope } in CONSEQUENCES {
        let causes = spans(&[cause]);
        if causes.is_empty() {
            continue;
        }
        for (number, span) in spans(explains) {
            let Some((finding, explained)) = findings.get(number).zip(is_explained.get_mut(number)) else {
                continue;
            };
            *explained |= causes.iter().any(|(_, cause)| scope.holds(subject, *cause, finding, span));
        }
    }
    let mut is_explained = is_explained.into_iter();
    findings.into_iter().filter(|_| !is_explained.next().unwrap_or_default()).collect()
}

impl Scope {
    /// Whether a finding with its span is in the scope of a cause.
    fn holds(self, subject: Subject<'_>, cause: Span, finding: &Diagnostic, span: Span) -> bool {
        let text = subject.source().text();
        match self {
            Self::File => true,
            Self::NoObjects => subject.description().is_some_and(|read| read.device().objects.is_empty()),
            Self::Around => (span.start..=span.end).contains(&cause.start),
            Self::Section => header(text, span.start) == header(text, cause.start),
            Self::Value => {
                let value = line(text, cause.start).split_once('=').map_or("", |(_, value)| value.trim());
                let value = value.strip_prefix("0x").or(value.strip_prefix("0X")).unwrap_or(value);
                index_of(finding).is_some_and(|index| u16::from_str_radix(value, 16) == Ok(index))
            }
            Self::Conflict => {
                let rest = text.get(cause.start as usize..).unwrap_or_default();
                let end = rest.find("\n>>>>>>>").map(|end| cause.start as usize + end);
                rest.starts_with("<<<<<<<")
                    && end.is_some_and(|end| span.start > cause.start && span.start as usize <= end)
            }
            Self::Header => {
                let junk = line(text, cause.start);
                junk.contains('[') && junk.trim_end().ends_with(']') && cause.start < span.start
            }
        }
    }
}

/// Where the header of the section that an offset is in starts.
fn header(text: &str, offset: u32) -> Option<usize> {
    text.get(..=offset as usize)?.rfind("\n[")
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
