//! Names that are placeholders, too long, or contradict their entry.

use crate::EntryAt;
use crate::diagnostic::{Findings, Fix, say, sub_index};
use crate::model::{DataType, Device, Field, Object, Place, TypeKind};
use crate::rule::rules;

rules! {
    source: "Not in a standard";

    "naming/long-name" = LONG_NAME, Note, Entry(long_name);
    summary: "a name is longer than a line of text",
    checks: "Whether each name has at most 100 characters. The limit of CiA 306-1, 241, applies to the line and has its own rule.",
    why: "Tools show names in columns and truncate them, identifiers made from them lose their end, and often the text is a description.",
    example: "A `ParameterName` of two sentences",
    remedy: "Shorten the name; move explanations to a comment or the manual.",

    "naming/placeholder" = PLACEHOLDER, Note, Entry(placeholder);
    summary: "a name is a placeholder",
    checks: "Whether a name is a default name of a tool or a reminder of the author: `New object`, `Unnamed`, `Untitled`, `No name`, `TODO`, `TBD`, `FIXME`, `xxx`, `asdf`, `foo`, `bar`.",
    why: "Users of the device cannot know the purpose of the entry.",
    example: "`ParameterName=New object`",
    remedy: "Write a descriptive name.",

    "naming/repeated-blanks" = REPEATED_BLANKS, Note, Entry(repeated_blanks), fix Unsafe;
    summary: "a name has extra spaces",
    checks: "Whether a name starts or ends with a space, or has two spaces in a row.",
    why: "Tools that look up an entry by the visible name do not find it, and comparisons show changes that are not visible.",
    example: "`ParameterName=Motor  speed`",
    remedy: "Remove the extra spaces.",

    "naming/type-in-name" = TYPE_IN_NAME, Note, Entry(type_in_name);
    summary: "the name contains another type than the entry has",
    checks: "Whether a name that ends with a type, such as `_U16`, `INT8` or `(REAL32)`, matches width and kind of the entry.",
    why: "The type was changed without the name, or vice versa. Programs that rely on the name read the wrong number of bytes.",
    example: "`ParameterName=Speed_U16` with `DataType=0x0007`",
    remedy: "Correct the type or the name.",

    "naming/unordered-numbering" = UNORDERED_NUMBERING, Note, Object(unordered_numbering);
    summary: "the numbers in element names are not in the order of the sub-indexes",
    checks: "Whether numbered element names of an object from 2000h on ascend with the sub-indexes, from any start. Checked are objects whose elements share one name followed by consecutive numbers. Numbers with gaps or repetitions have another purpose and are not checked.",
    why: "Usually lines were swapped: software that sets element 3 by its name sets another element.",
    example: "`[2000sub1]` to `[2000sub3]` called `Input 1`, `Input 3` and `Input 2`",
    remedy: "Number the names in the order of the sub-indexes.",
}

/// The maximum length of a name that is not reported.
const LONGEST_NAME: usize = 100;

fn long_name(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    // another rule reports a line that is too long
    if name.len() <= LONGEST_NAME || name.len() > 241 {
        return;
    }
    let length = name.chars().count();
    if length > LONGEST_NAME {
        let message = say!("the name has {} characters", length);
        let finding = LONG_NAME.at(at.field(Field::ParameterName), message);
        findings.push(finding.help("shorten the name, and move the description to a comment or the manual"));
    }
}

const PLACEHOLDERS: [&str; 14] = [
    "new object",
    "new entry",
    "new item",
    "unnamed",
    "untitled",
    "no name",
    "noname",
    "todo",
    "tbd",
    "fixme",
    "xxx",
    "asdf",
    "foo",
    "bar",
];

fn placeholder(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    // the longest placeholder has ten characters
    if name.len() > 10 || !PLACEHOLDERS.iter().any(|placeholder| placeholder.eq_ignore_ascii_case(name)) {
        return;
    }
    let message = say!("`{}` is a placeholder", name);
    findings.push(PLACEHOLDER.at(at.field(Field::ParameterName), message).help("write a descriptive name"));
}

fn repeated_blanks(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    let bytes = name.as_bytes();
    let at_end = [bytes.first(), bytes.last()].into_iter().flatten().any(|&byte| byte == b' ');
    let is_repeated = || bytes.windows(2).any(|pair| pair == b"  ");
    if !at_end && !is_repeated() {
        return;
    }
    let clean = name.split(' ').filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
    if clean.is_empty() {
        return;
    }
    let place = at.field(Field::ParameterName);
    let message = say!("`{}` has extra spaces", name);
    let fix = Fix::risky("remove the extra spaces").set(place.clone(), clean.as_str());
    findings.push(REPEATED_BLANKS.at(place, message).help(say!("write `{}`", clean)).fix(fix));
}

fn type_in_name(at: &EntryAt<'_>, findings: &mut Findings) {
    // some editors give sub-index 0 the name of the object
    let Some(data_type) = at.entry.data_type.filter(|_| at.sub != Some(0)) else { return };
    let Some((named, text)) = named_type(&at.entry.name) else { return };
    let is_other = data_type.kind() != named && data_type.bit_length().is_some();
    if !is_other || !at.holds_value() {
        return;
    }
    let message = say!("the name ends with `{}`, but the entry is {}", text, data_type);
    let finding = TYPE_IN_NAME.at(at.field(Field::DataType), message);
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

fn unordered_numbering(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if index < 0x2000 || object.compact.is_some() {
        return;
    }
    let Some((first, second)) = first_disorder(object) else { return };
    let name = |sub| object.subs.get(sub).map_or("", |entry| &entry.name);
    let message = say!(
        "sub-index {} is `{}`, but sub-index {} is `{}`",
        sub_index(first),
        name(first),
        sub_index(second),
        name(second)
    );
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding = UNORDERED_NUMBERING.at(place(second), message).label(place(first), "the previous element");
    findings.push(finding.help("number the names in the order of the sub-indexes"));
}

/// The first two neighbours whose numbers do not ascend, if the numbers of all elements are consecutive.
fn first_disorder(object: &Object) -> Option<(u8, u8)> {
    let mut elements = object.subs.iter().filter(|&(sub, _)| sub > 0 && sub < 0xFF);
    let (sub, entry) = elements.next()?;
    let (stem, start) = numbered(&entry.name)?;
    let (mut last, mut lowest, mut highest, mut sum, mut count) =
        ((sub, start), start, start, u64::from(start), 1u64);
    let mut broken = None;
    for (sub, entry) in elements {
        let (_, number) = numbered(&entry.name).filter(|(other, _)| *other == stem)?;
        if number <= last.1 {
            broken.get_or_insert((last.0, sub));
        }
        (lowest, highest) = (lowest.min(number), highest.max(number));
        (sum, count, last) = (sum + u64::from(number), count + 1, (sub, number));
    }
    let (lowest, highest) = (u64::from(lowest), u64::from(highest));
    let is_row = highest - lowest + 1 == count && (lowest + highest) * count == 2 * sum;
    broken.filter(|_| is_row && is_unique(object, lowest))
}

/// Whether all numbers are different; the caller has checked that they are in a range as long as the number
/// of elements.
fn is_unique(object: &Object, lowest: u64) -> bool {
    let mut seen = [false; 256];
    object.subs.iter().filter(|&(sub, _)| sub > 0 && sub < 0xFF).all(|(_, entry)| {
        let at =
            numbered(&entry.name).and_then(|(_, number)| usize::try_from(u64::from(number) - lowest).ok());
        at.and_then(|at| seen.get_mut(at)).is_some_and(|seen| !std::mem::replace(seen, true))
    })
}

/// A name that ends with a number: its stem, and the number.
fn numbered(name: &str) -> Option<(&str, u32)> {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = name.get(stem.len()..)?;
    if stem.is_empty() || number.is_empty() { None } else { Some((stem, number.parse().ok()?)) }
}
