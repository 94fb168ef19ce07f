//! The rules about the spelling of values: the rule for each quirk, and its help.

use super::{Quirk, Quirks, respell, trailing_comment};
use crate::diagnostic::{At, Change, Diagnostic, Findings, Fix, RuleInfo, say, text_rules};
use crate::model::Value;
use crate::source::Span;

/// The rule about quotes, which also applies to names.
pub static QUOTED: &RuleInfo = &QUOTED_STRING;

/// Reports the spelling of `text`, whose key and value are at `name_at` and `at` in a line; `value` is the
/// parsed value.
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
        let spelled = respell(text, quirk, value);
        let mut finding = finding(text, at.into(), (quirk, rule, help), spelled.as_deref());
        finding.fix = spelled.map(|spelled| {
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

/// Reports the spelling of `text` at `at` in XML; `value` is the parsed value.
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
        let respelled = respell(text, quirk, value);
        let mut finding = finding(text, at.clone(), (quirk, rule, help), respelled.as_deref());
        if let At::Span(span) = at {
            let plain = respelled.filter(|text| !text.contains(['&', '<', '>', '"', '\'']));
            finding.fix = plain.map(|text| fix_of(quirk, &text).replace(span, text));
        }
        findings.push(finding);
    }
}

/// The rules violated by quirks, each with its help.
fn found(quirks: Quirks) -> impl Iterator<Item = (Quirk, &'static RuleInfo, &'static str)> {
    SPELLINGS.into_iter().filter(move |(quirk, ..)| {
        // the fix of the order also corrects the spelling
        let explained = *quirk == Quirk::FormulaSpelling && quirks.has(Quirk::NodeIdLast);
        quirks.has(*quirk) && !explained
    })
}

/// A finding; its help states the correct value if the table only describes it.
fn finding(
    text: &str,
    at: At,
    (quirk, rule, help): (Quirk, &'static RuleInfo, &'static str),
    spelled: Option<&str>,
) -> Diagnostic {
    let is_described = matches!(quirk, Quirk::FormulaSpelling | Quirk::NodeIdLast | Quirk::AboveType);
    let help = spelled.filter(|_| is_described).map_or(help.into(), |value| say!("write `{}`", value));
    Diagnostic::new(rule, at, say!("`{}` {}", text, rule_text(quirk))).help(help)
}

/// A fix without its change. The tools of Lely need quoted strings and REAL numbers as bits.
fn fix_of(quirk: Quirk, text: &str) -> Fix {
    match quirk {
        Quirk::Quoted => Fix::risky("remove the quotes"),
        Quirk::RealAsBits | Quirk::AboveType => Fix::risky(say!("write `{}`", text)),
        Quirk::TrailingComment => Fix::safe("put the comment on a separate line"),
        _ => Fix::safe(say!("write `{}`", text)),
    }
}

const SPELLINGS: [(Quirk, &RuleInfo, &str); 12] = [
    (Quirk::Octal, &OCTAL_NUMBER, "write the number in decimal without leading zeros, or in hex"),
    (Quirk::LeadingZero, &LEADING_ZERO, "remove the leading zero"),
    (Quirk::NodeIdLast, &NODE_ID_LAST, "write `$NODEID+` first, then the number"),
    (Quirk::FormulaSpelling, &FORMULA_SPELLING, "write `$NODEID+` and the number, without spaces"),
    (Quirk::TrailingComment, &TRAILING_COMMENT, "put the comment on a separate line"),
    (Quirk::CSuffix, &NUMBER_SUFFIX, "remove the suffix"),
    (Quirk::RealAsBits, &REAL_AS_BITS, "write the number with a decimal point, unless the file is for Lely"),
    (Quirk::TwosComplement, &TWOS_COMPLEMENT, "write the negative number in decimal"),
    (Quirk::Quoted, &QUOTED_STRING, "remove the quotes, unless the file is for Lely"),
    (Quirk::BooleanWord, &BOOLEAN_WORD, "write 1 for true, 0 for false"),
    (Quirk::DecoratedBytes, &HEX_PREFIX_IN_BYTES, "write exactly two hex digits per byte"),
    (Quirk::AboveType, &LIMIT_ABOVE_TYPE, "write the limit in decimal, or correct the data type"),
];

fn rule_text(quirk: Quirk) -> &'static str {
    match quirk {
        Quirk::Octal => "is octal because of the leading `0`; other tools read it as decimal",
        Quirk::LeadingZero => "has a leading zero",
        Quirk::NodeIdLast => "does not start with `$NODEID`; some tools drop the node-ID",
        Quirk::FormulaSpelling => "is not spelled `$NODEID+number`",
        Quirk::TrailingComment => "has a comment after the value",
        Quirk::CSuffix => "has a C suffix",
        Quirk::RealAsBits => "is read as the bits of a REAL; other tools read it as a number",
        Quirk::TwosComplement => "is read as two's complement; other tools read it as a positive number",
        Quirk::Quoted => "is in quotes, which are not part of the string",
        Quirk::BooleanWord => "is a word, but a BOOLEAN is 0 or 1",
        Quirk::DecoratedBytes => "contains more than hex digits",
        Quirk::AboveType => "is too large for the signed data type and is read as its largest value",
    }
}

text_rules! {
    source: "CiA 306-1 §4.3";

    "cia306/octal-number" = OCTAL_NUMBER, Warning, fix Safe;
    summary: "a number with a leading zero is octal",
    checks: "Reports a number that starts with `0` and has a different value in decimal. The number is read as octal.",
    why: "The standard defines octal, .NET tools and npm's canopen read decimal, and python-canopen rejects the number.",
    example: "`DefaultValue=010` is 8",
    remedy: "Write the intended number in decimal or hex.",

    "cia306/leading-zero" = LEADING_ZERO, Note, fix Safe;
    summary: "a number has a leading zero",
    checks: "Reports a decimal number that starts with `0` and has the same value in octal.",
    why: "Python's readers reject the number.",
    example: "`FileRevision=07`",
    remedy: "Write `7`.",

    "cia306/node-id-last" = NODE_ID_LAST, Warning, fix Safe;
    summary: "`$NODEID` does not come first",
    checks: "A formula must start with `$NODEID`. The other order is also read.",
    why: "For the standard, such a text is not a formula. dcf-tools rejects the file; Lely's C parser reads the number without the node-ID.",
    example: "`DefaultValue=0x180+$NODEID`",
    remedy: "Write `$NODEID+0x180`.",

    "cia306/formula-spelling" = FORMULA_SPELLING, Note, fix Safe;
    summary: "a formula has spaces or lower-case letters",
    checks: "A formula must be written `$NODEID+number`.",
    why: "Some tools compare case-sensitively and without trimming.",
    example: "`$NodeId + 0x180`",
    remedy: "Write `$NODEID+0x180`.",

    "cia306/trailing-comment" = TRAILING_COMMENT, Warning, fix Safe;
    summary: "a comment follows a number or keyword",
    checks: "Reports a space and `;`, `#` or `//`, or `;` and a space, after a value that cannot contain them. In names and strings they are part of the text. Without a space, `1;2` and `16#3E8` are not numbers.",
    why: "The standard has no such comments: other tools read the whole text as the value, which is then not a number.",
    example: "`DataType=0x0007 ; UNSIGNED32`",
    remedy: "Put the comment on a separate line.",
    source: "CiA 306-1 §4.2",

    "cia306/number-suffix" = NUMBER_SUFFIX, Warning, fix Safe;
    summary: "a number has a C suffix",
    checks: "`L`, `LL`, `U` or `f` must not follow a number. The suffix is ignored.",
    why: "An EDS has no suffixes; five of six other tools reject the file.",
    example: "`DefaultValue=0x1234567890ABCDEFLL`",
    remedy: "Remove the suffix.",

    "cia306/real-as-bits" = REAL_AS_BITS, Note, fix Safe;
    summary: "a REAL is written as the hex digits of its bits",
    checks: "Reports a REAL32 or REAL64 in hex. The number is read as the bits of IEEE 754.",
    why: "The standard does not define the notation of a REAL. Lely reads bits, but python-canopen and npm's canopen do not.",
    example: "`DefaultValue=0x3F800000`",
    remedy: "Write `1.0`, unless the file is for Lely.",
    source: "CiA 306-1 §4.3 does not define it",

    "cia306/twos-complement" = TWOS_COMPLEMENT, Note, fix Safe;
    summary: "a negative number is written as two's complement",
    checks: "Reports a hex number of a signed type whose sign bit is set. The number is read as negative.",
    why: "Lely reads the largest positive number instead; dcf-tools and npm's canopen reject it.",
    example: "`LowLimit=0x80000000` of an INTEGER32",
    remedy: "Write `-2147483648`.",
    source: "CiA 306-1 §4.3 does not define it",

    "cia306/quoted-string" = QUOTED_STRING, Warning, fix Mixed;
    summary: "a string is in quotes",
    checks: r#"Reports a value of a string type that starts and ends with `"`; the quotes are ignored. Names and other texts of the device are also reported, but read with their quotes."#,
    why: "An EDS has strings without quotes. python-canopen and others make the quotes part of the text.",
    example: r#"`DefaultValue="IO block"`"#,
    remedy: "Remove the quotes, unless the file is for Lely's dcfgen.",

    "cia306/boolean-word" = BOOLEAN_WORD, Warning, fix Safe;
    summary: "a BOOLEAN is written as a word",
    checks: "A BOOLEAN must not be `true` or `false`.",
    why: "An EDS uses 0 and 1; other tools reject the words.",
    example: "`DefaultValue=true`",
    remedy: "Write `1`.",

    "cia306/hex-prefix-in-bytes" = HEX_PREFIX_IN_BYTES, Warning, fix Safe;
    summary: "bytes are not written as plain hex digits",
    checks: "The value of an OCTET_STRING or DOMAIN must not have a `0x` prefix or spaces between its hex digits.",
    why: "The standard defines two digits per byte and nothing else; other tools drop the value.",
    example: "`DefaultValue=0x01 A1 05`",
    remedy: "Write `01A105`.",

    "cia306/limit-above-type" = LIMIT_ABOVE_TYPE, Warning, fix Mixed;
    summary: "a high limit in hex is above its signed data type",
    checks: "Reports a `HighLimit` of a signed type in hex with the sign bit set. This applies if, as two's complement, it is below `LowLimit`, `DefaultValue` or `ParameterValue`, or is -1 without a `LowLimit`. It is read as the largest number of the type, as in Lely.",
    why: "dcf-tools rejects the file; python-canopen reads a negative limit that no value is within.",
    example: "`LowLimit=0` and `HighLimit=0xFFFFFFFF` of an INTEGER32",
    remedy: "Write the largest number, `2147483647`, or correct the data type.",
    source: "CiA 306-1 §4.6.3.2",
}
