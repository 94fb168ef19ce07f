//! The findings of a value's spelling: which rule each quirk breaks, and what to write instead.

use super::findings::{
    BOOLEAN_WORD, DECORATED_BYTES, FORMULA_SPELLING, LEADING_ZERO, NODE_ID_LAST, NUMBER_SUFFIX, OCTAL_NUMBER,
    QUOTED_STRING, REAL_AS_BITS, TRAILING_COMMENT, TWOS_COMPLEMENT,
};
use super::read::Item;
use crate::diagnostic::{At, Diagnostic, Findings, RuleInfo};
use crate::format::literal::{Quirk, Quirks};

/// The findings of a value's spelling.
pub(crate) fn quirks(item: &Item<'_>, quirks: Quirks, findings: &mut Findings) {
    spelling(item.value, item.value_at, quirks, findings);
}

/// The findings of the spelling of `value`, which stands at `at`.
pub(crate) fn spelling(value: &str, at: impl Into<At>, quirks: Quirks, findings: &mut Findings) {
    if quirks.is_empty() {
        return;
    }
    let at = at.into();
    for (quirk, rule, help) in SPELLINGS {
        // who turns a formula around spells it anew
        let explained = quirk == Quirk::FormulaSpelling && quirks.has(Quirk::NodeIdLast);
        if quirks.has(quirk) && !explained {
            let finding = Diagnostic::new(rule, at.clone(), format!("`{value}` {}", rule_text(quirk)));
            findings.push(finding.help(help));
        }
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
