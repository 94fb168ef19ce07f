//! Sections and keys in the layout of dcfgen.

use std::fmt::{Display, Write as _};

/// The data types of the master's own objects.
#[derive(Clone, Copy)]
pub(super) enum Type {
    U8 = 5,
    U16 = 6,
    U32 = 7,
}

/// The text so far.
#[derive(Default)]
pub(super) struct MasterText(pub(super) String);

impl MasterText {
    pub(super) fn section(&mut self, name: &str) {
        if !self.0.is_empty() {
            self.0.push('\n');
        }
        // writing to a string does not fail
        let _ = writeln!(self.0, "[{name}]");
    }

    pub(super) fn key(&mut self, name: &str, value: impl Display) {
        let _ = writeln!(self.0, "{name}={value}");
    }

    /// Keys without values.
    pub(super) fn keys(&mut self, names: &[&str]) {
        names.iter().for_each(|name| self.key(name, ""));
    }

    /// A number of eight hexadecimal digits.
    pub(super) fn hex(&mut self, name: &str, number: u32) {
        self.key(name, hex(number));
    }

    /// An object list.
    pub(super) fn list(&mut self, name: &str, objects: Vec<u16>) {
        self.section(name);
        self.key("SupportedObjects", objects.len());
        for (number, index) in (1..).zip(objects) {
            self.key(&i32::to_string(&number), format_args!("0x{index:04X}"));
        }
    }

    /// The section of a VAR.
    pub(super) fn var(&mut self, section: &str, name: &str, data_type: Type, access: &str) {
        self.section(section);
        self.key("ParameterName", name);
        self.data(data_type as u16, access);
    }

    /// Data type and access type.
    pub(super) fn data(&mut self, data_type: u16, access: &str) {
        self.key("DataType", format_args!("0x{data_type:04X}"));
        self.key("AccessType", access);
    }

    /// A VAR with a default.
    pub(super) fn value(
        &mut self,
        section: &str,
        name: &str,
        data_type: Type,
        access: &str,
        default: impl Display,
    ) {
        self.var(section, name, data_type, access);
        self.key("DefaultValue", default);
    }

    /// The section of an object with sub-indexes, and its sub-index 0.
    pub(super) fn record(&mut self, section: &str, name: &str, kind: u8, highest: usize, sub_0: &str) {
        self.section(section);
        self.key("SubNumber", highest + 1);
        self.key("ParameterName", name);
        self.key("ObjectType", format_args!("0x{kind:02X}"));
        self.value(&format!("{section}sub0"), sub_0, Type::U8, "const", highest);
    }

    /// An object whose sub-indexes are alike, stored compactly.
    pub(super) fn compact(
        &mut self,
        section: &str,
        name: &str,
        (kind, data_type): (u8, Type),
        access: &str,
        default: Option<u32>,
        count: usize,
    ) {
        self.section(section);
        self.key("ParameterName", name);
        self.key("ObjectType", format_args!("0x{kind:02X}"));
        self.data(data_type as u16, access);
        if let Some(default) = default {
            self.hex("DefaultValue", default);
        }
        self.key("CompactSubObj", count);
    }

    /// The values of such an object.
    pub(super) fn values(
        &mut self,
        section: &str,
        values: impl IntoIterator<Item = (u8, String), IntoIter: ExactSizeIterator>,
    ) {
        let values = values.into_iter();
        self.section(&format!("{section}Value"));
        self.key("NrOfEntries", values.len());
        values.for_each(|(sub, value)| self.key(&sub.to_string(), value));
    }

    /// Like `values`, for numbers with eight hexadecimal digits.
    pub(super) fn numbers(&mut self, section: &str, values: Vec<(u8, u32)>) {
        self.values(section, values.into_iter().map(|(sub, number)| (sub, hex(number))));
    }
}

/// `0x0000002A`.
pub(super) fn hex(number: u32) -> String {
    format!("0x{number:08X}")
}
