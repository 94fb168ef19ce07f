//! Lookup of objects and entries by name.

use std::str::FromStr;

use crate::diagnostic::nearest;
use crate::model::{Address, Device, NoAddress, Object, PdoKind};

/// An address, or any other text that [`resolve`] accepts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ObjectName {
    /// `1018:1`.
    Address(Address),
    /// `statusword`.
    Text(String),
}

impl FromStr for ObjectName {
    type Err = NoAddress;

    /// Digits that are not a valid address are an error, not a name.
    fn from_str(text: &str) -> Result<Self, NoAddress> {
        let text = text.trim();
        let is_numeric = text.starts_with(|c: char| c.is_ascii_digit())
            && text.chars().all(|c| c.is_ascii_hexdigit() || matches!(c, 'x' | 'X' | ':'));
        match text.parse() {
            Ok(address) => Ok(Self::Address(address)),
            Err(error) if is_numeric || plain(text).is_empty() => Err(error),
            Err(_) => Ok(Self::Text(text.to_owned())),
        }
    }
}

// As written; addresses as `1017` and `1800:2`.
objdict_model::messages! { ObjectName: {
    Self::Address(Address { index, sub: Some(sub) }) => "{index:04X}:{sub:X}";
    Self::Address(Address { index, sub: None }) => "{index:04X}";
    Self::Text(text) => "{text}";
} }

/// Finds the objects and entries that a text refers to: an address (`1018:1`), a PDO (`tpdo1`), an area
/// (`communication`, `manufacturer`, `profile`), a pattern of indexes or names (`60*`, `*velocity*`), or a
/// name. Case, spaces and punctuation of names are ignored. A full match takes precedence over a partial one,
/// and objects over entries. An address is returned even if the device does not have it.
pub fn resolve(device: &Device, text: &str) -> Vec<Address> {
    find(device, text, |is_meant| {
        let found = objects_by(device, |_, name| is_meant(name));
        if found.is_empty() { entries_by(device, is_meant) } else { found }
    })
}

/// The probably intended name of an object, or part of it, for a text without a result.
pub fn meant(device: &Device, text: &str) -> Option<String> {
    let count = text.split_whitespace().count().max(1);
    let names = || device.objects.values().map(Object::name);
    let words: Vec<Vec<&str>> = names().map(|name| name.split_whitespace().collect()).collect();
    let parts: Vec<String> =
        words.iter().flat_map(|words| words.windows(count)).map(|part| part.join(" ")).collect();
    nearest(text, names().chain(parts.iter().map(String::as_str))).map(str::to_owned)
}

/// Finds every candidate if one entry is expected, in dictionary order. Unlike [`resolve`], objects do not
/// take precedence over entries; if an object and its own entries match, only the entries are returned.
pub fn candidates(device: &Device, text: &str) -> Vec<Address> {
    find(device, text, |is_meant| {
        let entries = entries_by(device, is_meant);
        let mut found = objects_by(device, |_, name| is_meant(name));
        found.retain(|object| entries.iter().all(|entry| entry.index != object.index));
        found.extend(entries);
        found.sort_unstable();
        found
    })
}

/// Resolves a text; `by_name` finds the names that a caller accepts.
fn find(
    device: &Device,
    text: &str,
    by_name: impl Fn(&dyn Fn(&str) -> bool) -> Vec<Address>,
) -> Vec<Address> {
    if let Ok(address) = text.parse() {
        return vec![address];
    }
    let wanted = plain(text);
    if let Some(indexes) = pdo(&wanted) {
        return objects(device, |index| indexes.contains(&index));
    }
    let area = match wanted.as_str() {
        "communication" => Some(0x1000..=0x1FFF),
        "manufacturer" => Some(0x2000..=0x5FFF),
        "profile" => Some(0x6000..=0x9FFF),
        _ => None,
    };
    if let Some(area) = area {
        return objects(device, |index| area.contains(&index));
    }
    if wanted.contains(['*', '?']) {
        let is_meant = |index: u16, name: &str| {
            matches(wanted.as_bytes(), name.as_bytes())
                || matches(wanted.as_bytes(), format!("{index:04x}").as_bytes())
        };
        return objects_by(device, is_meant);
    }
    if wanted.is_empty() {
        return Vec::new();
    }
    let exact = by_name(&|name| name == wanted);
    if exact.is_empty() { by_name(&|name| name.contains(&wanted)) } else { exact }
}

fn objects(device: &Device, is_meant: impl Fn(u16) -> bool) -> Vec<Address> {
    objects_by(device, |index, _| is_meant(index))
}

fn objects_by(device: &Device, is_meant: impl Fn(u16, &str) -> bool) -> Vec<Address> {
    let objects = device.objects.iter().filter(|(index, object)| is_meant(**index, &plain(object.name())));
    objects.map(|(&index, _)| Address { index, sub: None }).collect()
}

fn entries_by(device: &Device, is_meant: &dyn Fn(&str) -> bool) -> Vec<Address> {
    let objects = device.objects.iter().filter(|(_, object)| object.object_type().has_subs());
    let entries = objects.flat_map(|(&index, object)| {
        let meant = object.entries().filter(|(_, entry)| is_meant(&plain(&entry.name)));
        meant.map(move |(sub, _)| Address { index, sub: Some(sub) })
    });
    entries.collect()
}

/// Communication parameter and mapping parameter of `tpdo1`.
fn pdo(name: &str) -> Option<[u16; 2]> {
    let kinds = [("tpdo", PdoKind::Tpdo), ("rpdo", PdoKind::Rpdo)];
    kinds.into_iter().find_map(|(prefix, kind)| {
        let number = name.strip_prefix(prefix)?.parse().ok()?;
        Some([kind.communication_index(number)?, kind.mapping_index(number)?])
    })
}

/// Reduces a name to lower-case letters, digits and wildcards.
fn plain(name: &str) -> String {
    let kept = name.chars().filter(|c| c.is_alphanumeric() || matches!(c, '*' | '?'));
    kept.flat_map(char::to_lowercase).collect()
}

/// Whether a text matches a pattern with `*` and `?`.
fn matches(pattern: &[u8], text: &[u8]) -> bool {
    let (mut p, mut t) = (0, 0);
    let mut star = None; // where to resume when the text after the last `*` does not match
    while t < text.len() {
        match pattern.get(p) {
            Some(b'*') => {
                star = Some((p, t));
                p += 1;
            }
            Some(&c) if c == b'?' || c == text[t] => (p, t) = (p + 1, t + 1),
            _ => match star {
                Some((at, from)) => {
                    star = Some((at, from + 1));
                    (p, t) = (at + 1, from + 1);
                }
                None => return false,
            },
        }
    }
    pattern[p..].iter().all(|&c| c == b'*')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Entry, Object, ObjectType};

    #[test]
    fn names_patterns_and_areas() {
        let mut device = Device::default();
        let names = [
            (0x1800, "TPDO communication parameter"),
            (0x1A00, "TPDO mapping"),
            (0x6041, "Statusword"),
            (0x6064, "Position actual value"),
            (0x6864, "Position actual value 2"),
        ];
        for (index, name) in names {
            let mut object = Object::default();
            object.main.name = name.into();
            device.objects.insert(index, object);
        }
        let found = |text: &str| resolve(&device, text).iter().map(|at| at.index).collect::<Vec<_>>();
        assert_eq!(found("1018:1"), [0x1018]);
        assert_eq!(found("TPDO1"), [0x1800, 0x1A00]);
        assert_eq!(found("status word"), [0x6041]);
        assert_eq!(found("position actual value"), [0x6064], "a full name wins");
        assert_eq!(found("actual"), [0x6064, 0x6864]);
        assert_eq!(found("60*"), [0x6041, 0x6064]);
        assert_eq!(found("*actual*value"), [0x6064]);
        assert_eq!(found("communication"), [0x1800, 0x1A00]);
        assert_eq!(found("tpdo9"), [0u16; 0]);
        assert_eq!(found("-"), [0u16; 0]);
    }

    #[test]
    fn one_entry_is_wanted() {
        let mut device = Device::default();
        let named = |name: &str, subs: &[&str]| {
            let mut object = Object::default();
            object.main.name = name.into();
            for (sub, name) in (1..).zip(subs) {
                object.main.object_type = Some(ObjectType::Record);
                object.subs.insert(sub, Entry { name: (*name).into(), ..Entry::default() });
            }
            object
        };
        device.objects.insert(0x2000, named("Speed", &[]));
        device.objects.insert(0x2001, named("Motor", &["Speed", "Current"]));
        device.objects.insert(0x2002, named("Limit", &["Limit"]));
        let found =
            |text: &str| candidates(&device, text).iter().map(|at| (at.index, at.sub)).collect::<Vec<_>>();
        assert_eq!(found("speed"), [(0x2000, None), (0x2001, Some(1))]);
        assert_eq!(found("current"), [(0x2001, Some(2))]);
        assert_eq!(found("limit"), [(0x2002, Some(1))]);
        assert_eq!(found("motor"), [(0x2001, None)]);
        assert_eq!(resolve(&device, "speed").len(), 1, "an object wins where both can be shown");
    }
}
