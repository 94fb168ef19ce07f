//! Objects in the zencan configuration, and their SDO answers.

use super::ConfigMaker;
use super::answers::{EntryAnswer, Held};
use super::value::Kept;
use crate::dictionary::{ResolvedEntry, ResolvedObject};
use crate::escape::toml_string;
use crate::model::{Access, ObjectType, Place};
use crate::names::{NameScope, words};
use crate::resolve::Encoded;

/// An object. Names are TOML literals.
pub(super) struct ZencanObjectView {
    pub(super) index: u16,
    pub(super) name: String,
    pub(super) kind: ObjectContent,
}

/// The content of an object.
pub(super) enum ObjectContent {
    Var(ZencanEntryView),
    Array { entry: ZencanEntryView, size: usize },
    Record(Vec<SubView>),
}

/// An entry of a record.
pub(super) struct SubView {
    pub(super) sub: u8,
    pub(super) name: String,
    /// A Rust identifier.
    pub(super) field: String,
    pub(super) entry: ZencanEntryView,
}

/// An entry, or all elements of an array.
pub(super) struct ZencanEntryView {
    pub(super) data_type: String,
    pub(super) access: &'static str,
    /// A TOML literal.
    pub(super) default: Option<String>,
    pub(super) pdo_mapping: &'static str,
    pub(super) persist: bool,
}

impl ConfigMaker<'_> {
    /// A device-specific object.
    pub(super) fn object(&mut self, object: &ResolvedObject<'_>) -> ZencanObjectView {
        let index = object.index;
        let name = toml_string(object.object.name());
        if object.is_single() {
            let entry = self.entry(object, &object.entries[0]);
            return ZencanObjectView { index, name, kind: ObjectContent::Var(entry) };
        }
        // zencan generates sub-index 0, and would treat FFh as the highest one
        let subs = object.entries.iter().filter(|entry| !matches!(entry.sub, 0 | 0xFF));
        let names: Vec<String> = subs.clone().map(|entry| words(&entry.name)).collect();
        let mut fields = NameScope::of_lower_case("flags sub0");
        fields.foresee(names.iter().map(String::as_str));
        let subs: Vec<SubView> = subs
            .zip(&names)
            .map(|(entry, name)| SubView {
                sub: entry.sub,
                name: toml_string(&entry.entry.name),
                field: fields.claim(name, format_args!("{:02x}", entry.sub)),
                entry: self.entry(object, entry),
            })
            .collect();
        let highest = subs.last().map_or(0, |sub| sub.sub);
        self.answers.put(index, 0, EntryAnswer::number(Access::Const, 1, highest.into()));
        let is_array = object.object.object_type() == ObjectType::Array || object.object.compact.is_some();
        let kind = match subs.split_first() {
            Some((first, rest)) if is_array && are_alike(first, rest) => array(subs),
            Some(_) if is_array => {
                self.note(Place::object(index), "an ARRAY whose elements differ becomes a record in zencan");
                ObjectContent::Record(subs)
            }
            _ => ObjectContent::Record(subs),
        };
        ZencanObjectView { index, name, kind }
    }

    fn entry(&mut self, object: &ResolvedObject<'_>, entry: &ResolvedEntry<'_>) -> ZencanEntryView {
        let (resolved, place) = (&entry.resolved, Place::entry(object.index, entry.sub));
        let kept = Kept::of(resolved, self.dictionary.node_id);
        if let Some(loss) = kept.loss {
            self.note(place.clone(), loss);
        }
        if resolved.limit().is_some() {
            self.note(place.clone(), "limits are not enforced: zencan does not support them");
        }
        let mut held = kept.held;
        if let (Encoded::Formula(offset), Some(node_id)) = (&resolved.default, self.dictionary.node_id) {
            self.note(place, format!("`$NODEID+{offset:#X}` is evaluated for node-ID {node_id}"));
            held = Held::Formula(*offset);
        }
        let answer = EntryAnswer {
            access: resolved.access,
            tpdo: resolved.tpdo,
            rpdo: resolved.rpdo,
            size: kept.size,
            held,
        };
        self.answers.put(object.index, entry.sub, answer);
        ZencanEntryView {
            data_type: kept.data_type,
            access: resolved.plain_access(),
            default: kept.default,
            pdo_mapping: resolved.pdo_word(["none", "tpdo", "rpdo", "both"]),
            persist: self.is_stored(object, entry),
        }
    }

    /// Whether object 1010h stores the entry.
    fn is_stored(&self, object: &ResolvedObject<'_>, entry: &ResolvedEntry<'_>) -> bool {
        let resolved = &entry.resolved;
        let described = object.object.main.stack.as_ref().and_then(|stack| stack.storage_group.as_deref());
        let is_command = object.index == 0x1011; // restores defaults
        let may_be =
            self.stores && !is_command && resolved.access.is_readable() && resolved.access.is_writable();
        may_be
            && match described.or_else(|| self.options.group_of(object.index)) {
                Some(group) => !["RAM", "ROM"].iter().any(|plain| group.eq_ignore_ascii_case(plain)),
                None => !resolved.tpdo && !resolved.rpdo,
            }
    }
}

/// Whether the sub-indexes are consecutive from 1 on and differ only in names and values.
fn are_alike(first: &SubView, rest: &[SubView]) -> bool {
    let shape = |sub: &SubView| {
        let ZencanEntryView { data_type, access, pdo_mapping, persist, .. } = &sub.entry;
        (data_type.clone(), *access, *pdo_mapping, *persist)
    };
    first.sub == 1
        && (2..=0xFF).zip(rest).all(|(sub, entry)| entry.sub == sub && shape(entry) == shape(first))
}

fn array(subs: Vec<SubView>) -> ObjectContent {
    let size = subs.len();
    let none = subs.iter().all(|sub| sub.entry.default.is_none());
    let mut defaults = Vec::with_capacity(size);
    let mut alike = None;
    for SubView { entry, .. } in subs {
        let zero = if entry.data_type.starts_with("real") { "0.0" } else { "\"\"" };
        defaults.push(entry.default.clone().unwrap_or_else(|| zero.to_owned()));
        alike.get_or_insert(entry);
    }
    match alike {
        Some(entry) => ObjectContent::Array {
            entry: ZencanEntryView {
                default: (!none).then(|| format!("[{}]", defaults.join(", "))),
                ..entry
            },
            size,
        },
        None => ObjectContent::Record(Vec::new()),
    }
}
