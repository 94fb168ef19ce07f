//! Spellings of names and numbers that some tools do not accept.

use super::rules::{
    BLANKS_AFTER_SECTION, EMPTY_KEY, HEX_BAUD_RATE, HEX_COUNT, HEX_FLAG, KEY_CASE, SECTION_CASE,
};
use super::{CheckedSection, SectionLine, Together};
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::model::{Field, Part};

/// Findings that are reported once per file.
#[derive(Default)]
pub(super) struct Spellings {
    blanks: Together,
    sections: Together,
    keys: Together,
    /// `ObjectType`, `PDOMapping`, `ObjFlags`, `CompactSubObj`, numbers of `[DeviceInfo]`, and `AccessType` and `DefaultValue` of
    /// structures without a value.
    empty: [Together; 7],
}

impl Spellings {
    pub(super) fn check(&mut self, section: &CheckedSection<'_>, findings: &mut Findings) {
        self.check_blanks(section);
        if matches!(section.part(), Part::Section(_)) {
            return;
        }
        self.check_name(section);
        for line in section.lines() {
            self.check_key(section, &line);
            self.check_empty(section, &line);
            check_number(section, &line, findings);
        }
    }

    pub(super) fn finish(self, findings: &mut Findings) {
        let title = "write the names in the case of the standard";
        self.sections.finish(&SECTION_CASE, "write the name in the case of the standard", title, findings);
        let remove = "remove the spaces";
        self.blanks.finish(&BLANKS_AFTER_SECTION, remove, remove, findings);
        self.keys.finish(&KEY_CASE, "write the key in the case of the standard", title, findings);
        for together in self.empty {
            together.finish(&EMPTY_KEY, "remove the line", "remove the lines without a value", findings);
        }
    }

    fn check_blanks(&mut self, section: &CheckedSection<'_>) {
        let line = section.header.line.of(section.text);
        let header = line.trim_end_matches([' ', '\t']);
        if header.len() < line.len() && header.ends_with(']') {
            self.blanks.add(section.header.name, || say!("`[{}]` is followed by spaces", section.name));
            let end = section.header.line.end;
            self.blanks.fix(crate::source::Span::new(end - (line.len() - header.len()) as u32, end), "");
        }
    }

    fn check_name(&mut self, section: &CheckedSection<'_>) {
        let Some(standard) = section.standard_name() else { return };
        let is_object = matches!(section.part(), Part::Object(_));
        if standard == section.name || is_object || !standard.eq_ignore_ascii_case(section.name) {
            return;
        }
        // tools accept the hex digits of an index or sub-index in both cases
        let differs = |(a, b): (char, char)| a != b;
        let letters = |name: &str| -> String { name.chars().filter(|c| !c.is_ascii_hexdigit()).collect() };
        if letters(&standard).chars().zip(letters(section.name).chars()).any(differs) {
            let at = section.header.name;
            self.sections
                .add(at, || say!("`[{}]` is spelled `[{}]` in the standard", section.name, standard));
            self.sections.fix(at, standard);
        }
    }

    fn check_key(&mut self, section: &CheckedSection<'_>, line: &SectionLine<'_>) {
        let standard = match line.field() {
            Some(field) => field.name(),
            None => match section.part() {
                Part::DummyUsage => with_head(line.name, "Dummy").into(),
                Part::Comments => with_head(line.name, "Line").into(),
                _ => return,
            },
        };
        if standard != line.name {
            self.keys.add(line.name_at, || say!("`{}` is spelled `{}` in the standard", line.name, standard));
            self.keys.fix(line.name_at, standard);
        }
    }

    /// Keys for which an empty value means the same as a missing key.
    fn check_empty(&mut self, section: &CheckedSection<'_>, line: &SectionLine<'_>) {
        if !line.value.is_empty() {
            return;
        }
        let number = match line.field() {
            Some(field) if *section.part() == Part::DeviceInfo && is_number(field) => 4,
            _ if !matches!(section.part(), Part::Object(_) | Part::Entry(..)) => return,
            Some(Field::ObjectType) => 0,
            Some(Field::PdoMapping) if holds_value(section) => 1,
            Some(Field::ObjFlags) => 2,
            Some(Field::CompactSubObj) => 3,
            Some(Field::AccessType) if !holds_value(section) => 5,
            Some(Field::DefaultValue) if !holds_value(section) => 6,
            _ => return,
        };
        let together = &mut self.empty[number];
        together.add(line.name_at, || say!("`{}` has no value", line.name));
        together.fix(whole_line(section.text, line), "");
    }
}

/// Whether tools read a value from the section: not from the section of an ARRAY or RECORD.
fn holds_value(section: &CheckedSection<'_>) -> bool {
    match *section.part() {
        Part::Object(index) => {
            section.device.object(index).is_some_and(|object| !object.object_type().has_subs())
        }
        _ => true,
    }
}

/// The line including its line end.
fn whole_line(text: &str, line: &SectionLine<'_>) -> crate::source::Span {
    let start = text[..line.name_at.start as usize].rfind(['\n', '\r']).map_or(0, |at| at + 1);
    let rest = &text[line.value_at.end as usize..];
    let end = rest.find(['\n', '\r']).unwrap_or(rest.len());
    let line_end = if rest[end..].starts_with("\r\n") { 2 } else { usize::from(end < rest.len()) };
    crate::source::Span::new(start as u32, line.value_at.end + (end + line_end) as u32)
}

/// `Dummy0005` for `dummy0005`; the unchanged name if it has another prefix.
fn with_head(name: &str, head: &str) -> String {
    match name.get(..head.len()) {
        Some(start) if start.eq_ignore_ascii_case(head) => format!("{head}{}", &name[head.len()..]),
        _ => name.to_owned(),
    }
}

/// Numbers that some tools parse only as decimal.
fn check_number(section: &CheckedSection<'_>, line: &SectionLine<'_>, findings: &mut Findings) {
    let rule: &'static RuleInfo = match (section.part(), line.field()) {
        (Part::List(_), Some(Field::SupportedObjects))
        | (Part::CompactNames(_) | Part::CompactValues(_), Some(Field::NrOfEntries)) => &HEX_COUNT,
        (Part::Commissioning, Some(Field::Baudrate)) => &HEX_BAUD_RATE,
        (Part::DeviceInfo, Some(field)) if is_flag(field) => &HEX_FLAG,
        (Part::DummyUsage, None) => &HEX_FLAG,
        _ => return,
    };
    let Some(digits) = line.value.strip_prefix("0x").or_else(|| line.value.strip_prefix("0X")) else {
        return;
    };
    let Ok(number) = u32::from_str_radix(digits, 16) else { return };
    let message = say!("`{}` is `{}`, a hex number", line.name, line.value);
    let fix = Fix::safe(say!("write `{}`", number)).replace(line.value_at, number.to_string());
    findings.push(
        Diagnostic::new(rule, line.value_at, message).help(say!("write `{}={}`", line.name, number)).fix(fix),
    );
}

/// Whether a key of `[DeviceInfo]` is a number that a tool parses.
fn is_number(field: &Field) -> bool {
    let is_other = matches!(
        field,
        Field::VendorNumber
            | Field::ProductNumber
            | Field::RevisionNumber
            | Field::Granularity
            | Field::NrOfRxPdo
            | Field::NrOfTxPdo
    );
    is_other || is_flag(field)
}

fn is_flag(field: &Field) -> bool {
    matches!(
        field,
        Field::BaudRate10
            | Field::BaudRate20
            | Field::BaudRate50
            | Field::BaudRate125
            | Field::BaudRate250
            | Field::BaudRate500
            | Field::BaudRate800
            | Field::BaudRate1000
            | Field::SimpleBootUpMaster
            | Field::SimpleBootUpSlave
            | Field::DynamicChannelsSupported
            | Field::GroupMessaging
            | Field::LssSupported
    )
}
