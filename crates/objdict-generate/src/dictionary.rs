//! The object dictionary as visible on the network with resolved entries: the input of every stack backend.
//!
//! Each entry that a table cannot contain gets a note. C backends share `variables`, `c_code` and `memory::SizeTally`;
//! `rust` and `c` share `DeviceTable` and the modules for frames, defaults, meanings, storage groups and hooks. Only the
//! target `concise` needs `objdict-node`.

use std::borrow::Cow;

use super::notes::{in_order, once_per_device};
use super::resolve::{EntryPlan, Resolver};
use super::{GenerateError, Note, Options};
use crate::model::{Address, Device, Entry, Object, Part, Place};

/// The objects of a device that a table can contain.
pub(crate) struct TableDictionary<'a> {
    /// The device.
    pub(crate) device: &'a Device,
    /// The node-ID for the generated code.
    pub(crate) node_id: Option<u8>,
    /// At least one, by index.
    pub(crate) objects: Vec<ResolvedObject<'a>>,
    /// Omissions and assumptions, in order of places.
    pub(crate) notes: Vec<Note>,
}

/// An object with its entries.
pub(crate) struct ResolvedObject<'a> {
    pub(crate) index: u16,
    pub(crate) object: &'a Object,
    /// The source of its identifiers; empty to use the index.
    pub(crate) name: Cow<'a, str>,
    /// At least one, by sub-index; a VAR has sub-index 0.
    pub(crate) entries: Vec<ResolvedEntry<'a>>,
}

/// An entry: its description and the resolved data.
pub(crate) struct ResolvedEntry<'a> {
    pub(crate) sub: u8,
    pub(crate) entry: Cow<'a, Entry>,
    /// The source of its identifiers; empty to use the sub-index.
    pub(crate) name: String,
    pub(crate) resolved: EntryPlan,
}

impl ResolvedEntry<'_> {
    /// Whether the description states a storage group of the entry itself.
    pub(crate) fn is_stored(&self) -> bool {
        self.entry.stack.as_ref().is_some_and(|stack| stack.storage_group.is_some())
    }
}

impl ResolvedObject<'_> {
    /// The entry with a sub-index.
    pub(crate) fn entry(&self, sub: u8) -> Option<&ResolvedEntry<'_>> {
        self.entries.iter().find(|entry| entry.sub == sub)
    }

    /// The storage group stated in the description, otherwise in the options.
    pub(crate) fn group<'s>(&'s self, options: &'s Options) -> Option<&'s str> {
        let stated = self.object.main.stack.as_ref().and_then(|stack| stack.storage_group.as_deref());
        let stated = stated.map(str::trim).filter(|name| !name.is_empty());
        stated.or_else(|| options.group_of(self.index))
    }

    /// Whether it has a single value, so that its name needs no sub-index.
    pub(crate) fn is_single(&self) -> bool {
        !self.object.object_type().has_subs() && self.object.compact.is_none() && self.entries.len() == 1
    }
}

impl<'a> TableDictionary<'a> {
    /// Resolves the dictionary of a device.
    ///
    /// # Errors
    /// If the node-ID is not valid, a value cannot be represented, or there is no entry.
    pub(crate) fn new(device: &'a Device, options: &'a Options) -> Result<Self, GenerateError> {
        let node_id = options.node_id_of(device)?;
        let mut resolver = Resolver::new(device, options);
        let objects = device.objects.iter().filter(|(_, object)| !object.is_disabled());
        let objects: Vec<_> =
            objects.filter_map(|(&index, object)| resolve(&mut resolver, options, index, object)).collect();
        let Resolver { mut notes, errors, .. } = resolver;
        let modular = device.modules.as_ref().is_some_and(|modules| !modules.supported.is_empty());
        if modular && device.node_id().is_none() {
            let text = "objects that modules bring are not part of the table";
            let note = Note::new(Part::SupportedModules, text);
            notes.push(note.help("generate from the DCF of a node, which has them as ordinary objects"));
        }
        let is_there = |&&Address { index, sub }: &&Address| {
            let object = device.objects.get(&index);
            object.is_some_and(|object| sub.is_none_or(|sub| object.has(sub)))
        };
        for &Address { index, sub } in options.renamed.keys().filter(|at| !is_there(at)) {
            let place = Place::at(index, sub);
            notes.push(Note::new(place, "no entry to rename"));
        }
        if !errors.is_empty() {
            return Err(GenerateError::Inexpressible(in_order(errors)));
        }
        let notes = once_per_device(in_order(notes));
        if objects.is_empty() {
            return Err(GenerateError::NoEntries { notes });
        }
        Ok(Self { device, node_id, objects, notes })
    }
}

impl TableDictionary<'_> {
    /// An object.
    pub(crate) fn object(&self, index: u16) -> Option<&ResolvedObject<'_>> {
        let at = self.objects.binary_search_by_key(&index, |object| object.index).ok()?;
        self.objects.get(at)
    }

    /// An entry.
    pub(crate) fn entry(&self, index: u16, sub: u8) -> Option<&ResolvedEntry<'_>> {
        self.object(index)?.entry(sub)
    }

    /// All entries with their objects.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (&ResolvedObject<'_>, &ResolvedEntry<'_>)> {
        self.objects.iter().flat_map(|object| object.entries.iter().map(move |entry| (object, entry)))
    }
}

/// Resolves an object with its entries; `None`, with a note, if a table cannot contain any of them.
pub(crate) fn resolve<'a>(
    resolver: &mut Resolver<'_>,
    options: &'a Options,
    index: u16,
    object: &'a Object,
) -> Option<ResolvedObject<'a>> {
    compact_invalid_values(resolver, index, object);
    let mut described = 0;
    let mut entries = Vec::new();
    for (sub, entry) in object.entries() {
        described += 1;
        if let Some(resolved) = resolver.entry(object, index, sub, &entry) {
            let name = options.name_of(Address { index, sub: Some(sub) }, &entry.name).into_owned();
            entries.push(ResolvedEntry { sub, entry, name, resolved });
        }
    }
    if described == 0 {
        let note = Note::new(Place::object(index), "an object without entries is omitted");
        resolver.notes.push(note);
    }
    (!entries.is_empty()).then_some(ResolvedObject {
        index,
        object,
        name: options.name_of(Address { index, sub: None }, object.name()),
        entries,
    })
}

/// Compactly stored entries have no texts of their own; problems are reported for the object.
fn compact_invalid_values(resolver: &mut Resolver<'_>, index: u16, object: &Object) {
    let Some(compact) = &object.compact else { return };
    let data_type = object.main.data_type.unwrap_or(crate::model::DataType(0));
    resolver.invalid_values(&Place::object(index), &object.main, data_type);
    for invalid in compact.invalid_values.iter() {
        let text = format!("`{}` is not a valid {data_type}; the default is used", invalid.text);
        let place = Place::of(Part::CompactValues(index)).field(invalid.field.clone());
        resolver.notes.push(Note::new(place, text));
    }
}
