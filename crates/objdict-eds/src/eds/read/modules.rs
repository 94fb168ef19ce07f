//! The modules of a modular device.

use super::EdsReader;
use super::info::comment_lines;
use super::items::Items;
use super::lists::{index_list, numbered};
use super::objects::{SectionKind, read_object, read_object_section};
use crate::ini;
use crate::literal::{self, Quirks};
use crate::model::{Entry, Extension, Extra, Field, Module, ModulePart, Modules, Object, Reason};

const U8: (i64, u64) = (0, u8::MAX as u64);
const U16: (i64, u64) = (0, u16::MAX as u64);

impl EdsReader<'_> {
    fn modules_mut(&mut self) -> &mut Modules {
        self.device.modules.get_or_insert_default()
    }

    pub(super) fn supported_modules(&mut self, section: &ini::Section) {
        let mut modules = self.device.modules.take().unwrap_or_default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|items, item| match item.field() {
            Some(Field::NrOfEntries) => {
                modules.declared = items.integer(item, U16, &mut modules.invalid_values);
            }
            _ => items.unknown(item, &mut modules.extra),
        });
        self.device.modules = Some(modules);
    }

    pub(super) fn connected_modules(&mut self, section: &ini::Section) {
        let mut modules = self.device.modules.take().unwrap_or_default();
        let invalid_values = &mut modules.invalid_values;
        let mut items = Items::new(self.text, section, &mut self.findings);
        let connected = numbered(&mut items, &Field::NrOfEntries, &mut modules.extra, |items, item, _| {
            items.integer(item, U16, invalid_values)
        });
        modules.connected = Some(connected);
        self.device.modules = Some(modules);
    }

    pub(super) fn module(&mut self, number: u16, part: ModulePart, section: &ini::Section) {
        let text = self.text;
        let mut module = self.modules_mut().supported.remove(&number).unwrap_or_default();
        let mut items = Items::new(text, section, &mut self.findings);
        let mut extra = Extra::default();
        match part {
            ModulePart::Info => module_info(&mut module, &mut items),
            ModulePart::Comments => module.comments = comment_lines(&mut items, &mut extra),
            ModulePart::FixedObjects => {
                module.fixed_list = index_list(&mut items, &Field::NrOfEntries, &mut extra);
            }
            ModulePart::SubExtends => {
                module.extension_list = index_list(&mut items, &Field::NrOfEntries, &mut extra);
            }
            ModulePart::Fixed(index) => {
                read_object(&mut items, module.fixed.entry(index).or_default());
            }
            ModulePart::FixedEntry(index, sub) => {
                let mut entry = Entry::default();
                read_object_section(&mut items, SectionKind::Entry, &mut entry);
                let orphan = || Box::new(Object { orphan: true, ..Object::default() });
                module.fixed.entry(index).or_insert_with(orphan).subs.insert(sub, entry);
            }
            ModulePart::SubExt(index) => {
                let mut entry = Entry::default();
                let read = read_object_section(&mut items, SectionKind::Extension, &mut entry);
                let extension = Extension { entry, count: read.count, obj_extend: read.obj_extend };
                module.extensions.insert(index, Box::new(extension));
            }
        }
        for (key, value) in extra.iter() {
            module.extra.push(key, value);
        }
        self.modules_mut().supported.insert(number, module);
    }
}

fn module_info(module: &mut Module, items: &mut Items<'_>) {
    items.each(|items, item| match item.field() {
        Some(Field::ProductName) => module.product_name = Some(items.text(item).to_owned()),
        Some(Field::ProductVersion) => {
            module.product_version = items.integer(item, U8, &mut module.invalid_values);
        }
        Some(Field::ProductRevision) => {
            module.product_revision = items.integer(item, U8, &mut module.invalid_values);
        }
        Some(Field::OrderCode) => module.order_code = Some(items.text(item).to_owned()),
        _ => items.unknown(item, &mut module.extra),
    });
}

/// `0xA080-0xA0BF`.
pub(super) fn index_range(text: &str) -> Result<(u16, u16), Reason> {
    let (low, high) = text.split_once('-').ok_or(Reason::Malformed)?;
    let index = |text: &str| {
        let number =
            literal::integer_in_line(text.trim_ascii(), 0, u64::from(u16::MAX), &mut Quirks::default())?;
        u16::try_from(number).map_err(|_| Reason::Malformed)
    };
    Ok((index(low)?, index(high)?))
}
