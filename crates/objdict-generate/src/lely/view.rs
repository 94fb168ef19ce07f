//! Views of the Lely core templates, with the entries for which the library calls the application (`--hook`).

use super::value::{UNCONFIGURED, data_type, has_limits, initial, limit, type_name};
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::escape::{c_text, literal, shown};
use crate::head::Head;
use crate::model::{Access, DataType, Entry, Place, TypeKind};
use crate::resolve::{Encoded, ValueShape};
use crate::{Note, Options};

/// The content of the files.
pub(super) struct LelyView<'a> {
    head: Head,
    dictionary: &'a TableDictionary<'a>,
    options: &'a Options,
    objects: Vec<SdevObject>,
    hooks: Vec<Hook>,
}

include!("../../expanded/lely/sdev.c.rs");
include!("../../expanded/lely/sdev.h.rs");

/// An object: a `struct co_sobj`.
pub(super) struct SdevObject {
    index: u16,
    /// The object type.
    code: &'static str,
    name: String,
    rows: Vec<SdevRow>,
}

/// An entry: a `struct co_ssub`.
struct SdevRow {
    sub: u8,
    name: String,
    data_type: &'static str,
    /// Both limits; `None` if values of the type have none.
    limits: Option<(String, String)>,
    default: String,
    value: String,
    access: &'static str,
    /// 1 if a PDO may map it.
    mapping: u8,
    flags: String,
}

impl<'a> LelyView<'a> {
    pub(super) fn new(
        dictionary: &'a TableDictionary<'a>,
        defaults: &TableDictionary<'_>,
        options: &'a Options,
        (prefix, stem): (&str, &str),
        notes: &mut Vec<Note>,
    ) -> Self {
        let objects = objects(dictionary, defaults, options.entry_names, notes);
        let hooks = hooked(dictionary, options, notes);
        let head = Head::new(dictionary.device, options, prefix, stem);
        Self { head, dictionary, options, objects, hooks }
    }

    /// The number of entries of all objects.
    fn entries(&self) -> usize {
        self.objects.iter().map(|object| object.rows.len()).sum()
    }

    /// The members of `struct co_sdev` before its objects, with their values.
    fn members(&self) -> Vec<(&'static str, String)> {
        let device = self.dictionary.device;
        let info = device.device_info.clone().unwrap_or_default();
        let node = device.commissioning.as_ref();
        let named = |name: Option<&String>| match name {
            Some(name) if self.options.entry_names => text(name),
            _ => "NULL".to_owned(),
        };
        let number = |number: Option<u32>| format!("0x{:08X}u", number.unwrap_or(0));
        let dummies =
            device.dummy_usage.iter().flat_map(|usage| &usage.types).filter(|(_, allowed)| **allowed);
        let dummies = dummies.filter(|(data_type, _)| data_type.0 < 32);
        let dummies = dummies.fold(0, |bits: u32, (data_type, _)| bits | 1 << data_type.0);
        let mut rates: Vec<String> =
            info.baud_rates.supported().map(|rate| format!("CO_BAUD_{rate}")).collect();
        rates.reverse(); // the highest first
        rates.extend((info.baud_rates.auto == Some(true)).then(|| "CO_BAUD_AUTO".to_owned()));
        let rate = node.and_then(|node| node.baud_rate).unwrap_or(0);
        vec![
            ("id", format!("0x{:02X}u", self.dictionary.node_id.unwrap_or(UNCONFIGURED))),
            ("name", named(node.and_then(|node| node.node_name.as_ref()))),
            ("vendor_name", named(info.vendor_name.as_ref())),
            ("vendor_id", number(info.vendor_number)),
            ("product_name", named(info.product_name.as_ref())),
            ("product_code", number(info.product_number)),
            ("revision", number(info.revision_number)),
            ("order_code", named(info.order_code.as_ref())),
            ("baud", if rates.is_empty() { "0".to_owned() } else { rates.join(" | ") }),
            ("rate", format!("{rate}u")),
            ("lss", u8::from(info.lss_supported == Some(true)).to_string()),
            ("dummy", format!("0x{dummies:08X}u")),
        ]
    }
}

/// A string of the description, complete if C has a literal for it.
fn text(text: &str) -> String {
    literal(text.as_bytes()).unwrap_or_else(|| c_text(text))
}

/// The objects of a dictionary; `defaults` is the dictionary of the same device without configuration.
pub(super) fn objects(
    dictionary: &TableDictionary<'_>,
    defaults: &TableDictionary<'_>,
    names: bool,
    notes: &mut Vec<Note>,
) -> Vec<SdevObject> {
    let node_id = dictionary.node_id.unwrap_or(UNCONFIGURED);
    let rows = |object: &ResolvedObject<'_>, default: &ResolvedObject<'_>, notes: &mut Vec<Note>| {
        let pairs = object.entries.iter().zip(&default.entries).take(MOST_ENTRIES);
        pairs.map(|(entry, default)| row((object, entry), default, (names, node_id), notes)).collect()
    };
    let pairs = dictionary.objects.iter().zip(&defaults.objects);
    let objects = pairs.map(|(object, default)| {
        if let Some(entry) = object.entries.get(MOST_ENTRIES) {
            let text = "an object of the stack has at most 255 entries; the last one is omitted";
            notes.push(Note::new(Place::entry(object.index, entry.sub), text));
        }
        SdevObject {
            index: object.index,
            code: object.object.object_type().name(),
            name: if names { text(name_of(&object.object.main)) } else { "NULL".to_owned() },
            rows: rows(object, default, notes),
        }
    });
    objects.collect()
}

/// The denotation, otherwise the name.
fn name_of(entry: &Entry) -> &str {
    let denotation = entry.configured.as_ref().and_then(|configured| configured.denotation.as_deref());
    denotation.filter(|text| !text.is_empty()).unwrap_or(&entry.name)
}

fn row(
    (object, entry): (&ResolvedObject<'_>, &ResolvedEntry<'_>),
    default: &ResolvedEntry<'_>,
    (names, node_id): (bool, u8),
    notes: &mut Vec<Note>,
) -> SdevRow {
    let resolved = &entry.resolved;
    let place = Place::entry(object.index, entry.sub);
    let data_type = data_type(resolved.shape);
    if let ValueShape::Block(_) = resolved.shape {
        let text = "the stack does not support device-specific types; the entry becomes an UNSIGNED or OCTET_STRING of its length";
        notes.push(Note::new(place.clone(), text));
    }
    let file = file_of(&entry.entry, data_type);
    if let Some((_, name)) = file {
        let text = format!("the library transfers the file `{}` in place of a value", shown(name));
        notes.push(Note::new(place.clone(), text));
    }
    if data_type.kind() == TypeKind::UnicodeString
        && matches!(&resolved.default, Encoded::Bytes(bytes) if bytes.chunks(2).any(|pair| pair == [0, 0]))
    {
        notes.push(Note::new(place, "the library truncates a UNICODE_STRING at its first zero character"));
    }
    let limits = |low: &Option<Encoded>, high: &Option<Encoded>| {
        let of = |datum: &Option<Encoded>, of_type| limit(datum.as_ref(), data_type, of_type, node_id);
        (of(low, "MIN"), of(high, "MAX"))
    };
    let value = initial(resolved, node_id);
    SdevRow {
        sub: entry.sub,
        name: if names { text(name_of(&entry.entry)) } else { "NULL".to_owned() },
        data_type: type_name(data_type),
        limits: has_limits(data_type).then(|| limits(&resolved.low, &resolved.high)),
        default: initial(&default.resolved, node_id),
        value: file.map_or(value, |(_, name)| super::value::file(name)),
        access: match file {
            Some((UPLOAD, _)) => "ro", // the library demands the access type that fits the direction
            Some(_) => "wo",
            None => access(entry),
        },
        mapping: u8::from(resolved.tpdo || resolved.rpdo),
        flags: flags(entry, &default.resolved.default, file.map(|(flag, _)| flag)),
    }
}

/// Uploads read the file, downloads write it.
const UPLOAD: &str = "UPLOAD_FILE";
const DOWNLOAD: &str = "DOWNLOAD_FILE";

/// The file that the library uses instead of a value, and its flag.
fn file_of(entry: &Entry, data_type: DataType) -> Option<(&'static str, &str)> {
    let configured = entry.configured.as_ref().filter(|_| data_type.kind() == TypeKind::Domain)?;
    if configured.value.is_some() {
        return None;
    }
    let upload = configured.upload_file.as_deref().map(|name| (UPLOAD, name));
    upload.or(configured.download_file.as_deref().map(|name| (DOWNLOAD, name)))
}

/// The access type, which for a `rw` entry also states the PDOs that map it.
fn access(entry: &ResolvedEntry<'_>) -> &'static str {
    let resolved = &entry.resolved;
    match (resolved.access, resolved.tpdo, resolved.rpdo) {
        (Access::Rw, true, false) => Access::Rwr.name(),
        (Access::Rw, false, true) => Access::Rww.name(),
        (access, ..) => access.name(),
    }
}

/// The flags of a row: `ObjFlags`, files, and where the node-ID is part of a number.
fn flags(entry: &ResolvedEntry<'_>, default: &Encoded, file: Option<&'static str>) -> String {
    let resolved = &entry.resolved;
    let formula = |datum: Option<&Encoded>| datum.is_some_and(Encoded::is_formula);
    let flags = entry.entry.flags();
    let named = [
        ("READ", flags.0 & 1 != 0), // the library names the bits by the rejected transfers, uploads and downloads
        ("WRITE", flags.0 & 2 != 0),
        (UPLOAD, file == Some(UPLOAD)),
        (DOWNLOAD, file == Some(DOWNLOAD)),
        ("MIN_NODEID", formula(resolved.low.as_ref())),
        ("MAX_NODEID", formula(resolved.high.as_ref())),
        ("DEF_NODEID", formula(Some(default))),
        ("VAL_NODEID", formula(Some(&resolved.default))),
        ("PARAMETER_VALUE", entry.entry.configured_value().is_some()),
    ];
    let set: Vec<String> =
        named.iter().filter(|(_, set)| *set).map(|(name, _)| format!("CO_OBJ_FLAGS_{name}")).collect();
    if set.is_empty() { "0".to_owned() } else { set.join(" | ") }
}

/// Maximum number of entries of an object: `nsub` is a byte.
pub(super) const MOST_ENTRIES: usize = 255;

/// An object for which the library calls functions of the application.
pub(super) struct Hook {
    pub(super) index: u16,
    /// The sub-indexes for which it calls one on uploads.
    pub(super) read: Vec<u8>,
    /// The sub-indexes for which it calls one on downloads.
    pub(super) written: Vec<u8>,
}

/// Whether the library has its own function for downloads to an object.
fn is_of_library(index: u16) -> bool {
    matches!(
        index,
        0x1003 | 0x1005 | 0x1006 | 0x100C | 0x100D | 0x1012 | 0x1014 | 0x1016 | 0x1017 | 0x1019 | 0x1028
        | 0x1200..=0x12FF | 0x1400..=0x1BFF | 0x1F25 | 0x1F80 | 0x1F82
    )
}

/// The objects with entries in the options. Notes report entries for which the library calls no function.
pub(super) fn hooked(
    dictionary: &TableDictionary<'_>,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Vec<Hook> {
    let mut hooks: Vec<Hook> = Vec::new();
    for &at in &options.hooks {
        let entries = dictionary.object(at.index).map_or(&[][..], |object| &object.entries);
        let entries = entries.iter().take(MOST_ENTRIES);
        let mut asked = entries.filter(|entry| at.sub.is_none_or(|sub| sub == entry.sub)).peekable();
        if asked.peek().is_none() {
            notes.push(Note::new(Place::at(at.index, at.sub), "no entry to call a hook for"));
            continue;
        }
        if hooks.last().is_none_or(|hook| hook.index != at.index) {
            hooks.push(Hook { index: at.index, read: Vec::new(), written: Vec::new() });
        }
        let Some(hook) = hooks.last_mut() else { continue };
        for entry in asked {
            let access = entry.resolved.access;
            if access.is_writable() && is_of_library(at.index) {
                let text =
                    "the library has its own function for downloads, so the hook is called for uploads only";
                notes.push(Note::new(Place::entry(at.index, entry.sub), text));
            } else if access.is_writable() && !hook.written.contains(&entry.sub) {
                hook.written.push(entry.sub);
            }
            if access.is_readable() && !hook.read.contains(&entry.sub) {
                hook.read.push(entry.sub);
            }
        }
    }
    hooks
}
