use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{DataType, Field, TypeKind};
use crate::{EntryAt, rule};

rule! {
    "naming/type-in-name", Note, Entry(check);
    summary: "the name contains another type than the entry has",
    checks: "Whether a name that ends with a type, such as `_U16`, `INT8` or `(REAL32)`, matches width and kind of the entry.",
    why: "The type was changed without the name, or vice versa. Programs that rely on the name read the wrong number of bytes.",
    example: "`ParameterName=Speed_U16` with `DataType=0x0007`",
    remedy: "Correct the type or the name.",
    source: "Not in a standard",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    // some editors give sub-index 0 the name of the object
    let Some(data_type) = at.entry.data_type.filter(|_| at.sub != Some(0)) else { return };
    let Some((named, text)) = named_type(&at.entry.name) else { return };
    let is_other = data_type.kind() != named && data_type.bit_length().is_some();
    if !is_other || !at.holds_value() {
        return;
    }
    let message = say!("the name ends with `{}`, but the entry is {}", text, data_type);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::DataType), message);
    let finding = finding.label(at.field(Field::ParameterName), "the name");
    findings.push(finding.help("correct the type or the name"));
}

/// The type at the end of a name: a known word and a width, after a character that is not a letter or digit.
fn named_type(name: &str) -> Option<(TypeKind, &str)> {
    let inner = name.trim_end_matches([')', ']']);
    let word = inner.rsplit(|c: char| !c.is_ascii_alphanumeric()).next()?;
    let kind = word.trim_end_matches(|c: char| c.is_ascii_digit());
    if word.len() == inner.len() || kind.len() == word.len() {
        return None;
    }
    let bits: u8 = word.get(kind.len()..)?.parse().ok()?;
    let matches = |words: &[&str]| words.iter().any(|known| known.eq_ignore_ascii_case(kind));
    let named = match bits {
        8 | 16 | 24 | 32 | 40 | 48 | 56 | 64 if matches(&["u", "uint", "unsigned"]) => {
            TypeKind::Unsigned(bits)
        }
        8 | 16 | 24 | 32 | 40 | 48 | 56 | 64 if matches(&["int", "integer", "sint"]) => {
            TypeKind::Signed(bits)
        }
        32 if matches(&["real", "float"]) => DataType::REAL32.kind(),
        64 if matches(&["real", "float"]) => DataType::REAL64.kind(),
        _ => return None,
    };
    Some((named, word))
}
