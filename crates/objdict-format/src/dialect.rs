//! The readers of an EDS or DCF: one table of the required style of each tool, and the findings that are
//! fixed for it.

use std::borrow::Cow;
use std::collections::BTreeSet;

use super::complete::complete;
use crate::Style;
use objdict_model::diagnostic::Tool;
use objdict_model::literal::RealSpelling;
use objdict_model::model::{
    DataType, Device, EMBEDDED_SECTION, Entry, Extra, ExtraSection, Field, InvalidValues, Object, ObjectType,
    TypeKind, Value,
};

/// The intended reader of an EDS or DCF.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Dialect {
    /// Any tool that reads CiA 306.
    #[default]
    Cia306,
    /// The tools of Lely core: dcf-tools and dcf2c.
    Lely,
    /// The library canopen for Python.
    PythonCanopen,
    /// CANopenEditor.
    CanOpenEditor,
    /// CODESYS.
    Codesys,
    /// All of the tools of Lely core, canopen for Python and npm, canopen-host and CANopenEditor.
    Portable,
}

/// The requirements of a reader.
struct ReaderRow {
    dialect: Dialect,
    name: &'static str,
    /// The tools whose reactions to findings are known.
    tools: &'static [Tool],
    real: RealSpelling,
    quote_strings: bool,
    /// `DataType` and `AccessType` at every entry, and an object above every entry.
    complete: bool,
    /// All three object lists, with the objects that belong into them.
    lists: bool,
    /// Only sections and keys that the tool supports.
    known_only: bool,
    /// The sections about the file and the device, even if empty.
    frame: bool,
    /// Keys for the unit, factor and description of an entry.
    meanings: bool,
    /// No content that CANopenEditor skips, misreads or crashes on.
    for_editor: bool,
    /// No content that one of the readers rejects or misreads.
    agreed: bool,
}

const ANY: ReaderRow = ReaderRow {
    dialect: Dialect::Cia306,
    name: "cia306",
    tools: &[],
    real: RealSpelling::Decimal,
    quote_strings: false,
    complete: false,
    lists: false,
    known_only: false,
    frame: false,
    meanings: false,
    for_editor: false,
    agreed: false,
};

/// All readers.
const ROWS: [ReaderRow; 6] = [
    ANY,
    ReaderRow {
        dialect: Dialect::Lely,
        name: "lely",
        tools: &[Tool::DcfTools],
        real: RealSpelling::Hex,
        quote_strings: true,
        complete: true,
        lists: true,
        known_only: true,
        ..ANY
    },
    ReaderRow {
        dialect: Dialect::PythonCanopen,
        name: "python-canopen",
        tools: &[Tool::PythonCanopen],
        complete: true,
        frame: true,
        meanings: true,
        ..ANY
    },
    ReaderRow {
        dialect: Dialect::CanOpenEditor,
        name: "canopeneditor",
        tools: &[Tool::CanOpenEditor],
        complete: true,
        lists: true,
        frame: true,
        for_editor: true,
        ..ANY
    },
    ReaderRow { dialect: Dialect::Codesys, name: "codesys", tools: &[Tool::Codesys], ..ANY },
    ReaderRow {
        dialect: Dialect::Portable,
        name: "portable",
        tools: &[Tool::DcfTools, Tool::PythonCanopen, Tool::NodeCanopen, Tool::CanOpenEditor],
        complete: true,
        lists: true,
        known_only: true,
        frame: true,
        for_editor: true,
        agreed: true,
        ..ANY
    },
];

impl Dialect {
    /// All dialects.
    pub const ALL: [Self; 6] =
        [Self::Cia306, Self::Lely, Self::PythonCanopen, Self::CanOpenEditor, Self::Codesys, Self::Portable];

    fn row(self) -> &'static ReaderRow {
        ROWS.iter().find(|row| row.dialect == self).unwrap_or(&ROWS[0])
    }

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The tools whose findings are fixed; empty for CiA 306 itself.
    pub fn tools(self) -> &'static [Tool] {
        self.row().tools
    }

    /// How values are spelled.
    pub fn style(self) -> Style {
        let ReaderRow { real, quote_strings, meanings, .. } = *self.row();
        Style { real, quote_strings, meanings, ..Style::default() }
    }

    /// The device with the content that the reader requires, and without the content that it rejects.
    pub(super) fn adapted(self, device: &Device) -> Cow<'_, Device> {
        let row = self.row();
        // no reader supports keys before the first section
        let is_stray = |section: &ExtraSection| section.name().is_empty();
        if !row.complete && !device.extra.iter().any(is_stray) {
            return Cow::Borrowed(device);
        }
        let original = device;
        let mut device = device.clone();
        device.extra.retain(|section| !is_stray(section));
        if !row.complete {
            return Cow::Owned(device);
        }
        device.objects.retain(|_, object| !object.orphan);
        for (&index, object) in device.objects.iter_mut() {
            settle_kind(object);
            complete(original, index, object);
        }
        if row.known_only {
            remove_unknown(&mut device);
        }
        if row.frame {
            device.file_info.get_or_insert_default();
            device.device_info.get_or_insert_default();
            device.dummy_usage.get_or_insert_default();
            device.comments.get_or_insert_default();
        }
        if let Some(usage) = &mut device.dummy_usage {
            (1..=7).for_each(|number| _ = usage.types.entry(DataType(number)).or_insert(false));
            usage.invalid_values = InvalidValues::default();
        }
        if let Some(info) = &mut device.device_info {
            // non-numeric strings are rejected
            info.invalid_values = InvalidValues::default();
        }
        if row.lists {
            list_all(&mut device);
        }
        if row.for_editor {
            adapt_to_editor(&mut device);
        }
        if row.agreed {
            device.objects.values_mut().for_each(keep_agreed);
        }
        Cow::Owned(device)
    }
}

/// Removes content that CANopenEditor skips, misreads or crashes on.
fn adapt_to_editor(device: &mut Device) {
    // it adds the keys of an unknown section to the previous one, and those of `[4900sub100]` to sub-index
    // 100h
    let is_passed_over = |name: &str| {
        let is_plain = name.bytes().all(|byte| byte.is_ascii_alphanumeric());
        is_plain && !name.replace("sub", "").bytes().all(|byte| byte.is_ascii_hexdigit())
    };
    device.extra.retain(|section| section.name() == EMBEDDED_SECTION || is_passed_over(section.name()));
    if let Some(modules) = &mut device.modules {
        let lists = modules.supported.values_mut();
        let lists = lists.flat_map(|module| [&mut module.fixed_list, &mut module.extension_list]);
        // it identifies list items by value, so values must be unique
        for list in lists.chain(&mut modules.connected) {
            let mut seen = BTreeSet::new();
            list.retain(|number| seen.insert(*number));
        }
    }
    for object in device.objects.values_mut() {
        // it skips a sub-index that is not a VAR
        for (_, entry) in object.subs.iter_mut().filter(|(_, entry)| entry.object_type.is_some()) {
            entry.object_type = Some(ObjectType::Var);
        }
    }
}

/// Sets the object type of an object with sub-indexes.
fn settle_kind(object: &mut Object) {
    let is_var = object.main.object_type.is_some() && !object.object_type().has_subs();
    if !object.object_type().has_subs() && (object.compact.is_some() || !is_var && !object.subs.is_empty()) {
        object.main.object_type = Some(ObjectType::Array);
    }
    // an invalid number of sub-indexes is read as compact storage
    object
        .main
        .invalid_values
        .retain(|invalid| ![Field::ObjectType, Field::CompactSubObj].contains(&invalid.field));
}

/// Puts every object into the list that it belongs into.
fn list_all(device: &mut Device) {
    let is_mandatory = |index: u16| matches!(index, 0x1000 | 0x1001 | 0x1018);
    let is_vendor = |index: u16| matches!(index, 0x2000..=0x5FFF);
    let all: Vec<u16> = device.objects.keys().copied().filter(|index| *index >= 0x1000).collect();
    let lists = &mut device.lists;
    let sorted = |list: &mut Option<Vec<u16>>, belongs: &dyn Fn(u16) -> bool| {
        let list = list.get_or_insert_default();
        list.retain(|index| belongs(*index) && all.binary_search(index).is_ok());
        let missing = all.iter().filter(|index| belongs(**index) && !list.contains(index));
        let missing: Vec<u16> = missing.copied().collect();
        list.extend(missing);
    };
    sorted(&mut lists.mandatory, &is_mandatory);
    sorted(&mut lists.optional, &|index| !is_mandatory(index) && !is_vendor(index));
    sorted(&mut lists.manufacturer, &is_vendor);
}

/// Removes the sections and keys that dcf-tools rejects.
fn remove_unknown(device: &mut Device) {
    device.extra.retain(|section| section.name() == EMBEDDED_SECTION);
    device.modules = None;
    device.dynamic_channels = None;
    device.tools.clear();
    if let Some(info) = &mut device.file_info {
        clear(&mut info.extra, &mut info.invalid_values);
    }
    if let Some(info) = &mut device.device_info {
        clear(&mut info.extra, &mut info.invalid_values);
        info.baud_rates.auto = None;
        info.safety_supported = None;
    }
    if let Some(usage) = &mut device.dummy_usage {
        clear(&mut usage.extra, &mut usage.invalid_values);
    }
    if let Some(node) = &mut device.commissioning {
        clear(&mut node.extra, &mut node.invalid_values);
    }
    device.objects.retain(|index, _| *index >= 0x1000);
    device.objects.values_mut().for_each(remove_unknown_of);
    // a number of sub-indexes without any is rejected
    device.objects.retain(|_, object| {
        !object.object_type().has_subs() || object.compact.is_some() || !object.subs.is_empty()
    });
}

fn remove_unknown_of(object: &mut Object) {
    object.links.clear();
    if let Some(compact) = &mut object.compact {
        clear(&mut compact.extra, &mut compact.invalid_values);
    }
    object.subs.remove(0xFF);
    let has_subs = object.object_type().has_subs();
    let is_counted = has_subs && object.compact.is_none();
    object.sub_number = u8::try_from(object.subs.len()).ok().filter(|_| is_counted);
    if is_counted {
        object.main.access = None;
    }
    let entries = object.subs.iter_mut().map(|(_, entry)| entry);
    for entry in entries.chain([&mut object.main]) {
        entry.safety = None;
        clear(&mut entry.extra, &mut entry.invalid_values);
        if !entry.data_type.is_some_and(DataType::is_numeric) {
            (entry.low_limit, entry.high_limit) = (None, None);
        }
    }
}

/// Removes content of an object that one of the readers rejects or misreads.
fn keep_agreed(object: &mut Object) {
    let has_subs = object.object_type().has_subs();
    if let Some(count) = object.subs.get_mut(0).filter(|_| has_subs) {
        count.data_type = Some(DataType::UNSIGNED8);
    }
    if has_subs && object.compact.is_none() {
        let main = &mut object.main;
        (main.data_type, main.pdo_mapping, main.default) = (None, None, None);
    }
    if object.object_type() == ObjectType::Domain {
        object.main.pdo_mapping = None;
    }
    let entries = object.subs.iter_mut().map(|(_, entry)| entry);
    entries.chain([&mut object.main]).for_each(keep_agreed_values);
}

/// dcf-tools reads a REAL as bits where other tools read a number, and rejects values outside their type or limits;
/// node-canopen rejects swapped limits.
fn keep_agreed_values(entry: &mut Entry) {
    let Some(data_type) = entry.data_type else { return };
    let is_real = matches!(data_type.kind(), TypeKind::Real32 | TypeKind::Real64);
    let is_agreed = |value: &Value| match data_type.integer_range() {
        Some((low, high)) => [1, 127]
            .iter()
            .all(|node_id| value.integer_for(*node_id).is_some_and(|number| (low..=high).contains(&number))),
        None => !is_real,
    };
    let mut values = vec![&mut entry.default, &mut entry.low_limit, &mut entry.high_limit];
    values.extend(entry.configured.as_mut().map(|configured| &mut configured.value));
    for value in values {
        *value = value.take().filter(is_agreed);
    }
    let is_beyond = |node_id: &u8| {
        let number = |value: Option<&Value>| value?.integer_for(*node_id);
        let low = number(entry.low_limit.as_ref()).unwrap_or(i128::MIN);
        let high = number(entry.high_limit.as_ref()).unwrap_or(i128::MAX);
        let values = [number(entry.default.as_ref()), number(entry.value())];
        low > high || values.into_iter().flatten().any(|number| !(low..=high).contains(&number))
    };
    if [1, 127].iter().any(is_beyond) {
        (entry.low_limit, entry.high_limit) = (None, None);
    }
}

fn clear(extra: &mut Extra, invalid_values: &mut InvalidValues) {
    *extra = Extra::default();
    *invalid_values = InvalidValues::default();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dialect_has_a_row() {
        assert!(Dialect::ALL.iter().zip(&ROWS).all(|(dialect, row)| row.dialect == *dialect));
    }
}
