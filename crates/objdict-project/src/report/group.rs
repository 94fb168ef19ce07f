//! Joins findings with the same cause into one: the first one, with the others attached.
//!
//! Findings are joined if only places and found values differ; a gap `{!}` contains a required value, which must
//! be equal.

use std::collections::BTreeMap;

use super::consequences::without_consequences;
use super::{Location, Subject};
#[cfg(feature = "full")]
use objdict_format::Description;
#[cfg(feature = "full")]
use objdict_model::diagnostic::Fix;
use objdict_model::diagnostic::{Applicability, At, Diagnostic, Findings, Severity, Text, counted, say};
use objdict_model::model::{Part, Place};

/// The maximum number of ranges of places in a message.
const MAX_RANGES: usize = 6;

/// The common properties of findings with the same cause: everything except the place, and the numbers and
/// quotations in message and help.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct CommonCause {
    rule: &'static str,
    severity: Severity,
    pattern: String,
    help: Option<String>,
    safety: Option<Applicability>,
}

impl CommonCause {
    fn of(finding: &Diagnostic) -> Self {
        Self {
            rule: finding.rule.id,
            severity: finding.severity,
            pattern: finding.message.pattern(),
            help: finding.help.as_ref().map(Text::pattern),
            safety: finding.fix.as_ref().map(|fix| fix.safety),
        }
    }
}

/// The findings of a file, each at its place, so that programs can recognise a new one of a known kind. Findings that
/// another one explains are omitted, such as the wrong count of a list that contains a number twice.
///
/// Use [`grouped`] for display.
#[must_use]
pub fn by_place<'a>(subject: impl Into<Subject<'a>>, findings: Findings) -> Findings {
    let subject = subject.into();
    findings.rearrange(|kept| without_consequences(subject, kept))
}

/// Joins the findings of a file that have the same cause: those of one rule whose messages differ only in the place and
/// the values there. The others are attached to the first one ([`Diagnostic::also`]), whose message states their
/// number. Findings that point to the same place are kept separate, because only their messages distinguish them.
///
/// Findings that another one explains are omitted, as in [`by_place`]. Comments, baselines and fixes apply to single
/// findings, so join the remaining ones.
#[must_use]
pub fn grouped<'a>(subject: impl Into<Subject<'a>>, findings: Findings) -> Findings {
    let subject = subject.into();
    let omitted: Vec<&str> = findings.omitted().map(|(rule, _)| rule).collect();
    findings.rearrange(|kept| {
        let kept = without_consequences(subject, kept);
        let starts: Vec<u32> = kept.iter().map(|finding| start(subject, finding)).collect();
        let causes: Vec<CommonCause> = kept.iter().map(CommonCause::of).collect();
        let mut at_place: BTreeMap<(u32, &CommonCause), usize> = BTreeMap::new();
        for at in starts.iter().copied().zip(&causes) {
            *at_place.entry(at).or_default() += 1;
        }
        let mut firsts: BTreeMap<&CommonCause, usize> = BTreeMap::new();
        let mut joined: Vec<Diagnostic> = Vec::with_capacity(kept.len());
        for (finding, at @ (_, cause)) in kept.into_iter().zip(starts.iter().copied().zip(&causes)) {
            let is_alone = at_place.get(&at).is_none_or(|count| *count > 1);
            match firsts.get(cause).and_then(|&first| joined.get_mut(first)).filter(|_| !is_alone) {
                Some(first) => first.also.push(finding),
                None => {
                    if !is_alone {
                        firsts.insert(cause, joined.len());
                    }
                    joined.push(finding);
                }
            }
        }
        joined
            .iter_mut()
            .filter(|finding| !finding.also.is_empty())
            .for_each(|finding| count(subject, finding, omitted.contains(&finding.rule.id)));
        joined
    })
}

fn start(subject: Subject<'_>, finding: &Diagnostic) -> u32 {
    finding.labels.first().map_or(0, |label| subject.span_of(&label.at).start)
}

/// Adds the number and places of further findings to the message, "at least" if the rule has more than are kept. A help
/// that depends on a value applies to the first.
fn count(subject: Subject<'_>, finding: &mut Diagnostic, has_more: bool) {
    let help = finding.help.as_ref().map(Text::shown);
    if finding.also.iter().any(|other| other.help.as_ref().map(Text::shown) != help) {
        finding.help = finding.help.take().map(|help| help.followed_by(&"; the other places differ".into()));
    }
    let spots: Vec<FindingSpot> = finding.also.iter().map(|other| FindingSpot::of(subject, other)).collect();
    let least = if has_more { "at least " } else { "" };
    let rest = say!("; {}{} more like this: {}", least, finding.also.len(), ranges(&spots));
    finding.message = std::mem::take(&mut finding.message).followed_by(&rest);
}

/// The location of a finding, in short.
#[derive(Clone, Copy, PartialEq, Eq)]
enum FindingSpot {
    Object(u16),
    Entry(u16, u8),
    Line(u32),
}

impl FindingSpot {
    fn of(subject: Subject<'_>, finding: &Diagnostic) -> Self {
        match finding.labels.first().map(|label| &label.at) {
            Some(At::Place(Place { part: Part::Object(index), .. })) => Self::Object(*index),
            Some(At::Place(Place { part: Part::Entry(index, sub), .. })) => Self::Entry(*index, *sub),
            _ => Self::Line(Location::start_of(subject, finding).line),
        }
    }

    /// Whether this directly follows the previous location.
    fn follows(self, before: Self) -> bool {
        match (before, self) {
            (Self::Object(before), Self::Object(index)) => before.checked_add(1) == Some(index),
            (Self::Entry(of, before), Self::Entry(index, sub)) => {
                of == index && before.checked_add(1) == Some(sub)
            }
            (Self::Line(before), Self::Line(line)) => before.checked_add(1) == Some(line),
            _ => false,
        }
    }

    fn shown(self) -> String {
        match self {
            Self::Object(index) => format!("{index:04X}h"),
            Self::Entry(index, sub) => format!("{index:04X}h:{sub:02X}"),
            Self::Line(line) => format!("line {line}"),
        }
    }
}

/// `2100h:02 to 2100h:28, line 17`; only the first ranges if there are many.
fn ranges(spots: &[FindingSpot]) -> Text {
    let mut ranges: Vec<(FindingSpot, FindingSpot, usize)> = Vec::new();
    for &spot in spots {
        match ranges.last_mut() {
            Some((_, last, count)) if spot.follows(*last) => (*last, *count) = (spot, *count + 1),
            Some((_, last, _)) if spot == *last => {}
            _ => ranges.push((spot, spot, 1)),
        }
    }
    let named = ranges.iter().take(MAX_RANGES).map(|&(first, last, count)| match count {
        1 => first.shown(),
        _ => match (first, last) {
            (FindingSpot::Line(first), FindingSpot::Line(last)) => format!("lines {first} to {last}"),
            _ => format!("{} to {}", first.shown(), last.shown()),
        },
    });
    let named = named.collect::<Vec<_>>().join(", ");
    match ranges.len().checked_sub(MAX_RANGES) {
        None | Some(0) => named.into(),
        Some(_) => {
            let rest: usize = ranges.iter().skip(MAX_RANGES).map(|(.., count)| count).sum();
            format!("{named} and {}", counted(rest, "more place", "more places")).into()
        }
    }
}

/// The offered fixes of all findings with the same cause, as far as they can be applied to this file; `None`
/// if none can.
#[cfg(feature = "full")]
pub(super) fn joint_fix(description: &Description, finding: &Diagnostic) -> Option<Fix> {
    let all = std::iter::once(finding).chain(&finding.also);
    let fixes = all.filter_map(|one| one.fix.as_ref()).filter(|fix| fix.is_offered);
    let mut fixes = fixes.filter(|fix| description.can_fix(fix)).cloned().peekable();
    let first = fixes.next()?;
    if fixes.peek().is_none() {
        return Some(first);
    }
    let mut joint = first.clone();
    let mut count = 0usize;
    for fix in fixes {
        joint.changes.extend(fix.changes);
        count += 1;
    }
    joint.title = joint.title.followed_by(&say!("; {} more like this", count));
    // changes that touch each other cannot be made together
    let is_sound = description.edits(&joint).is_some_and(|mut edits| {
        edits.sort_by_key(|(span, _)| (span.start, span.end));
        edits.windows(2).all(|pair| matches!(pair, [(a, _), (b, _)] if a.end <= b.start && a != b))
    });
    Some(if is_sound { joint } else { first })
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::source::SourceFile;

    #[test]
    fn findings_of_one_cause_are_one_with_places() {
        let object =
            |index| format!("[{index}]\nParameterName=A\nObjectType=07\nDataType=05\nAccessType=ro\n");
        let text: String = (2000..2003).map(object).collect();
        let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
        let findings = crate::check(&description);
        let all = findings.len();
        let joined = grouped(&description, findings);
        // no finding explains another here
        assert_eq!(joined.iter().map(|finding| 1 + finding.also.len()).sum::<usize>(), all);
        let zero = joined.iter().find(|finding| finding.rule.id == "cia306/leading-zero").unwrap();
        assert!(zero.message.to_string().contains("; 5 more like this: "), "{}", zero.message);
        let fix = joint_fix(&description, zero).unwrap();
        assert_eq!(description.edits(&fix).unwrap().len(), 6, "the fixes apply together");
    }

    #[test]
    fn places_are_named_in_rows() {
        let entries = (2..=0x28).map(|sub| FindingSpot::Entry(0x2100, sub));
        let spots: Vec<FindingSpot> = entries
            .chain([FindingSpot::Object(0x2101), FindingSpot::Line(3), FindingSpot::Line(4)])
            .collect();
        assert_eq!(ranges(&spots), "2100h:02 to 2100h:28, 2101h, lines 3 to 4");
        let spots: Vec<FindingSpot> = (0..8).map(|number| FindingSpot::Line(2 * number + 1)).collect();
        assert_eq!(ranges(&spots), "line 1, line 3, line 5, line 7, line 9, line 11 and 2 more places");
    }
}
