//! The rules of the group `portability` that need the text of an EDS or DCF: spelling and order of lines.
//!
//! They run when a check includes tools, but do not name them: `compat` lists the affected tools.

mod loading;
mod rules;
mod spelling;
mod structure;
mod values;

use super::keys::FieldKey;
use super::section::{NameSpelling, SectionName, section_name};
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, Text};
use crate::ini::{self, Document};
use crate::model::{Device, Entry, Field, Part};
pub use crate::source::Span;

pub use rules::RULES;

/// Adds the findings of the text from which `device` was read.
pub fn check(document: &Document, device: &Device, findings: &mut Findings) {
    let mut order = structure::ObjectOrder::default();
    let text = document.text();
    document.visit(
        |section| {
            let Some(header) = section.header else { return };
            let name = header.name.of(text);
            let parsed = SectionName::parse(name);
            let section = CheckedSection { text, device, header, name, parsed: &parsed, ini: section };
            spelling::check(&section, findings);
            values::check(&section, findings);
            order.check(&section, findings);
        },
        |_| {},
    );
    structure::commented_sections(document, findings);
    loading::check(document, findings);
}

/// A section and its part.
struct CheckedSection<'a> {
    text: &'a str,
    device: &'a Device,
    header: ini::Header,
    /// The name as written.
    name: &'a str,
    parsed: &'a SectionName,
    ini: &'a ini::Section,
}

/// A line of a section.
struct SectionLine<'a> {
    key: Option<FieldKey>,
    name: &'a str,
    value: &'a str,
    name_at: Span,
    value_at: Span,
}

impl<'a> CheckedSection<'a> {
    fn part(&self) -> &Part {
        &self.parsed.part
    }

    fn lines(&self) -> impl Iterator<Item = SectionLine<'a>> {
        let text = self.text;
        self.ini.entries.iter().map(move |entry| {
            let name = entry.key.of(text);
            SectionLine {
                key: FieldKey::find(name),
                name,
                value: entry.value.of(text),
                name_at: entry.key,
                value_at: entry.value,
            }
        })
    }

    /// The entry that the section describes.
    fn entry(&self) -> Option<&'a Entry> {
        match *self.part() {
            Part::Object(index) | Part::CompactValues(index) => {
                self.device.object(index).map(|object| &object.main)
            }
            Part::Entry(index, sub) => self.device.object(index)?.subs.get(sub),
            _ => None,
        }
    }

    /// The name in the spelling of the standard.
    fn standard_name(&self) -> Option<String> {
        section_name(self.part()).filter(|_| self.parsed.spelling == NameSpelling::Standard)
    }
}

impl SectionLine<'_> {
    fn field(&self) -> Option<&'static Field> {
        self.key.map(FieldKey::field)
    }
}

/// Reports a span, with a fix that writes `text` there or at a different span.
fn report(
    (rule, at): (&'static RuleInfo, Span),
    help: &'static str,
    fix: Option<(Span, String)>,
    message: impl FnOnce() -> Text,
    findings: &mut Findings,
) {
    findings.push_with(rule, || {
        let finding = Diagnostic::new(rule, at, message()).help(help);
        match fix {
            Some((span, text)) => finding.fix(Fix::safe(help).replace(span, text)),
            None => finding,
        }
    });
}
