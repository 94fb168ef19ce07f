//! Creates the findings with their texts and fixes.

use super::{
    COMMISSIONING_SPELLING, DATE_SPELLING, DUPLICATE_KEY, DUPLICATE_SECTION, INVALID_LIST_ENTRY,
    LIST_NUMBERING, MAPPED_OTHERWISE, MISSING_HEADER, MISSPELT_KEY, MISSPELT_SECTION, SECTION_SPELLING,
    STRAY_COMPACT_SECTION, UNKNOWN_KEY, UNKNOWN_SECTION, WRONG_COUNT,
};
use crate::diagnostic::{Change, Diagnostic, Fix, Severity, counted, say};
use crate::eds::item::Item;
use crate::eds::keys::{FieldKey, is_meaning_key};
use crate::eds::section::{NameSpelling, SectionName, section_name};
use crate::literal::iec_number;
use crate::model::{Access, Device, Field, ObjectType, Part, PdoKind, Place, Reason};
use crate::source::Span;

/// `item` repeats `first`.
pub(in crate::eds) fn duplicate_key(item: &Item<'_>, first: &Item<'_>) -> Diagnostic {
    let same = item.value == first.value;
    let message = if same {
        say!("`{}` is defined twice with the same value", item.name)
    } else {
        say!(
            "`{}` is defined twice, as `{}` and `{}`; the first one is read",
            item.name,
            first.value,
            item.value
        )
    };
    let finding = Diagnostic::new(&DUPLICATE_KEY, item.name_at, message)
        .severity(if same { Severity::Warning } else { Severity::Error })
        .label(first.name_at, "first here")
        .help("remove one of the two lines");
    let is_idle = same || item.value.is_empty();
    let finding = finding.fix(without_line(item, is_idle));
    if is_idle { finding.understood() } else { finding }
}

/// The keys of a different section begin with `item`, which repeats `first`, in the section `name`.
pub(in crate::eds) fn missing_header(name: &str, item: &Item<'_>, first: &Item<'_>) -> Diagnostic {
    let message = say!("`{}` starts a new section inside `[{}]`, but its header is missing", item.name, name);
    Diagnostic::new(&MISSING_HEADER, item.name_at, message)
        .label(first.name_at, "the key of this section")
        .help("write the header above this line")
}

/// `item` of a list has the number of `other`; only `number` is unused.
pub(in crate::eds) fn repeated_number(item: &Item<'_>, other: &Item<'_>, number: u32) -> Diagnostic {
    let which = if item.name_at.start > other.name_at.start { "second" } else { "first" };
    let message = say!(
        "`{}` is defined twice and `{}` is missing: number the {} one {}",
        item.name,
        number,
        which,
        number
    );
    Diagnostic::new(&DUPLICATE_KEY, item.name_at, message)
        .label(other.name_at, "the other one")
        .help(say!("rename the key to `{}`", number))
        .fix(Fix::safe(say!("number the {} one {}", which, number)).replace(item.name_at, number.to_string()))
        .understood()
}

/// The first of `number` entries that are mapped in a direction that their access type excludes.
pub(in crate::eds) fn mapped_otherwise(
    device: &Device,
    (index, sub): (u16, u8),
    (kind, access): (PdoKind, Access),
    number: usize,
) -> Diagnostic {
    let is_single = device.object(index).is_some_and(|object| object.subs.get(sub).is_none());
    let place = if is_single { Place::object(index) } else { Place::entry(index, sub) };
    let others = number - 1;
    let also = match others {
        0 => String::new(),
        _ => format!("; also for {}", counted(others, "more entry", "more entries")),
    };
    let message =
        say!("{}s map the entry, so its `{}` of CANopenEditor is read as `rw`{}", kind, access.name(), also);
    Diagnostic::new(&MAPPED_OTHERWISE, place.field(Field::AccessType), message)
        .help("write the direction: `rww` for an output, `rwr` for an input, `rw` for both")
}

/// Removes a line that is not read, or comments it out if its content differs.
fn without_line(item: &Item<'_>, is_idle: bool) -> Fix {
    match is_idle {
        true => Fix::safe("remove the second, unread line").with(Change::RemoveLine(item.name_at)),
        false => Fix::safe("comment out the second, unread line").with(Change::CommentOut(item.name_at)),
    }
}

/// The relation of a section to an earlier one with the same name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::eds) enum DuplicateKind {
    /// Both are merged.
    Joined,
    /// The second section is equal and not read.
    Equal,
    /// The second section differs, or was not compared, and is not read.
    Other,
}

/// Reports a repeated section; `first` is the place of the earlier one in the model.
pub(in crate::eds) fn duplicate_section(
    name: &str,
    at: Span,
    first: Place,
    kind: DuplicateKind,
) -> Diagnostic {
    let read = if kind == DuplicateKind::Joined { "both are read" } else { "the first one is read" };
    let finding =
        Diagnostic::new(&DUPLICATE_SECTION, at, say!("section `[{}]` is defined twice; {}", name, read))
            .label(first, "first here")
            .help("remove one of the two sections");
    match kind {
        DuplicateKind::Joined => finding,
        DuplicateKind::Equal => {
            let fix = Fix::safe("remove the second, unread section").with(Change::RemoveSection(at));
            finding.fix(fix).understood()
        }
        DuplicateKind::Other => {
            let title = "comment out the second, unread section";
            finding.fix(Fix::safe(title).with(Change::CommentOut(at)))
        }
    }
}

pub(in crate::eds) fn unknown_section(name: &str, at: Span) -> Diagnostic {
    let hint = looks_like_object(name);
    let finding = Diagnostic::new(
        if hint { &SECTION_SPELLING } else { &UNKNOWN_SECTION },
        at,
        if hint {
            say!("`[{}]` is not a valid object section", name)
        } else {
            say!("unknown section `[{}]`; it is kept", name)
        },
    );
    if hint {
        finding.severity(Severity::Error).help(match decimal_sub(name) {
            Some((index, sub)) => {
                say!("write the sub-index in hex: decimal {} is `[{}sub{:X}]`", sub, index, sub)
            }
            None => "write an index of up to four hex digits and a sub-index up to FF: `[1018sub1]`".into(),
        })
    } else {
        finding.help("check the spelling; some tools reject unknown sections")
    }
}

/// The index and sub-index of a section whose sub-index is written in decimal: `[2000sub100]`.
fn decimal_sub(name: &str) -> Option<(&str, u8)> {
    let (index, sub) = name.split_at_checked(4)?;
    let digits = sub.get(..3).filter(|word| word.eq_ignore_ascii_case("sub")).map(|_| &sub[3..])?;
    let number = digits.parse().ok().filter(|number| (100..=254).contains(number))?;
    u16::from_str_radix(index, 16).ok().map(|_| (index, number))
}

/// Whether the name looks like an object's: hex digits with optional `0x`, optionally followed by
/// `sub`.
fn looks_like_object(name: &str) -> bool {
    let name = name.strip_prefix("0x").unwrap_or(name);
    let digits = name.bytes().take_while(u8::is_ascii_hexdigit).count();
    let rest = name[digits..].trim_ascii_start();
    let is_number = name.as_bytes().first().is_some_and(u8::is_ascii_digit);
    decimal_sub(name).is_some()
        || digits > 0
            && is_number
            && (rest.is_empty() || rest.get(..3).is_some_and(|word| word.eq_ignore_ascii_case("sub")))
}

pub(in crate::eds) fn unknown_key(item: &Item<'_>, section: &str) -> Diagnostic {
    if let Some(number) = item.hex_number() {
        let message = say!("the key `{}` is in hex; the standard spells it `{}`", item.name, number);
        let title = say!("rename the key to `{}`", number);
        let fix = Fix::risky(title.clone()).replace(item.name_at, number.to_string());
        return Diagnostic::new(&UNKNOWN_KEY, item.name_at, message)
            .severity(Severity::Warning)
            .help(title)
            .fix(fix);
    }
    let message = match item.key {
        Some(_) => say!("`{}` does not belong in `[{}]`; the key is kept", item.name, section),
        None => say!("unknown key `{}` in `[{}]`; it is kept", item.name, section),
    };
    let is_of_object = matches!(SectionName::parse(section).part, Part::Object(_) | Part::Entry(..));
    Diagnostic::new(&UNKNOWN_KEY, item.name_at, message).help(
        match is_of_object && is_meaning_key(item.name) {
            true => {
                "keep the key for python-canopen, which reads it; other tools ignore or reject unknown keys"
            }
            false => "check the spelling; some tools reject unknown keys",
        },
    )
}

/// Reports a misspelt key that is read as `meant`.
pub(in crate::eds) fn misspelt_key(item: &Item<'_>, meant: FieldKey) -> Diagnostic {
    // as severe as the resulting missing key or count
    let (severity, effect) = match meant.field() {
        Field::SupportedObjects | Field::NrOfEntries => (Severity::Error, "see no entry or reject the file"),
        Field::ObjectType | Field::DataType | Field::AccessType | Field::SubNumber => {
            (Severity::Error, "ignore the misspelt key")
        }
        _ => (MISSPELT_KEY.severity, "ignore the misspelt key"),
    };
    let meant = meant.field().name();
    let message = say!("unknown key `{}`, probably a misspelt `{}`", item.name, &*meant);
    let fix = Fix::risky(say!("write `{}`", &*meant)).replace(item.name_at, &*meant);
    Diagnostic::new(&MISSPELT_KEY, item.name_at, message)
        .severity(severity)
        .understood()
        .help(say!("write `{}`; other tools {}", &*meant, effect))
        .fix(fix)
}

/// Reports a date or time that is not spelled as `meant`; `is_certain` if it is unambiguous.
pub(in crate::eds) fn date_spelling(item: &Item<'_>, meant: String, is_certain: bool) -> Diagnostic {
    let form = if meant.contains(':') { "`hh:mmAM` or `hh:mmPM`" } else { "`mm-dd-yyyy`" };
    let title = say!("write `{}`", meant);
    let fix = if is_certain { Fix::safe(title.clone()) } else { Fix::risky(title.clone()) };
    Diagnostic::new(&DATE_SPELLING, item.value_at, say!("`{}` is not of the form {}", item.value, form))
        .help(title)
        .fix(fix.replace(item.value_at, meant))
}

/// Reports a misspelt section that is read as `part`.
pub(in crate::eds) fn misspelt_section(name: &str, part: &Part, at: Span) -> Diagnostic {
    let meant = section_name(part).unwrap_or_default();
    let message = say!("unknown section `[{}]`, probably a misspelt `[{}]`", name, meant);
    let fix = Fix::risky(say!("write `[{}]`", meant)).replace(at, meant.as_str());
    Diagnostic::new(&MISSPELT_SECTION, at, message)
        .help(say!("write `[{}]`; other tools ignore the misspelt section", meant))
        .fix(fix)
}

/// Reports the spelling of a section name.
pub(in crate::eds) fn section_spelling(name: &str, parsed: &SectionName, at: Span) -> Option<Diagnostic> {
    let (rule, message) = match parsed.spelling {
        // misspelt names are checked once all sections are known
        NameSpelling::Standard | NameSpelling::Misspelt => return None,
        NameSpelling::CorrectCommissioning => {
            (&COMMISSIONING_SPELLING, say!("the standard spells `[{}]` with one m", name))
        }
        NameSpelling::LeadingZero => (&SECTION_SPELLING, say!("`[{}]` has a leading zero", name)),
        NameSpelling::Decorated => (&SECTION_SPELLING, say!("`[{}]` is not a valid object section", name)),
    };
    let severe = parsed.spelling == NameSpelling::Decorated;
    let finding =
        Diagnostic::new(rule, at, message).severity(if severe { Severity::Error } else { Severity::Warning });
    let title = say!("write `[{}]`", parsed.to_string());
    let fix = Fix::safe(title.clone()).replace(at, parsed.to_string());
    Some(finding.help(title).fix(fix))
}

/// Reports the count `item`, or its absence, for `actual` numbered keys.
pub(in crate::eds) fn wrong_count(
    item: Option<&Item<'_>>,
    key: &str,
    (section, section_at): (&str, Span),
    actual: usize,
) -> Diagnostic {
    let part = SectionName::parse(section).part;
    let entries = counted(actual, "entry follows", "entries follow");
    let (at, message) = match item {
        Some(item) if !item.value.is_empty() => {
            (item.value_at, say!("`{}` is `{}`, but {}", key, item.value, entries))
        }
        Some(item) => (item.name_at, say!("`{}` is empty, but {}", key, entries)),
        None => (section_at, say!("`{}` is missing", key)),
    };
    let title = say!("write `{}={}`", key, actual);
    let fix = Fix::safe(title.clone());
    let fix = match item {
        Some(item) => fix.replace(item.value_at, actual.to_string()),
        None => fix.set(Place::of(part).field(Field::from_name(key)), actual.to_string()),
    };
    Diagnostic::new(&WRONG_COUNT, at, message).help(title).fix(fix)
}

/// Reports keys of a list that are not consecutive from 1; `item` is the first wrong one.
pub(in crate::eds) fn list_numbering(item: &Item<'_>, expected: &str, fix: Fix) -> Diagnostic {
    let message = say!("the key is `{}`, but should be `{}`", item.name, expected);
    Diagnostic::new(&LIST_NUMBERING, item.name_at, message)
        .help("number the entries 1, 2, 3 … in decimal, without leading zeros")
        .fix(fix)
}

pub(in crate::eds) fn invalid_list_entry(item: &Item<'_>, reason: &Reason) -> Diagnostic {
    let message = say!("`{}` is not a valid index", item.value);
    let finding = Diagnostic::new(&INVALID_LIST_ENTRY, item.value_at, message);
    // `16#1000`, or `1000h` as in section names
    let of_section = || SectionName::parse(item.value).part.object().map(|index| format!("0x{index:04X}"));
    match iec_number(item.value, reason).or_else(of_section) {
        Some(index) => {
            let title = say!("write `{}`", &index);
            finding.help(title.clone()).fix(Fix::risky(title).replace(item.value_at, index))
        }
        None => finding.help("write an index from 0x1 to 0xFFFF"),
    }
}

/// Reports an `[xxxxName]`, `[xxxxValue]` or `[xxxxDenotation]` without a compact object.
pub(in crate::eds) fn stray_compact_section(
    name: &str,
    at: Span,
    object_type: Option<ObjectType>,
) -> Diagnostic {
    let message = match object_type {
        Some(_) => say!("`[{}]` belongs to an object without `CompactSubObj`", name),
        None => say!("`[{}]` does not belong to any object", name),
    };
    Diagnostic::new(&STRAY_COMPACT_SECTION, at, message)
        .help("add `CompactSubObj` to the object, or move the values to its sub-indexes")
}

/// Reports a number in such a section that is not a sub-index of the compact object.
pub(in crate::eds) fn stray_compact_entry(item: &Item<'_>, count: u8) -> Diagnostic {
    let message = say!("`{}` is not a sub-index of an object with `CompactSubObj={}`", item.name, count);
    Diagnostic::new(&STRAY_COMPACT_SECTION, item.name_at, message)
        .help(say!("use the numbers 1 to {}", count))
}

/// Reports a quoted name or other string.
pub(in crate::eds) fn quoted_name(item: &Item<'_>) -> Diagnostic {
    let message = say!("`{}` is in quotes, which become part of the string", item.value);
    let inner = item.value.trim_matches('"').trim_ascii();
    let finding = Diagnostic::new(crate::literal::QUOTED, item.value_at, message).help("remove the quotes");
    let is_plain = !inner.is_empty() && inner.len() + 2 == item.value.len();
    if is_plain {
        finding.fix(Fix::risky("remove the quotes").replace(item.value_at, inner))
    } else {
        finding
    }
}
