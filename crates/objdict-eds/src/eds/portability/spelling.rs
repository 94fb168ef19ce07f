//! Spellings of names and numbers that some tools do not accept.

use super::rules::{
    BLANKS_AFTER_SECTION, EMPTY_KEY, HEX_BAUD_RATE, HEX_COUNT, HEX_FLAG, KEY_CASE, SECTION_CASE,
};
use super::{CheckedSection, SectionLine, report};
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::model::{Field, Part};
use crate::source::Span;

pub(super) fn check(section: &CheckedSection<'_>, findings: &mut Findings) {
    check_blanks(section, findings);
    if matches!(section.part(), Part::Section(_)) {
        return;
    }
    check_name(section, findings);
    for line in section.lines() {
        check_key(section, &line, findings);
        check_empty(section, &line, findings);
        check_number(section, &line, findings);
    }
}

fn check_blanks(section: &CheckedSection<'_>, findings: &mut Findings) {
    let line = section.header.line.of(section.text);
    let header = line.trim_end_matches([' ', '\t']);
    if header.len() < line.len() && header.ends_with(']') {
        let end = section.header.line.end;
        let spaces = Span::new(end - (line.len() - header.len()) as u32, end);
        let message = || say!("`[{}]` is followed by spaces", section.name);
        let at = section.header.name;
        let fix = Some((spaces, String::new()));
        report((&BLANKS_AFTER_SECTION, at), "remove the spaces", fix, message, findings);
    }
}

fn check_name(section: &CheckedSection<'_>, findings: &mut Findings) {
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
        let help = "write the name in the case of the standard";
        let message = || say!("`[{}]` is spelled `[{}]` in the standard", section.name, standard);
        report((&SECTION_CASE, at), help, Some((at, standard.clone())), message, findings);
    }
}

fn check_key(section: &CheckedSection<'_>, line: &SectionLine<'_>, findings: &mut Findings) {
    let standard = match line.field() {
        Some(field) => field.name(),
        None => match section.part() {
            Part::DummyUsage => with_head(line.name, "Dummy").into(),
            Part::Comments => with_head(line.name, "Line").into(),
            _ => return,
        },
    };
    if standard != line.name {
        let help = "write the key in the case of the standard";
        let fix = Some((line.name_at, standard.clone().into_owned()));
        let message = || say!("`{}` is spelled `{}` in the standard", line.name, standard);
        report((&KEY_CASE, line.name_at), help, fix, message, findings);
    }
}

/// Keys for which an empty value means the same as a missing key.
fn check_empty(section: &CheckedSection<'_>, line: &SectionLine<'_>, findings: &mut Findings) {
    if !line.value.is_empty() {
        return;
    }
    let is_meant = match line.field() {
        Some(field) if *section.part() == Part::DeviceInfo && is_number(field) => true,
        _ if !matches!(section.part(), Part::Object(_) | Part::Entry(..)) => false,
        Some(Field::ObjectType | Field::ObjFlags | Field::CompactSubObj) => true,
        Some(Field::PdoMapping) => holds_value(section),
        // of a structure without a value
        Some(Field::AccessType | Field::DefaultValue) => !holds_value(section),
        _ => false,
    };
    if is_meant {
        let fix = Some((whole_line(section.text, line), String::new()));
        let message = || say!("`{}` has no value", line.name);
        report((&EMPTY_KEY, line.name_at), "remove the line", fix, message, findings);
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

/// `Dummy0005` for `dummy0005`; the unchanged name if its prefix is different.
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
