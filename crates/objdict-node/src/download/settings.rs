//! Target values of a description: collected, resolved for the node, checked.

use std::collections::BTreeMap;

use super::transfer::{Beyond, EntryType, beyond, bytes_of};
use super::{
    Download, NeededFile, Plan, PlanError, PlanOptions, Problem, ProblemKind, Scope, SkipReason, Skipped,
    Step,
};
use crate::model::{
    Access, CobId, Device, Entry, ExplicitDownload, Field, Moment, Object, ObjectType, Place,
};

/// Index and sub-index.
pub(super) type EntryKey = (u16, u8);

/// The entries of a device that a download may write.
pub(super) struct WritableEntries<'a> {
    device: &'a Device,
    /// Includes the node-ID for formulas.
    options: PlanOptions,
    /// In ascending order, the order of the dictionary, for binary search.
    entries: Vec<(EntryKey, WritableEntry<'a>)>,
    problems: BTreeMap<EntryKey, Problem>,
    skipped: BTreeMap<EntryKey, Skipped>,
}

/// An entry that a download may write.
struct WritableEntry<'a> {
    object: &'a Object,
    entry: &'a Entry,
    entry_type: EntryType,
    /// Whether the plan must write it.
    wanted: bool,
}

/// Objects that trigger an action when written: store and restore (1010h, 1011h), OS commands (1023h-1026h),
/// configure slave (1F25h), program download and control (1F50h, 1F51h), request NMT and guarding (1F82h,
/// 1F83h).
pub(super) const fn is_command(index: u16) -> bool {
    matches!(index, 0x1010 | 0x1011 | 0x1023..=0x1026 | 0x1F25 | 0x1F50 | 0x1F51 | 0x1F82 | 0x1F83)
}

/// Whether the object is a parameter of a PDO.
const fn is_pdo(index: u16) -> bool {
    matches!(index, 0x1400..=0x1BFF)
}

/// Whether sub-index 0 of the object is the number of mapped objects.
const fn is_mapping(index: u16) -> bool {
    matches!(index, 0x1381..=0x13C0 | 0x1600..=0x17FF | 0x1A00..=0x1BFF)
}

impl<'a> WritableEntries<'a> {
    /// Collects the entries of `device`; entries with a configured value that cannot be written are recorded
    /// as skipped. Compact storage is read from `expanded`, which describes every entry.
    pub(super) fn collect(
        device: &'a Device,
        expanded: &'a BTreeMap<u16, Object>,
        options: &PlanOptions,
    ) -> Self {
        let options =
            PlanOptions { node_id: options.node_id.or_else(|| device.node_id()), ..options.clone() };
        let (entries, problems, skipped) = Default::default();
        let mut settings = Self { device, options, entries, problems, skipped };
        for (index, object) in &device.objects {
            let object = expanded.get(index).unwrap_or(object);
            for (sub, entry) in object.stated() {
                settings.add((*index, sub), object, entry);
            }
            if is_pdo(*index) {
                settings.leave_fixed(*index, object);
            }
        }
        settings
    }

    fn add(&mut self, (index, sub): EntryKey, object: &'a Object, entry: &'a Entry) {
        let is_asked = self.is_asked(index);
        let unreadable = unreadable_value(entry).is_some();
        let from_file = download_file(entry).is_some();
        let differs =
            from_file || is_configured(entry) && (unreadable || entry.is_changed(self.options.node_id));
        if let Some(reason) = skip_reason(index, object, entry, &self.options) {
            if differs && is_asked {
                self.skipped.insert((index, sub), Skipped { place: place((index, sub), object), reason });
            }
            return;
        }
        let count = sub == 0 && object.object_type().has_subs() && !is_mapping(index);
        let has_value = entry.value().is_some() || unreadable || from_file;
        let is_complete = self.writes_all() || self.options.scope == Scope::Pdos && is_pdo(index);
        // a later explicit download sets its value
        let is_given =
            self.device.downloads.iter().any(|download| {
                download.when == Moment::After && (download.index, download.sub) == (index, sub)
            });
        let wanted = is_asked && !is_given && (differs || is_complete && has_value && !count);
        let entry_type = EntryType::of(self.device, object, (index, sub), entry);
        self.entries.push(((index, sub), WritableEntry { object, entry, entry_type, wanted }));
    }

    /// Skips entries that a node does not allow to change: a mapping whose number of mapped objects is not 0 and
    /// cannot be written (CiA 301 §7.5.2.36), and unchanged values of a PDO that cannot be disabled.
    fn leave_fixed(&mut self, index: u16, object: &Object) {
        let count = object.entry(0).and_then(|entry| entry.value()?.as_integer());
        let is_fixed =
            is_mapping(index) && !self.can_write((index, 0)) && count.is_some_and(|count| count > 0);
        let cob_id = (index & !0x0200, 1);
        let present =
            self.device.object(cob_id.0).and_then(|object| CobId::from_value(object.value(1)?.as_ref()));
        let is_locked = !self.can_write(cob_id) && present.is_some_and(CobId::is_valid);
        if !is_fixed && !is_locked {
            return;
        }
        let first = self.entries.partition_point(|&(key, _)| key < (index, 0));
        let mut leaves_configured = false;
        for (_, setting) in &mut self.entries[first..] {
            setting.wanted &= is_configured(setting.entry);
            leaves_configured |= setting.wanted;
            setting.wanted &= !is_fixed;
        }
        if leaves_configured && is_fixed {
            let skipped = Skipped { place: Place::object(index), reason: SkipReason::FixedMapping };
            self.skipped.insert((index, 0), skipped);
        }
    }

    /// Whether the options select the object.
    fn is_asked(&self, index: u16) -> bool {
        self.options.only.as_ref().is_none_or(|only| only.contains(&index))
    }

    /// The explicit downloads that the description requires.
    pub(super) fn explicit(&mut self, when: Moment) -> Vec<Step> {
        let device = self.device;
        let mut steps = Vec::new();
        for ExplicitDownload { when: moment, index, sub, value } in &device.downloads {
            if *moment != when || !self.is_asked(*index) {
                continue;
            }
            match bytes_of(device, *index, *sub, value, self.options.node_id) {
                Ok(data) => steps.push(Step::Write(Download::new(*index, *sub, data))),
                Err(kind) => {
                    let place = device.object(*index).map(|object| place((*index, *sub), object));
                    let place = place.unwrap_or_else(|| Place::entry(*index, *sub));
                    self.problems.entry((*index, *sub)).or_insert(Problem { place, kind });
                }
            }
        }
        steps
    }

    fn find(&self, key: EntryKey) -> Option<&WritableEntry<'a>> {
        let found = self.entries.binary_search_by_key(&key, |&(other, _)| other);
        found.ok().map(|position| &self.entries[position].1)
    }

    /// Whether a download may write the entry.
    pub(super) fn can_write(&self, key: EntryKey) -> bool {
        self.find(key).is_some()
    }

    /// Whether the plan must write the entry.
    pub(super) fn wants(&self, key: EntryKey) -> bool {
        self.find(key).is_some_and(|setting| setting.wanted)
    }

    /// The entries that the plan must write.
    pub(super) fn wanted(&self) -> Vec<EntryKey> {
        self.entries.iter().filter(|(_, setting)| setting.wanted).map(|&(key, _)| key).collect()
    }

    /// The writable sub-indexes of an object.
    pub(super) fn subs(&self, index: u16) -> Vec<u8> {
        let first = self.entries.partition_point(|&(key, _)| key < (index, 0));
        let entries = self.entries[first..].iter().take_while(|&&((other, _), _)| other == index);
        entries.map(|&((_, sub), _)| sub).collect()
    }

    /// Whether all values are written, even those that equal the default.
    pub(super) fn writes_all(&self) -> bool {
        self.options.scope == Scope::All
    }

    /// The download that sets the entry to its target value, if it has one.
    pub(super) fn step(&mut self, key @ (index, sub): EntryKey) -> Option<Step> {
        let setting = self.find(key)?;
        if let Some(name) = download_file(setting.entry) {
            return Some(Step::File(NeededFile { index, sub, name: name.into() }));
        }
        let bytes = setting.bytes(self.options.node_id)?;
        self.noted(key, bytes).map(|data| Step::Write(Download { index, sub, data }))
    }

    /// The bytes of the target value; `None` without a value or, after recording a problem, if it is not
    /// valid.
    pub(super) fn target(&mut self, key: EntryKey) -> Option<Vec<u8>> {
        let bytes = self.find(key)?.bytes(self.options.node_id)?;
        self.noted(key, bytes)
    }

    /// [`target`](Self::target) of a 32-bit entry, as a number.
    pub(super) fn target_number(&mut self, key: EntryKey) -> Option<u32> {
        self.target(key)?.try_into().ok().map(u32::from_le_bytes)
    }

    /// The default of a 32-bit entry as a number; `None` if the description does not state it.
    pub(super) fn default_number(&mut self, key: EntryKey) -> Option<u32> {
        let setting = self.find(key)?;
        let bytes = match setting.entry_type.bytes(setting.entry.default.as_ref()?, self.options.node_id) {
            Err(kind @ ProblemKind::NeedsNodeId(_)) => self.noted(key, Err(kind)),
            // an invalid default is treated as unknown
            bytes => bytes.ok(),
        };
        bytes?.try_into().ok().map(u32::from_le_bytes)
    }

    /// Records that a service must be disabled but cannot be.
    pub(super) fn no_cob_id(&mut self, key: EntryKey) {
        self.noted::<()>(key, Err(ProblemKind::NoCobId));
    }

    /// Records that an unused mapping entry is skipped.
    pub(super) fn unused(&mut self, key: EntryKey) {
        if let Some(setting) = self.find(key).filter(|setting| setting.entry.configured_value().is_some()) {
            let skipped = Skipped { place: place(key, setting.object), reason: SkipReason::Unused };
            self.skipped.insert(key, skipped);
        }
    }

    fn noted<T>(&mut self, key: EntryKey, result: Result<T, ProblemKind>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(kind) => {
                if let Some(setting) = self.find(key) {
                    let place = place(key, setting.object);
                    self.problems.entry(key).or_insert(Problem { place, kind });
                }
                None
            }
        }
    }

    /// The plan, or the recorded problems.
    pub(super) fn finish(self, steps: Vec<Step>) -> Result<Plan, PlanError> {
        if !self.problems.is_empty() {
            return Err(PlanError::Problems(self.problems.into_values().collect()));
        }
        Ok(Plan { steps, skipped: self.skipped.into_values().collect() })
    }
}

impl WritableEntry<'_> {
    /// Encodes the target value and checks its limits. `None` without a value.
    fn bytes(&self, node_id: Option<u8>) -> Option<Result<Vec<u8>, ProblemKind>> {
        if let Some(text) = unreadable_value(self.entry) {
            return Some(Err(ProblemKind::Unreadable(text.into())));
        }
        let value = self.entry.value()?;
        let bytes = self.entry_type.bytes(value, node_id);
        Some(bytes.and_then(|bytes| match beyond(self.entry, value, node_id) {
            Some(Beyond::Low(limit)) => Err(ProblemKind::BelowLimit { value: value.clone(), limit }),
            Some(Beyond::High(limit)) => Err(ProblemKind::AboveLimit { value: value.clone(), limit }),
            None => Ok(bytes),
        }))
    }
}

/// The place of an entry in the description.
fn place((index, sub): EntryKey, object: &Object) -> Place {
    if object.object_type().has_subs() { Place::entry(index, sub) } else { Place::object(index) }
}

/// Why a download does not write the entry.
fn skip_reason(index: u16, object: &Object, entry: &Entry, options: &PlanOptions) -> Option<SkipReason> {
    let object_type = object.object_type();
    if index < 0x1000 || matches!(object_type, ObjectType::Null | ObjectType::DefType | ObjectType::DefStruct)
    {
        return Some(SkipReason::Definition);
    }
    let is_domain = entry.object_type == Some(ObjectType::Domain);
    match entry.access.or(is_domain.then_some(Access::Rw)) {
        None => return Some(SkipReason::NoAccess),
        Some(access) if !access.is_writable() => return Some(SkipReason::NotWritable),
        Some(_) => {}
    }
    if entry.flags().refuses_write() || object.main.flags().refuses_write() {
        return Some(SkipReason::RefusesWrite);
    }
    match index {
        0x1003 => Some(SkipReason::ClearsHistory),
        _ if is_command(index) && !options.commands => Some(SkipReason::Command),
        _ => None,
    }
}

/// Whether the description configures the entry, with a legal value or not.
fn is_configured(entry: &Entry) -> bool {
    entry.configured_value().is_some() || entry.invalid_values.get(&Field::ParameterValue).is_some()
}

/// The text of the target value if it is not valid for its data type.
fn unreadable_value(entry: &Entry) -> Option<&str> {
    if entry.configured_value().is_some() {
        return None;
    }
    let invalid = |field| entry.invalid_values.get(&field).map(|invalid| &*invalid.text);
    invalid(Field::ParameterValue).or_else(|| invalid(Field::DefaultValue))
}

/// The name of the file with the data of the entry.
fn download_file(entry: &Entry) -> Option<&str> {
    entry.configured.as_ref()?.download_file.as_deref()
}
