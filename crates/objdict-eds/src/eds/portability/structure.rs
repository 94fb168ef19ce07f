//! Order and gaps of sections that some tools do not expect.

use std::collections::HashSet;

use super::rules::{COMMENTED_SECTION, DUMMY_USAGE, SPARSE_NAMES, SUB_BEFORE_OBJECT};
use super::{CheckedSection, report};
use crate::diagnostic::{Diagnostic, Findings, Fix, listing, listing_or, say};
use crate::ini::{Document, LineKind};
use crate::model::{Field, Part, Place};
use crate::source::Span;

/// The objects whose section was seen, and those that were reported.
#[derive(Default)]
pub(super) struct ObjectOrder {
    met: HashSet<u16>,
    reported: HashSet<u16>,
}

impl ObjectOrder {
    pub(super) fn check(&mut self, section: &CheckedSection<'_>, findings: &mut Findings) {
        match *section.part() {
            Part::Object(index) => {
                self.met.insert(index);
            }
            Part::Entry(index, _) => self.check_order(index, section, findings),
            Part::CompactNames(index) => {
                self.check_order(index, section, findings);
                check_names(index, section, findings);
            }
            Part::DummyUsage => check_dummies(section, findings),
            _ => {}
        }
    }

    fn check_order(&mut self, index: u16, section: &CheckedSection<'_>, findings: &mut Findings) {
        let exists = section.device.object(index).is_some_and(|object| !object.orphan);
        if exists && !self.met.contains(&index) && self.reported.insert(index) {
            let message = say!("`[{}]` is before `[{:X}]`", section.name, index);
            let finding = Diagnostic::new(&SUB_BEFORE_OBJECT, section.header.name, message)
                .label(Place::object(index), "the object");
            findings.push(finding.help(say!("move `[{:X}]` above this section", index)));
        }
    }
}

/// Reports gaps: tools read each name from 1 to `NrOfEntries`.
fn check_names(index: u16, section: &CheckedSection<'_>, findings: &mut Findings) {
    let Some(object) = section.device.object(index) else { return };
    let Some(compact) = &object.compact else { return };
    let Some(highest) = compact.names.iter().map(|(sub, _)| *sub).max() else { return };
    // a gap is either below the highest name or above it
    let missing: Vec<u8> =
        (1..=highest).filter(|sub| compact.names.iter().all(|(named, _)| named != sub)).collect();
    let counts = section.lines().any(|line| line.field() == Some(&Field::NrOfEntries));
    if missing.first().is_none_or(|&first| usize::from(first) > compact.names.len()) || !counts {
        return;
    }
    let place = Place::of(Part::CompactNames(index));
    let name = |sub: u8| format!("{}{sub}", object.name());
    let fix = Fix::safe("add the missing names with the default of the standard")
        .set(place.clone().field(Field::NrOfEntries), highest.to_string());
    let fix = missing
        .iter()
        .fold(fix, |fix, &sub| fix.set(place.clone().field(Field::Item(sub.into())), name(sub)));
    let first = missing[0];
    let message = say!("`[{}]` names sub-index {} but not sub-index {}", section.name, highest, first);
    let finding = Diagnostic::new(&SPARSE_NAMES, section.header.name, message);
    findings.push(
        finding
            .help(say!("name all sub-indexes from 1 to {}, such as `{}={}`", highest, first, name(first)))
            .fix(fix),
    );
}

fn check_dummies(section: &CheckedSection<'_>, findings: &mut Findings) {
    let is_there = |key: &String| section.lines().any(|line| line.name.eq_ignore_ascii_case(key));
    let missing: Vec<String> =
        (1..=7).map(|number| format!("Dummy{number:04}")).filter(|key| !is_there(key)).collect();
    if missing.is_empty() {
        return;
    }
    let lines = listing(missing.iter().map(|key| format!("{key}=0")));
    let place = |key: &str| Place::of(Part::DummyUsage).field(Field::Named(key.into()));
    let fix = missing.iter().fold(Fix::safe(say!("add {}", lines)), |fix, key| fix.set(place(key), "0"));
    let message = say!("`[{}]` has no {}", section.name, listing_or(&missing));
    let finding = Diagnostic::new(&DUMMY_USAGE, section.header.name, message);
    findings.push(finding.help(say!("add {}", lines)).fix(fix));
}

/// Headers in comments that are followed by keys before the next header.
pub(super) fn commented_sections(document: &Document, findings: &mut Findings) {
    let text = document.text();
    let help = "add a space after the `;`";
    let mut commented: Option<(Span, &str)> = None;
    for line in document.lines() {
        match line.kind {
            LineKind::Comment => {
                let shown = line.span.of(text);
                let header = shown.trim_start_matches(';');
                if header.len() < shown.len() && is_header(header) {
                    let marks = (shown.len() - header.len()) as u32;
                    commented = Some((Span::empty(line.span.start + marks), shown));
                }
            }
            LineKind::Section { .. } => commented = None,
            LineKind::Entry { .. } => {
                if let Some((at, shown)) = commented.take() {
                    let start = at.start - (shown.len() - shown.trim_start_matches(';').len()) as u32;
                    let span = Span::new(start, start + shown.len() as u32);
                    let message = || say!("keys follow the commented header `{}`", shown.trim_end());
                    let fix = Some((at, " ".to_owned()));
                    report((&COMMENTED_SECTION, span), help, fix, message, findings);
                }
            }
            LineKind::Blank | LineKind::Junk => {}
        }
    }
}

/// `[` with letters and digits up to the `]`.
fn is_header(text: &str) -> bool {
    let name = text.strip_prefix('[').and_then(|rest| rest.split_once(']')).map(|(name, _)| name);
    name.is_some_and(|name| !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}
