//! Values in a notation that some tools misread.

use super::rules::{
    BARE_NODE_ID, HASH_IN_TEXT, LIMIT_NOT_READ, NEGATIVE_HEX, REAL_AS_DECIMAL, SEMICOLON_IN_TEXT,
    UNQUOTED_STRING,
};
use super::{CheckedSection, SectionLine, report};
use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::literal::{self, Quirk, Quirks};
use crate::model::{DataType, Field, Part, TypeKind};

pub(super) fn check(section: &CheckedSection<'_>, findings: &mut Findings) {
    let data_type = section.entry().and_then(|entry| entry.data_type);
    for line in section.lines().filter(|line| !line.value.is_empty()) {
        let is_value = match line.field() {
            Some(Field::DefaultValue | Field::ParameterValue) => true,
            Some(field @ (Field::LowLimit | Field::HighLimit)) => {
                check_real(data_type, &line, findings);
                check_limit(data_type, field, &line, findings);
                false
            }
            None => matches!(section.part(), Part::CompactValues(_)),
            Some(_) => false,
        };
        if is_value {
            check_real(data_type, &line, findings);
            check_string(data_type, &line, findings);
            check_negative(data_type, &line, findings);
            check_bare_node_id(data_type, &line, findings);
        }
        if is_text(section, &line, is_value.then_some(data_type).flatten()) {
            check_text(section, &line, findings);
        }
    }
}

fn check_real(data_type: Option<DataType>, line: &SectionLine<'_>, findings: &mut Findings) {
    let is_real = matches!(data_type, Some(DataType::REAL32 | DataType::REAL64));
    if is_real && line.value != "0" && !is_hex(line.value) {
        let help = "write the bits in hex, such as `0x3FC00000`, in a copy for this tool";
        let fix = bits_of(line.value, data_type).map(|bits| (line.value_at, bits));
        let message = || say!("the REAL `{}` is not written as bits", line.value);
        report((&REAL_AS_DECIMAL, line.value_at), help, fix, message, findings);
    }
}

fn check_string(data_type: Option<DataType>, line: &SectionLine<'_>, findings: &mut Findings) {
    let is_string = matches!(data_type, Some(DataType::VISIBLE_STRING | DataType::UNICODE_STRING));
    if is_string && !line.value.starts_with(['"', '\'']) {
        let help = "quote the string in a copy for dcf2dev; other tools read the quotes as part of it";
        let message = || say!("the string `{}` has no quotes", line.value);
        report((&UNQUOTED_STRING, line.value_at), help, None, message, findings);
    }
}

fn check_negative(data_type: Option<DataType>, line: &SectionLine<'_>, findings: &mut Findings) {
    let digits = line.value.strip_prefix('-');
    if data_type.is_some_and(DataType::is_integer) && digits.is_some_and(is_hex) {
        let mut quirks = Quirks::default();
        let value = literal::value_in_line(line.value, data_type, &mut quirks).ok();
        let value = value.filter(|_| !quirks.has(Quirk::TrailingComment));
        let fix = value.map(|value| (line.value_at, literal::print(&value, literal::Spelling::default())));
        let message = || say!("`{}` is a negative hex number", line.value);
        report((&NEGATIVE_HEX, line.value_at), "write the number in decimal", fix, message, findings);
    }
}

fn check_limit(data_type: Option<DataType>, field: &Field, line: &SectionLine<'_>, findings: &mut Findings) {
    let Some(data_type) = data_type else { return };
    let reason = match data_type {
        _ if line.value.starts_with('$') => "a formula",
        DataType::REAL32 | DataType::REAL64
            if line.value.contains(['.', 'e', 'E']) && !is_hex(line.value) =>
        {
            "a REAL"
        }
        DataType::INTEGER24 | DataType::INTEGER40 | DataType::INTEGER48 | DataType::INTEGER56 => {
            "of an integer type of unusual width"
        }
        _ => return,
    };
    let message = || say!("`{}` is {}", field, reason);
    report((&LIMIT_NOT_READ, line.value_at), "check the limits in the application", None, message, findings);
}
/// The bits of a REAL in hex; `None` if a comment would be lost.
fn bits_of(text: &str, data_type: Option<DataType>) -> Option<String> {
    let mut quirks = Quirks::default();
    let value = literal::value_in_line(text, data_type, &mut quirks).ok()?;
    let spelling = literal::Spelling { real: literal::RealSpelling::Hex, ..literal::Spelling::default() };
    (!quirks.has(Quirk::TrailingComment)).then(|| literal::print(&value, spelling))
}

fn is_hex(value: &str) -> bool {
    value.get(..2).is_some_and(|mark| mark.eq_ignore_ascii_case("0x"))
}

fn check_bare_node_id(data_type: Option<DataType>, line: &SectionLine<'_>, findings: &mut Findings) {
    let is_integer = data_type.is_some_and(DataType::is_integer);
    if is_integer && line.value.eq_ignore_ascii_case("$NODEID") {
        let message = say!("`{}` has no number to add", line.value);
        let fix = Fix::safe("write `$NODEID+0`").replace(line.value_at, "$NODEID+0");
        findings
            .push(Diagnostic::new(&BARE_NODE_ID, line.value_at, message).help("write `$NODEID+0`").fix(fix));
    }
}

/// Whether a value may contain any characters; `data_type` is the type of a device's value.
fn is_text(section: &CheckedSection<'_>, line: &SectionLine<'_>, data_type: Option<DataType>) -> bool {
    if let Some(data_type) = data_type {
        return matches!(data_type.kind(), TypeKind::VisibleString | TypeKind::UnicodeString);
    }
    match (section.part(), line.field()) {
        (Part::Comments | Part::CompactNames(_) | Part::CompactDenotations(_), None) => true,
        (_, Some(field)) => matches!(
            field,
            Field::ParameterName
                | Field::Denotation
                | Field::Description
                | Field::CreatedBy
                | Field::ModifiedBy
                | Field::VendorName
                | Field::ProductName
                | Field::OrderCode
                | Field::NodeName
                | Field::NodeRefd
                | Field::NetworkName
                | Field::NetRefd
                | Field::ParamRefd
                | Field::UploadFile
                | Field::DownloadFile
        ),
        (_, None) => false,
    }
}

/// A `;` or `#` after a space starts a comment in Python's INI reader, if configured so.
fn check_text(section: &CheckedSection<'_>, line: &SectionLine<'_>, findings: &mut Findings) {
    // spaces between `=` and the value are part of it
    let behind_key = crate::source::Span::new(line.name_at.end, line.value_at.end).of(section.text);
    let is_behind_blank = |mark: char| {
        behind_key.match_indices(mark).any(|(at, _)| behind_key[..at].ends_with(|c: char| c.is_whitespace()))
    };
    let shown: String = line.value.chars().take(60).collect();
    for (rule, mark) in [(&SEMICOLON_IN_TEXT, ';'), (&HASH_IN_TEXT, '#')] {
        if is_behind_blank(mark) {
            let message = say!("a space precedes the `{}` in `{}`", mark, shown);
            let finding = Diagnostic::new(rule, line.value_at, message);
            findings.push(finding.help(say!("remove the space before the `{}`", mark)));
            return;
        }
    }
}
