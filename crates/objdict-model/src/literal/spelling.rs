//! The rules about how a value is spelled: which one each quirk breaks, and what to write instead.

use super::{Quirk, Quirks, respell, trailing_comment};
use crate::diagnostic::{At, Change, Diagnostic, Findings, Fix, RuleInfo, say, text_rule};
use crate::model::Value;
use crate::source::Span;

/// Every rule about spelling.
pub static RULES: &[&RuleInfo] = &[
    &OCTAL_NUMBER,
    &LEADING_ZERO,
    &NODE_ID_LAST,
    &FORMULA_SPELLING,
    &TRAILING_COMMENT,
    &NUMBER_SUFFIX,
    &REAL_AS_BITS,
    &TWOS_COMPLEMENT,
    &QUOTED_STRING,
    &BOOLEAN_WORD,
    &DECORATED_BYTES,
];

/// The rule about quotes, which also holds for names.
pub static QUOTED: &RuleInfo = &QUOTED_STRING;

/// The findings of the spelling of `text`, whose key and value stand at `name_at` and `at` in a line; `value` is what it was
/// read as.
pub fn spelling_in_line(
    text: &str,
    (name_at, at): (Span, Span),
    quirks: Quirks,
    value: Option<&Value>,
    findings: &mut Findings,
) {
    if quirks.is_empty() {
        return;
    }
    for (quirk, rule, help) in found(quirks) {
        let mut finding = finding(text, at.into(), quirk, rule, help);
        finding.fix = respell(text, quirk, value).map(|spelled| {
            let fix = fix_of(quirk, &spelled).replace(at, spelled);
            let comment = trailing_comment(text).filter(|comment| !comment.is_empty());
            match comment.filter(|_| quirk == Quirk::TrailingComment) {
                Some(comment) => fix.with(Change::Comment(name_at, comment.to_owned())),
                None => fix,
            }
        });
        findings.push(finding);
    }
}

/// The findings of the spelling of `text`, which stands at `at` in XML; `value` is what it was read as.
pub fn spelling(
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
            let respelled = respell(text, quirk, value);
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
    Diagnostic::new(rule, at, say!("`{}` {}", text, rule_text(quirk))).help(help)
}

/// A fix without its change. Lely's tools want quotes around strings and REAL numbers as bits.
fn fix_of(quirk: Quirk, text: &str) -> Fix {
    match quirk {
        Quirk::Quoted => Fix::risky("remove the quotes"),
        Quirk::RealAsBits => Fix::risky(say!("write `{}`", text)),
        Quirk::TrailingComment => Fix::safe("put the comment on a line of its own"),
        _ => Fix::safe(say!("write `{}`", text)),
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

text_rule! {
    OCTAL_NUMBER = "cia306/octal-number", Warning, fix Safe;
    summary: "a number with a leading zero is octal",
    checks: "Whether a number starts with `0` and would be another one in decimal. It is read as octal.",
    why: "The standard says octal, .NET tools and npm's canopen read decimal, python-canopen refuses it.",
    example: "`DefaultValue=010` is 8",
    remedy: "Write the number that you mean in decimal or hex.",
    source: "CiA 306-1 §4.3",
}

text_rule! {
    LEADING_ZERO = "cia306/leading-zero", Note, fix Safe;
    summary: "a number has a leading zero",
    checks: "Whether a decimal number starts with `0` and is the same in octal.",
    why: "Python's readers refuse the number.",
    example: "`FileRevision=07`",
    remedy: "Write `7`.",
    source: "CiA 306-1 §4.3",
}

text_rule! {
    NODE_ID_LAST = "cia306/node-id-last", Warning, fix Safe;
    summary: "`$NODEID` does not come first",
    checks: "Whether a formula starts with `$NODEID`. The other order is understood.",
    why: "The standard takes such a text for no formula. dcf-tools refuses the file, the C parser of Lely reads the number alone and forgets the node-ID.",
    example: "`DefaultValue=0x180+$NODEID`",
    remedy: "Write `$NODEID+0x180`.",
    source: "CiA 306-1 §4.3",
}

text_rule! {
    FORMULA_SPELLING = "cia306/formula-spelling", Note, fix Safe;
    summary: "a formula has blanks or lower-case letters",
    checks: "Whether formulas are spelt `$NODEID+number`.",
    why: "Some tools compare letter by letter.",
    example: "`$NodeId + 0x180`",
    remedy: "Write `$NODEID+0x180`.",
    source: "CiA 306-1 §4.3",
}

text_rule! {
    TRAILING_COMMENT = "cia306/trailing-comment", Warning, fix Safe;
    summary: "a comment stands behind a number or keyword",
    checks: "Whether `;`, `#` or `//` follows a value that cannot hold it. In names and strings they are text.",
    why: "The standard has no such comments: to other tools the whole text is the value, and it is no number.",
    example: "`DataType=0x0007 ; UNSIGNED32`",
    remedy: "Put the comment on a line of its own.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    NUMBER_SUFFIX = "cia306/number-suffix", Warning, fix Safe;
    summary: "a number has a suffix of the C language",
    checks: "Whether `L`, `LL`, `U` or `f` follows a number. It is read without it.",
    why: "An EDS knows no suffixes; five of six other tools refuse the file.",
    example: "`DefaultValue=0x1234567890ABCDEFLL`",
    remedy: "Remove the suffix.",
    source: "CiA 306-1 §4.3",
}

text_rule! {
    REAL_AS_BITS = "cia306/real-as-bits", Note, fix Unsafe;
    summary: "a REAL is written as the hex digits of its bits",
    checks: "Whether a REAL32 or REAL64 is a hex number. It is read as the bits of IEEE 754.",
    why: "The standard does not say how a REAL is written. Lely reads bits, python-canopen and npm's canopen do not.",
    example: "`DefaultValue=0x3F800000`",
    remedy: "Write `1.0`, unless the file is for Lely.",
    source: "CiA 306-1 §4.3 is silent",
}

text_rule! {
    TWOS_COMPLEMENT = "cia306/twos-complement", Note, fix Safe;
    summary: "a negative number is written as two's complement",
    checks: "Whether a hex number of a signed type has its sign bit set. It is read as the negative number.",
    why: "Lely reads the largest positive number instead, dcf-tools and npm's canopen refuse it.",
    example: "`LowLimit=0x80000000` of an INTEGER32",
    remedy: "Write `-2147483648`.",
    source: "CiA 306-1 §4.3 is silent",
}

text_rule! {
    QUOTED_STRING = "cia306/quoted-string", Warning, fix Unsafe;
    summary: "a string stands in quotes",
    checks: r#"Whether the value of a string type starts and ends with `"`; it is read without them. Names and other texts about the device are reported too, but read with their quotes."#,
    why: "An EDS stores strings without quotes. python-canopen and others make the quotes a part of the text.",
    example: r#"`DefaultValue="IO block"`"#,
    remedy: "Remove the quotes, unless the file is for Lely's dcfgen.",
    source: "CiA 306-1 §4.3",
}

text_rule! {
    BOOLEAN_WORD = "cia306/boolean-word", Warning, fix Safe;
    summary: "a BOOLEAN is written as a word",
    checks: "Whether a BOOLEAN is `true` or `false`.",
    why: "An EDS has 0 and 1; other tools refuse the words.",
    example: "`DefaultValue=true`",
    remedy: "Write `1`.",
    source: "CiA 306-1 §4.3",
}

text_rule! {
    DECORATED_BYTES = "cia306/decorated-bytes", Warning, fix Safe;
    summary: "bytes are not written as plain hex digits",
    checks: "Whether the value of an OCTET_STRING or DOMAIN has a `0x` before or blanks between its hex digits.",
    why: "The standard has two digits a byte and nothing else; other tools lose the value.",
    example: "`DefaultValue=0x01 A1 05`",
    remedy: "Write `01A105`.",
    source: "CiA 306-1 §4.3",
}
