//! Finds the intended name for a misspelt one.

use super::keys::FieldKey;
use super::names::{FIXED, OF_MODULE, OF_OBJECT};
use crate::model::{Field, ModulePart, Part};

/// The intended key for a name in the section of a part, if only one is similar.
pub(super) fn key(part: &Part, name: &str) -> Option<FieldKey> {
    let text = NameWord::new(name);
    let names = KEYS.iter().zip(Field::NAMED);
    let near = names.filter(|(word, (_, field))| text.may_be(word) && is_key_of(part, field));
    nearest(&text, near).and_then(|(meant, _)| FieldKey::find(meant))
}

/// Whether the section of a part may have a key.
pub fn is_key_of(part: &Part, field: &Field) -> bool {
    let is_numbered = |head: &str| matches!(field, Field::Named(name) if is_numbered(name, head));
    match part {
        Part::FileInfo => (Field::FileName..=Field::LastEds).contains(field),
        Part::DeviceInfo => (Field::VendorName..=Field::CanOpenSafetySupported).contains(field),
        Part::DummyUsage => is_numbered("Dummy"),
        Part::Comments | Part::Module(_, ModulePart::Comments) => {
            *field == Field::Lines || is_numbered("Line")
        }
        Part::Commissioning => (Field::NodeId..=Field::LssSerialNumber).contains(field),
        Part::List(_) => matches!(field, Field::SupportedObjects | Field::Item(_)),
        Part::SupportedModules
        | Part::ConnectedModules
        | Part::CompactNames(_)
        | Part::CompactValues(_)
        | Part::CompactDenotations(_)
        | Part::Module(_, ModulePart::FixedObjects | ModulePart::SubExtends) => *field == Field::NrOfEntries,
        Part::Links(_) => *field == Field::ObjectLinks,
        Part::Module(_, ModulePart::Info) => matches!(
            field,
            Field::ProductName | Field::ProductVersion | Field::ProductRevision | Field::OrderCode
        ),
        Part::Module(_, ModulePart::SubExt(_)) => {
            is_of_entry(field) || matches!(field, Field::Count | Field::ObjExtend)
        }
        Part::Object(_) | Part::Entry(..) | Part::Module(..) => is_of_entry(field),
        Part::DynamicChannels => *field == Field::NrOfSeg,
        Part::Tools => *field == Field::Items,
        Part::Tool(_) => matches!(field, Field::Name | Field::Command),
        _ => false,
    }
}

fn is_numbered(name: &str, head: &str) -> bool {
    let (word, digits) = name.split_at_checked(head.len()).unwrap_or_default();
    word.eq_ignore_ascii_case(head) && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
}

fn is_of_entry(field: &Field) -> bool {
    (Field::ParameterName..=Field::ParamRefd).contains(field)
}

/// The intended part for the name of a section.
pub(super) fn section(name: &str) -> Option<Part> {
    if let Some((number, rest)) = name.strip_prefix(['M', 'm']).and_then(|rest| number(rest, 10)) {
        let names = MODULE.iter().zip(OF_MODULE.iter().map(|(_, part)| *part));
        return nearest(&NameWord::new(rest), names).map(|part| Part::Module(number, part));
    }
    // with fewer than four digits, letters of a word could be read as digits of the index
    let index = name.get(..4).and_then(|digits| number(digits, 16)).filter(|(index, _)| *index >= 0x1000);
    if let Some((index, _)) = index {
        let names = OBJECT.iter().zip(OF_OBJECT.iter().map(|(_, part)| part(index)));
        return nearest(&NameWord::new(&name[4..]), names);
    }
    nearest(&NameWord::new(name), SECTIONS.iter().zip(&FIXED)).map(|(_, part)| part.clone())
}

/// The number at the start of a text, and the rest.
fn number(text: &str, radix: u32) -> Option<(u16, &str)> {
    let digits = text.chars().take_while(|c| c.is_digit(radix)).count();
    Some((u16::from_str_radix(&text[..digits], radix).ok()?, &text[digits..]))
}

/// The maximum length of a misspelt name.
const LONGEST: usize = 32;

/// A name without separators, in lower case, with masks for a quick comparison, because a file can have a
/// million unknown names.
struct NameWord {
    letters: [u8; LONGEST],
    length: usize,
    /// The letters of the name, one bit each.
    mask: u32,
    /// The digits of the name. Names with different digits are not similar.
    digits: u32,
}

impl NameWord {
    const EMPTY: Self = Self { letters: [0; LONGEST], length: 0, mask: 0, digits: 0 };

    /// A name; empty if it is too long.
    const fn new(name: &str) -> Self {
        let name = name.as_bytes();
        let mut word = Self::EMPTY;
        let mut at = 0;
        while at < name.len() {
            let letter = name[at].to_ascii_lowercase();
            at += 1;
            if !letter.is_ascii_alphanumeric() {
                continue;
            }
            if word.length == LONGEST {
                return Self::EMPTY;
            }
            word.letters[word.length] = letter;
            word.length += 1;
            if letter.is_ascii_digit() {
                word.digits = word.digits.wrapping_mul(16).wrapping_add(letter as u32);
            } else {
                word.mask |= 1 << (letter - b'a');
            }
        }
        word
    }

    fn letters(&self) -> &[u8] {
        &self.letters[..self.length]
    }

    /// The maximum number of edits between a misspelt and the intended name.
    fn most_edits(&self, other: &Self) -> usize {
        match self.length.min(other.length) {
            0..=3 => 0,
            4..=7 => 1,
            _ => 2,
        }
    }

    /// Whether a few edits might turn one name into the other.
    fn may_be(&self, other: &Self) -> bool {
        let most = self.most_edits(other);
        self.length > 0
            && self.digits == other.digits
            && self.length.abs_diff(other.length) <= most
            && (self.mask ^ other.mask).count_ones() as usize <= 2 * most
    }
}

static KEYS: [NameWord; Field::NAMED.len()] = words_of(Field::NAMED);
static SECTIONS: [NameWord; FIXED.len()] = words_of(&FIXED);
static MODULE: [NameWord; OF_MODULE.len()] = words_of(&OF_MODULE);
static OBJECT: [NameWord; OF_OBJECT.len()] = words_of(&OF_OBJECT);

/// The words of a table of names.
const fn words_of<T, const N: usize>(names: &[(&str, T)]) -> [NameWord; N] {
    let mut words = [NameWord::EMPTY; N];
    let mut number = 0;
    while number < N {
        words[number] = NameWord::new(names[number].0);
        number += 1;
    }
    words
}

/// The value of the intended name: the only one with the fewest edits.
fn nearest<'a, T>(text: &NameWord, names: impl IntoIterator<Item = (&'a NameWord, T)>) -> Option<T> {
    let mut best: Option<(usize, Option<T>)> = None;
    for (name, meant) in names {
        if !text.may_be(name) {
            continue;
        }
        let edits = edits(text.letters(), name.letters());
        match &mut best {
            _ if edits > text.most_edits(name) => {}
            Some((fewest, _)) if *fewest < edits => {}
            Some((fewest, meant)) if *fewest == edits => *meant = None,
            _ => best = Some((edits, Some(meant))),
        }
    }
    best.and_then(|(_, meant)| meant)
}

/// The number of letters to change, add, remove or swap with the next one to turn one name into the other.
fn edits(from: &[u8], to: &[u8]) -> usize {
    let mut before = [0; LONGEST + 1];
    let mut row: [usize; LONGEST + 1] = std::array::from_fn(|column| column);
    for (at, letter) in from.iter().enumerate() {
        let mut next = [at + 1; LONGEST + 1];
        for (column, other) in to.iter().enumerate() {
            let replaced = row[column] + usize::from(letter != other);
            let mut fewest = replaced.min(row[column + 1] + 1).min(next[column] + 1);
            let is_exchanged = at > 0 && column > 0 && from[at - 1] == *other && to[column - 1] == *letter;
            if is_exchanged {
                fewest = fewest.min(before[column - 1] + 1);
            }
            next[column + 1] = fewest;
        }
        before = std::mem::replace(&mut row, next);
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eds::section::SectionName;
    use crate::model::ObjectList;

    #[test]
    fn keys_with_one_or_two_wrong_letters() {
        let key_of = |part: &Part, name: &str| key(part, name).map(|key| key.field().to_string());
        for (name, meant) in [
            ("DefualtValue", "DefaultValue"),
            ("ParamterValue", "ParameterValue"),
            ("HighLimt", "HighLimit"),
            ("LoLimit", "LowLimit"),
            ("ObjectTyp", "ObjectType"),
            ("Obj Flags", "ObjFlags"),
            ("Acces_Type", "AccessType"),
        ] {
            assert_eq!(key_of(&Part::Object(0x2000), name).as_deref(), Some(meant), "{name}");
        }
        for name in ["Unit", "Factor", "Offset", "Category", "ObjectName", "MinLimit", "VendorNam", ""] {
            assert_eq!(key_of(&Part::Object(0x2000), name), None, "{name}");
        }
        for name in ["BaudRate_100", "BaudRate_33", "NrOfXPDO", "NG_Slave"] {
            assert_eq!(key_of(&Part::DeviceInfo, name), None, "{name}");
        }
        assert_eq!(key_of(&Part::DeviceInfo, "BaudRat_10").as_deref(), Some("BaudRate_10"));
    }

    #[test]
    fn sections_with_one_or_two_wrong_letters() {
        for (name, meant) in [
            ("OptionalObject", Part::List(ObjectList::Optional)),
            ("Device_Info", Part::DeviceInfo),
            ("M2ModulInfo", Part::Module(2, ModulePart::Info)),
            ("M2FixdObjects", Part::Module(2, ModulePart::FixedObjects)),
            ("2000Names", Part::CompactNames(0x2000)),
            ("2000ObjectLink", Part::Links(0x2000)),
            ("FileInof", Part::FileInfo),
        ] {
            assert_eq!(SectionName::parse(name).part, meant, "{name}");
        }
        for name in
            ["ToolInfos", "VirtualDeviceDefinitions", "Objects", "Module", "2000Subs", "M2Info", "Decade"]
        {
            assert!(matches!(SectionName::parse(name).part, Part::Section(_)), "{name}");
        }
    }
}
