//! Errors of a reader that creates a dictionary from the lists of objects and stops at the first unexpected
//! content.

use std::collections::BTreeMap;

use super::rules::UNLOADABLE;
use super::{Span, section_name};
use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::ini::Document;
use crate::model::{ObjectList, Part};

/// The sections and keys of a text, case-insensitive; the last of two equal keys is used.
struct LoadedConfig<'a> {
    text: &'a str,
    sections: BTreeMap<String, LoadedSection<'a>>,
}

struct LoadedSection<'a> {
    name: Span,
    keys: BTreeMap<String, (&'a str, Span)>,
}

/// The position where reading stops, and the reason.
type LoadingStop = (Span, Text);

/// Reports where reading stops.
pub(super) fn check(document: &Document, findings: &mut Findings) {
    if let Err((at, message)) = LoadedConfig::of(document).load() {
        let finding = Diagnostic::new(&UNLOADABLE, at, message);
        findings.push(finding.help("correct it, or use a copy without it for the tool"));
    }
}

impl<'a> LoadedConfig<'a> {
    fn of(document: &'a Document) -> Self {
        let text = document.text();
        let mut sections: BTreeMap<String, LoadedSection<'a>> = BTreeMap::new();
        // a C string ends there
        let end = text.find('\0').and_then(|at| u32::try_from(at).ok()).unwrap_or(u32::MAX);
        document.visit(
            |section| {
                let Some(header) = section.header.filter(|header| header.line.start < end) else { return };
                let name = header.name.of(text).to_ascii_lowercase();
                let into = sections
                    .entry(name)
                    .or_insert_with(|| LoadedSection { name: header.name, keys: BTreeMap::new() });
                for entry in &section.entries {
                    let key = entry.key.of(text).to_ascii_lowercase();
                    into.keys.insert(key, (plain(entry.value.of(text)), entry.value));
                }
            },
            |_| {},
        );
        Self { text, sections }
    }

    fn section(&self, name: &str) -> Option<&LoadedSection<'a>> {
        self.sections.get(&name.to_ascii_lowercase())
    }

    fn load(&self) -> Result<(), LoadingStop> {
        let mut indexes: Vec<u16> = Vec::new();
        for list in ObjectList::ALL {
            self.list(&section_name(&Part::List(list)).unwrap_or_default(), &mut indexes)?;
        }
        for (position, &index) in indexes.iter().enumerate() {
            self.object(index, &indexes[..position])?;
        }
        let Some(node) = self.section("DeviceComissioning") else { return Ok(()) };
        if let Some((value, at)) = node.value("nodeid")
            && !matches!(unsigned(value) as u8, 1..=127 | 255)
        {
            return Err((at, say!("the node-ID `{}` is not valid", value)));
        }
        let has_serial = indexes.contains(&0x1018) && self.section("1018sub4").is_some();
        match node.value("lss_serialnumber") {
            Some((_, at)) if !has_serial => {
                Err((at, say!("`{}` is present, but 1018h:04 is missing", "LSS_SerialNumber")))
            }
            _ => Ok(()),
        }
    }

    /// The indexes of a list.
    fn list(&self, name: &str, indexes: &mut Vec<u16>) -> Result<(), LoadingStop> {
        let Some(section) = self.section(name) else { return Ok(()) };
        let Some((count, at)) = section.value("supportedobjects") else { return Ok(()) };
        for number in 1..=unsigned(count).min(0xFFFF) {
            let index = section.value(&number.to_string()).map_or(0, |(value, _)| unsigned(value) as u16);
            if index == 0 {
                return Err((at, say!("`{}` is {}, but line {} is missing", name, count, number)));
            }
            indexes.push(index);
        }
        Ok(())
    }

    fn object(&self, index: u16, before: &[u16]) -> Result<(), LoadingStop> {
        let name = format!("{index:X}");
        let Some(section) = self.section(&name).filter(|section| section.keys.contains_key("parametername"))
        else {
            let at = self.sections.values().map(|section| section.name).next().unwrap_or_default();
            let at = self.section(&name).map_or(at, |section| section.name);
            return Err((at, say!("{:04X}h is listed, but has no section with a name", index)));
        };
        if before.contains(&index) {
            return Err((section.name, say!("{:04X}h is listed twice", index)));
        }
        let object_type = section.value("objecttype").map_or(7, |(value, _)| unsigned(value) as u8);
        if !matches!(object_type, 6 | 8 | 9) {
            return self.entry(section, section, object_type == 2);
        }
        let number = |key: &str| section.value(key).map_or(0, |(value, _)| unsigned(value) as u8);
        let (count, compact) = (number("subnumber"), number("compactsubobj"));
        match (count, compact) {
            (0, 0) => return Err((section.name, say!("{:04X}h has no sub-indexes", index))),
            (1.., 1..) => {
                return Err((
                    section.name,
                    say!("{:04X}h has both described and compact sub-indexes", index),
                ));
            }
            _ => {}
        }
        let mut left = count;
        for sub in 0..0xFF_u8 {
            let part = self.section(&format!("{index:X}sub{sub:X}"));
            let part = part.filter(|part| part.keys.contains_key("parametername"));
            let Some(part) = part.filter(|_| left > 0) else { continue };
            left -= 1;
            self.entry(part, part, false)?;
        }
        if compact > 0 { self.entry(section, section, false) } else { Ok(()) }
    }

    /// Type, access and values of an entry.
    fn entry(
        &self,
        section: &LoadedSection<'a>,
        at: &LoadedSection<'a>,
        is_domain: bool,
    ) -> Result<(), LoadingStop> {
        let name = at.name.of(self.text);
        let stated = section.value("datatype");
        let data_type = match stated {
            None if is_domain => DOMAIN,
            None => return Err((at.name, say!("`{}` has no `{}`", name, "DataType"))),
            Some((value, _)) => unsigned(value) as u16,
        };
        let place = stated.map_or(at.name, |(_, at)| at);
        if !matches!(data_type, 0x01..=0x0D | DOMAIN..=0x16 | 0x18..=0x1B) {
            return Err((place, say!("{:04X}h is not a CiA 301 data type", data_type)));
        }
        for key in ["lowlimit", "highlimit"] {
            self.value(section, key, data_type)?;
        }
        const ACCESS: [&str; 6] = ["ro", "wo", "rw", "rwr", "rww", "const"];
        match section.value("accesstype") {
            None if data_type != DOMAIN => {
                return Err((at.name, say!("`{}` has no `{}`", name, "AccessType")));
            }
            Some((value, at)) if !ACCESS.iter().any(|access| access.eq_ignore_ascii_case(value)) => {
                return Err((at, say!("`{}` is not an access type", value)));
            }
            _ => {}
        }
        self.value(section, "defaultvalue", data_type)?;
        self.value(section, "parametervalue", data_type)
    }

    fn value(&self, section: &LoadedSection<'a>, key: &str, data_type: u16) -> Result<(), LoadingStop> {
        let Some((value, at)) = section.value(key) else { return Ok(()) };
        let is_formula = value.get(..7).is_some_and(|word| word.eq_ignore_ascii_case("$NODEID"));
        let rest = match value.get(7..).filter(|_| is_formula) {
            Some(rest) => {
                let rest = rest.trim_start();
                rest.strip_prefix('+').unwrap_or(rest).trim_start()
            }
            None => value,
        };
        if can_be_read(data_type, rest) {
            return Ok(());
        }
        Err((at, say!("`{}` is not a valid value of type {:04X}h", value, data_type)))
    }
}

impl<'a> LoadedSection<'a> {
    /// The value of a key; `None` if empty.
    fn value(&self, key: &str) -> Option<(&'a str, Span)> {
        self.keys.get(key).copied().filter(|(value, _)| !value.is_empty())
    }
}

const DOMAIN: u16 = 0x0F;

/// Whether the text begins with a value of this type.
fn can_be_read(data_type: u16, text: &str) -> bool {
    let is_number = |text: &str| {
        let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
        digits.starts_with(|character: char| character.is_ascii_digit())
    };
    match data_type {
        0x09 | 0x0B => true,
        0x0A | DOMAIN => text.starts_with(|character: char| character.is_ascii_hexdigit()),
        // days and milliseconds
        0x0C | 0x0D => {
            let milliseconds = text.split_once([' ', '\t']).map(|(_, rest)| rest.trim_start());
            is_number(text) && milliseconds.is_some_and(is_number)
        }
        0x08 | 0x11 => is_number(text) || text.trim_start_matches(['+', '-']).starts_with('.'),
        _ => is_number(text),
    }
}

/// A value without its comment and quotes.
fn plain(value: &str) -> &str {
    let value = value.trim();
    if let Some(quoted) = value.strip_prefix('"') {
        return quoted.split('"').next().unwrap_or(quoted);
    }
    value.split([';', '#']).next().unwrap_or(value).trim_end()
}

/// The number at the start of a text; 0 if there is none.
fn unsigned(text: &str) -> u64 {
    let text = text.trim_start();
    let (digits, radix) = match text.get(..2) {
        Some("0x" | "0X") => (&text[2..], 16),
        _ if text.starts_with('0') => (text, 8),
        _ => (text, 10),
    };
    let end = digits.find(|character: char| !character.is_digit(radix)).unwrap_or(digits.len());
    u64::from_str_radix(&digits[..end], radix).unwrap_or(0)
}
