//! Names of sections: their parts, and their spellings in real files.

use super::misspelt;
use super::names::{FIXED, OF_MODULE, OF_OBJECT, OfIndex};
use crate::diagnostic;
use crate::model::{ModulePart, Part};

/// A parsed section name.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct SectionName {
    /// The described part.
    pub part: Part,
    /// How the name differs from the spelling of the standard.
    pub(crate) spelling: NameSpelling,
}

/// How a section name is spelled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum NameSpelling {
    /// The spelling of the standard, in any case.
    #[default]
    Standard,
    /// `[DeviceCommissioning]`; the standard has one `m`.
    CorrectCommissioning,
    /// `[1018sub01]`, `[M01ModuleInfo]`: a leading zero in the index, sub-index or module number.
    LeadingZero,
    /// `[0x1018]` or `[1018 sub1]`: read here, but not by other tools.
    Decorated,
    /// `[OptionalObject]`: almost a name of the standard.
    Misspelt,
}

impl SectionName {
    /// Parses a name; an unknown name becomes [`Part::Section`].
    pub fn parse(name: &str) -> Self {
        if let Some(part) = plain_object(name.as_bytes()).or_else(|| object_part(name)) {
            return Self::standard(part);
        }
        if let Some((_, part)) = FIXED.iter().find(|(fixed, _)| fixed.eq_ignore_ascii_case(name)) {
            return Self::standard(part.clone());
        }
        if name.eq_ignore_ascii_case("DeviceCommissioning") {
            return Self { part: Part::Commissioning, spelling: NameSpelling::CorrectCommissioning };
        }
        if let Some(section) = module_section(name) {
            return section;
        }
        if let Some(part) = tool_part(name) {
            return Self::standard(part);
        }
        if let Some(object) = odd_object(name) {
            return object;
        }
        match misspelt::section(name) {
            Some(part) => Self { part, spelling: NameSpelling::Misspelt },
            None => Self::standard(Part::Section(name.to_ascii_lowercase().into())),
        }
    }

    fn standard(part: Part) -> Self {
        Self { part, spelling: NameSpelling::Standard }
    }
}

/// The section name of a part, spelled as in the standard; `None` for [`Part::Device`].
pub(crate) fn section_name(part: &Part) -> Option<String> {
    (*part != Part::Device).then(|| diagnostic::section_name(part))
}

/// Fast path for almost all sections: an object with four digits, or a sub-index of it.
fn plain_object(name: &[u8]) -> Option<Part> {
    let (&[first, second, third, last], rest) = name.split_first_chunk()?;
    let digits = [hex_digit(first)?, hex_digit(second)?, hex_digit(third)?, hex_digit(last)?];
    let index = digits.iter().fold(0, |index, digit| index << 4 | u16::from(*digit));
    match *rest {
        _ if first == b'0' => None,
        [] => Some(Part::Object(index)),
        [b's' | b'S', b'u' | b'U', b'b' | b'B', sub] => Some(Part::Entry(index, hex_digit(sub)?)),
        [b's' | b'S', b'u' | b'U', b'b' | b'B', high, low] if high != b'0' => {
            Some(Part::Entry(index, hex_digit(high)? << 4 | hex_digit(low)?))
        }
        _ => None,
    }
}

fn hex_digit(byte: u8) -> Option<u8> {
    match byte {
        b'0'..=b'9' => Some(byte - b'0'),
        b'A'..=b'F' => Some(byte - b'A' + 10),
        b'a'..=b'f' => Some(byte - b'a' + 10),
        _ => None,
    }
}

/// The number at the start of a name that begins with hex digits, and the known suffix after it. A name
/// without a known suffix has no number: `[A]` to `[FFFF]` are objects, `[Face2]` is not. The number
/// includes as many digits as possible, because `Denotation` also starts with hex digits.
fn hex_prefix(name: &str) -> Option<(u16, &str)> {
    let digits = name.bytes().take_while(u8::is_ascii_hexdigit).take(5).count();
    let digits = (1..=digits).rev().find(|&digits| suffix_of(&name[digits..]).is_some())?;
    let index = u16::from_str_radix(&name[..digits], 16).ok()?;
    Some((index, &name[digits..]))
}

/// The meaning of the text after an index.
enum Suffix<'a> {
    None,
    Sub(&'a str),
    Of(OfIndex),
}

fn suffix_of(rest: &str) -> Option<Suffix<'_>> {
    match rest {
        "" => Some(Suffix::None),
        _ if rest.len() > 3 && rest.is_char_boundary(3) && rest[..3].eq_ignore_ascii_case("sub") => {
            Some(Suffix::Sub(&rest[3..]))
        }
        _ => OF_OBJECT
            .iter()
            .find(|(word, _)| rest.eq_ignore_ascii_case(word))
            .map(|(_, part)| Suffix::Of(*part)),
    }
}

/// An object, a sub-index or a related section, in the spelling of the standard.
fn object_part(name: &str) -> Option<Part> {
    if name.starts_with('0') {
        return None;
    }
    let (index, rest) = hex_prefix(name)?;
    Some(match suffix_of(rest)? {
        Suffix::None => Part::Object(index),
        Suffix::Sub(sub) => Part::Entry(index, plain_sub(sub)?),
        Suffix::Of(part) => part(index),
    })
}

/// A sub-index in hex without leading zero.
fn plain_sub(text: &str) -> Option<u8> {
    let plain = text == "0" || !text.starts_with('0');
    if plain { hex_sub(text) } else { None }
}

fn hex_sub(text: &str) -> Option<u8> {
    let digits = (1..=4).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if digits { u8::from_str_radix(text, 16).ok() } else { None }
}

/// An object or sub-index with leading zeros, spaces, or hex prefixes and suffixes.
fn odd_object(name: &str) -> Option<SectionName> {
    let plain = unmarked(&name.split_ascii_whitespace().collect::<String>())?;
    let text = without_zeros(&plain);
    let decorated = plain != name;
    let padded = text.starts_with('0') || text.len() < plain.len();
    let (index, rest) = hex_prefix(text).filter(|_| decorated || padded || text.contains(['s', 'S']))?;
    let part = match suffix_of(rest)? {
        Suffix::None if text.len() <= 4 => Part::Object(index),
        Suffix::Sub(sub) => Part::Entry(index, hex_sub(sub)?),
        // a data type has no links, so the section itself is the mistake and not its leading zeros
        Suffix::Of(part) if !decorated && part(index) == Part::Links(index) => {
            return Some(SectionName::standard(Part::Links(index)));
        }
        Suffix::Of(part) if decorated => part(index),
        _ => return None,
    };
    let spelling = if decorated { NameSpelling::Decorated } else { NameSpelling::LeadingZero };
    Some(SectionName { part, spelling })
}

/// The hex digits at the start of a text without their prefix or suffix (`0x1018`, `$1018`, `16#1018`, `1018h`), the
/// text after them, and whether they had one.
fn unmarked_digits(text: &str) -> (&str, &str, bool) {
    let marks = ["0x", "0X", "$", "16#"];
    let number = marks.iter().find_map(|mark| text.strip_prefix(mark)).unwrap_or(text);
    let (digits, rest) = number.split_at(number.bytes().take_while(u8::is_ascii_hexdigit).count());
    let is_next = |mark: &&&str| rest.get(..mark.len()).is_some_and(|next| next.eq_ignore_ascii_case(mark));
    let behind = ["hex", "h"].iter().find(is_next).map_or(0, |mark| mark.len());
    (digits, &rest[behind..], behind > 0 || number.len() < text.len())
}

/// `1018sub1` for `0x1018sub0x1`, `1018hsub1h`, `$1018.1` and the like; `None` for a word such as `Beach`, and for `1018.10`, whose
/// sub-index may be decimal.
fn unmarked(name: &str) -> Option<String> {
    let (index, rest, is_marked) = unmarked_digits(name);
    let separated = rest.strip_prefix(['.', ':', '/', '_']).filter(|_| !index.is_empty());
    let is_index = index.len() >= 4 && index.bytes().any(|byte| byte.is_ascii_digit());
    let is_prefixed = name.starts_with("0x") || name.starts_with("0X");
    if !is_index && (separated.is_some() || is_marked && !is_prefixed) {
        return None;
    }
    let rest = separated.unwrap_or(rest);
    let after_sub = rest.get(..3).filter(|word| word.eq_ignore_ascii_case("sub")).map(|_| &rest[3..]);
    if separated.is_none() && after_sub.is_none() {
        return Some(format!("{index}{rest}"));
    }
    let (digits, behind, is_marked) = unmarked_digits(after_sub.unwrap_or(rest));
    let is_hex = is_marked || digits.len() == 1 || digits.starts_with('0') || digits.parse::<u16>().is_err();
    (after_sub.is_some() || is_hex).then(|| format!("{index}sub{digits}{behind}"))
}

/// The text from the last four digits of its index on, if only zeros precede them.
fn without_zeros(text: &str) -> &str {
    let digits = text.bytes().take_while(u8::is_ascii_hexdigit).count();
    let zeros = text.bytes().take_while(|&byte| byte == b'0').count();
    &text[zeros.min(digits.saturating_sub(4))..]
}

/// `M1ModuleInfo` and the other sections of a module.
fn module_section(name: &str) -> Option<SectionName> {
    let rest = name.strip_prefix(['M', 'm'])?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let number: u16 = rest[..digits].parse().ok()?;
    let padded = rest.starts_with('0');
    let rest = &rest[digits..];
    let (part, spelling) = match OF_MODULE.iter().find(|(word, _)| rest.eq_ignore_ascii_case(word)) {
        Some((_, part)) => (*part, NameSpelling::Standard),
        None => module_object(rest)?,
    };
    let spelling =
        if padded && spelling == NameSpelling::Standard { NameSpelling::LeadingZero } else { spelling };
    Some(SectionName { part: Part::Module(number, part), spelling })
}

/// `SubExt6000`, `Fixed6423` or `Fixed6423sub1`; the index can be spelled like the index of an object of
/// the device.
fn module_object(name: &str) -> Option<(ModulePart, NameSpelling)> {
    let behind = |word: &str| {
        let head = name.get(..word.len())?;
        head.eq_ignore_ascii_case(word).then(|| &name[word.len()..])
    };
    let extended = behind("SubExt");
    let object = extended.or_else(|| behind("Fixed"))?;
    let object = object_part(object).map(SectionName::standard).or_else(|| odd_object(object))?;
    let part = match object.part {
        Part::Object(index) if extended.is_some() => ModulePart::SubExt(index),
        Part::Object(index) => ModulePart::Fixed(index),
        Part::Entry(index, sub) if extended.is_none() => ModulePart::FixedEntry(index, sub),
        _ => return None,
    };
    Some((part, object.spelling))
}

fn tool_part(name: &str) -> Option<Part> {
    let number = name.get(..4).filter(|head| head.eq_ignore_ascii_case("Tool")).map(|_| &name[4..])?;
    number.parse().ok().map(Part::Tool)
}

objdict_model::messages! { SectionName: { Self { part, .. } => "{}", section_name(part).unwrap_or_default(); } }

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(name: &str) -> (Part, NameSpelling) {
        let SectionName { part, spelling } = SectionName::parse(name);
        (part, spelling)
    }

    #[test]
    fn names_of_the_standard_in_any_case() {
        let standard = |name: &str| {
            let (part, spelling) = parse(name);
            assert_eq!(spelling, NameSpelling::Standard, "{name}");
            part
        };
        assert_eq!(standard("fileinfo"), Part::FileInfo);
        assert_eq!(standard("1A00SUBa"), Part::Entry(0x1A00, 10));
        assert_eq!(standard("A0"), Part::Object(0xA0));
        assert_eq!(standard("3004Name"), Part::CompactNames(0x3004));
        assert_eq!(standard("300DDenotation"), Part::CompactDenotations(0x300D));
        assert_eq!(standard("4EDenotation"), Part::CompactDenotations(0x4E));
        assert_eq!(standard("6000ObjectLinks"), Part::Links(0x6000));
        assert_eq!(standard("M12SubExt6000"), Part::Module(12, ModulePart::SubExt(0x6000)));
        assert_eq!(standard("M1SubExtends"), Part::Module(1, ModulePart::SubExtends));
        assert_eq!(standard("M1Fixed6423sub0"), Part::Module(1, ModulePart::FixedEntry(0x6423, 0)));
        assert_eq!(standard("Tool2"), Part::Tool(2));
    }

    #[test]
    fn odd_spellings_are_understood() {
        assert_eq!(parse("1018sub01"), (Part::Entry(0x1018, 1), NameSpelling::LeadingZero));
        let info = Part::Module(1, ModulePart::Info);
        assert_eq!(parse("M01ModuleInfo"), (info, NameSpelling::LeadingZero));
        let entry = Part::Module(3, ModulePart::FixedEntry(0x2401, 1));
        assert_eq!(parse("M3Fixed2401sub01"), (entry, NameSpelling::LeadingZero));
        let extension = Part::Module(1, ModulePart::SubExt(0x6000));
        assert_eq!(parse("M01SubExt0x6000"), (extension, NameSpelling::Decorated));
        assert_eq!(parse("0x1000"), (Part::Object(0x1000), NameSpelling::Decorated));
        assert_eq!(parse("02000"), (Part::Object(0x2000), NameSpelling::LeadingZero));
        assert_eq!(parse("2001sub0xA"), (Part::Entry(0x2001, 10), NameSpelling::Decorated));
        assert_eq!(parse("1018 sub1"), (Part::Entry(0x1018, 1), NameSpelling::Decorated));
        assert_eq!(parse("DeviceCommissioning"), (Part::Commissioning, NameSpelling::CorrectCommissioning));
        for name in ["1018h", "1018H", "1018hex", "$1018", "16#1018", "01018h", "0x1018h", "1018 h"] {
            assert_eq!(parse(name), (Part::Object(0x1018), NameSpelling::Decorated), "{name}");
        }
        for name in [
            "1018hsubA",
            "1018subAh",
            "1018subAhex",
            "1018HSUBAH",
            "$1018sub$A",
            "1018.A",
            "1018:0A",
            "1018/A",
            "1018_A",
            "1018h.Ah",
            "1018.subA",
            "1018.0xA",
            "1018 . A",
        ] {
            assert_eq!(parse(name), (Part::Entry(0x1018, 10), NameSpelling::Decorated), "{name}");
        }
        assert_eq!(parse("3004hName"), (Part::CompactNames(0x3004), NameSpelling::Decorated));
        assert_eq!(parse("$300DDenotation"), (Part::CompactDenotations(0x300D), NameSpelling::Decorated));
        assert_eq!(parse("6000hObjectLinks"), (Part::Links(0x6000), NameSpelling::Decorated));
        let module = ModulePart::FixedEntry(0x6423, 1);
        assert_eq!(parse("M1Fixed6423hsub1"), (Part::Module(1, module), NameSpelling::Decorated));
    }

    #[test]
    fn other_names_are_not_objects() {
        for name in [
            "1018sub100",
            "10000",
            "1a00subfwefwef",
            "ToolInfos",
            "Default",
            "M1",
            "M1SubExt6000sub1",
            "",
            "FACE sheet",
            "sub1",
            "Beach",
            "FACEhex",
            "$Face",
            "1018.10",
            "1018.",
            "1018hour",
            "1.0",
            "0.5",
            "0h",
            "2024-1",
        ] {
            assert!(matches!(parse(name).0, Part::Section(_)), "{name}: {:?}", parse(name));
        }
    }

    #[test]
    fn every_part_is_named_as_it_is_read() {
        for name in [
            "FileInfo",
            "1018",
            "1018subA",
            "2000Value",
            "M2FixedObjects",
            "M3Fixed6423",
            "DeviceComissioning",
        ] {
            let (part, _) = parse(name);
            assert_eq!(section_name(&part).as_deref(), Some(name));
        }
    }
}
