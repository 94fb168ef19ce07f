//! The findings of a value's spelling: which rule each quirk breaks, and what to write instead.

use super::findings::{
    BOOLEAN_WORD, DECORATED_BYTES, FORMULA_SPELLING, LEADING_ZERO, NODE_ID_LAST, NUMBER_SUFFIX, OCTAL_NUMBER,
    QUOTED_STRING, REAL_AS_BITS, TRAILING_COMMENT, TWOS_COMPLEMENT,
};
use super::read::Item;
use crate::diagnostic::{At, Change, Diagnostic, Findings, Fix, RuleInfo};
use crate::format::literal::{self, Quirk, Quirks};
use crate::model::Value;

/// The findings of a value's spelling in a line; `value` is what it was read as.
pub(crate) fn quirks(item: &Item<'_>, quirks: Quirks, value: Option<&Value>, findings: &mut Findings) {
    if quirks.is_empty() {
        return;
    }
    for (quirk, rule, help) in found(quirks) {
        let mut finding = finding(item.value, item.value_at.into(), quirk, rule, help);
        finding.fix = literal::respell(item.value, quirk, value).map(|text| {
            let fix = fix_of(quirk, &text).replace(item.value_at, text);
            let comment = literal::trailing_comment(item.value).filter(|comment| !comment.is_empty());
            match comment.filter(|_| quirk == Quirk::TrailingComment) {
                Some(comment) => fix.with(Change::Comment(item.name_at, comment.to_owned())),
                None => fix,
            }
        });
        findings.push(finding);
    }
}

/// The findings of the spelling of `text`, which stands at `at` in XML; `value` is what it was read as.
pub(crate) fn spelling(
    text: &str,
    at: impl Into<At>,
    quirks: Quirks,
    value: Option<&Value>,
    findings: &mut Findings,
) {
    if quirks.is_empty() {
        return;
    }
    let at = at.into();
    for (quirk, rule, help) in found(quirks) {
        let mut finding = finding(text, at.clone(), quirk, rule, help);
        // a comment has no place beside an attribute
        if let At::Span(span) = at
            && quirk != Quirk::TrailingComment
        {
            let respelled = literal::respell(text, quirk, value);
            let plain = respelled.filter(|text| !text.contains(['&', '<', '>', '"', '\'']));
            finding.fix = plain.map(|text| fix_of(quirk, &text).replace(span, text));
        }
        findings.push(finding);
    }
}

/// The rules that quirks break, each with its advice.
fn found(quirks: Quirks) -> impl Iterator<Item = (Quirk, &'static RuleInfo, &'static str)> {
    SPELLINGS.into_iter().filter(move |(quirk, ..)| {
        // who turns a formula around spells it anew
        let explained = *quirk == Quirk::FormulaSpelling && quirks.has(Quirk::NodeIdLast);
        quirks.has(*quirk) && !explained
    })
}

fn finding(text: &str, at: At, quirk: Quirk, rule: &'static RuleInfo, help: &'static str) -> Diagnostic {
    Diagnostic::new(rule, at, format!("`{text}` {}", rule_text(quirk))).help(help)
}

/// A fix without its change. Lely's tools want quotes around strings and REAL numbers as bits.
fn fix_of(quirk: Quirk, text: &str) -> Fix {
    match quirk {
        Quirk::Quoted => Fix::risky("remove the quotes"),
        Quirk::RealAsBits => Fix::risky(format!("write `{text}`")),
        Quirk::TrailingComment => Fix::safe("put the comment on a line of its own"),
        _ => Fix::safe(format!("write `{text}`")),
    }
}

const SPELLINGS: [(Quirk, &RuleInfo, &str); 11] = [
    (Quirk::Octal, &OCTAL_NUMBER, "write the number in decimal without leading zeros, or in hex"),
    (Quirk::LeadingZero, &LEADING_ZERO, "remove the leading zero"),
    (Quirk::NodeIdLast, &NODE_ID_LAST, "write `$NODEID+` first and the number behind it"),
    (Quirk::FormulaSpelling, &FORMULA_SPELLING, "write `$NODEID+0x180`"),
    (Quirk::TrailingComment, &TRAILING_COMMENT, "put the comment on a line of its own"),
    (Quirk::CSuffix, &NUMBER_SUFFIX, "remove the suffix"),
    (Quirk::RealAsBits, &REAL_AS_BITS, "write the number with a decimal point, unless the file is for Lely"),
    (Quirk::TwosComplement, &TWOS_COMPLEMENT, "write the negative number in decimal"),
    (Quirk::Quoted, &QUOTED_STRING, "remove the quotes, unless the file is for Lely"),
    (Quirk::BooleanWord, &BOOLEAN_WORD, "write `1` or `0`"),
    (Quirk::DecoratedBytes, &DECORATED_BYTES, "write two hex digits a byte and nothing else"),
];

fn rule_text(quirk: Quirk) -> &'static str {
    match quirk {
        Quirk::Octal => "is octal, for it starts with `0`; other tools read it as decimal",
        Quirk::LeadingZero => "has a leading zero",
        Quirk::NodeIdLast => "does not start with `$NODEID`; other tools lose the node-ID",
        Quirk::FormulaSpelling => "is spelt in another way than `$NODEID+number`",
        Quirk::TrailingComment => "has a comment behind the value",
        Quirk::CSuffix => "has a suffix of the C language",
        Quirk::RealAsBits => "is read as the bits of a REAL; other tools take it for a number",
        Quirk::TwosComplement => "is read as two's complement; other tools take it for a positive number",
        Quirk::Quoted => "stands in quotes; they are not part of the string",
        Quirk::BooleanWord => "is a word; a BOOLEAN is 0 or 1",
        Quirk::DecoratedBytes => "has more than hex digits",
    }
}
