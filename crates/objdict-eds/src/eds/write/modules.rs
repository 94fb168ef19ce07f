//! The modules of a modular device.

use super::Writer;
use super::info::comments;
use super::objects::{Parts, index_text};
use super::sheet::Sheet;
use crate::model::{Field, Module, ModulePart, Part};

impl Writer<'_> {
    /// What modules there may be, and which are plugged in.
    pub(super) fn modules(&self, sheet: &mut Sheet<'_>) {
        let Some(modules) = &self.device.modules else { return };
        let counted = u16::try_from(modules.supported.len()).ok();
        let declared = match modules.misfits.get(&Field::NrOfEntries) {
            Some(_) => modules.declared,
            None => modules.declared.or(counted),
        };
        sheet.open(Part::SupportedModules);
        sheet.put_number(&Field::NrOfEntries, declared);
        sheet.extra(modules.extra.iter());
        sheet.misfits(&modules.misfits);
        sheet.close();
        for (&number, module) in &modules.supported {
            self.module(sheet, number, module);
        }
        if let Some(connected) = &modules.connected {
            sheet.open(Part::ConnectedModules);
            sheet.list(&Field::NrOfEntries, connected.iter().map(u16::to_string));
            sheet.close();
        }
    }

    fn module(&self, sheet: &mut Sheet<'_>, number: u16, module: &Module) {
        let part = |part| Part::Module(number, part);
        sheet.open(part(ModulePart::Info));
        sheet.put_some(&Field::ProductName, module.product_name.as_ref());
        sheet.put_number(&Field::ProductVersion, module.product_version);
        sheet.put_number(&Field::ProductRevision, module.product_revision);
        sheet.put_some(&Field::OrderCode, module.order_code.as_ref());
        sheet.extra(module.extra.iter());
        sheet.misfits(&module.misfits);
        sheet.close();
        if !module.comments.is_empty() {
            comments(sheet, part(ModulePart::Comments), &module.comments);
        }
        if !module.fixed_list.is_empty() {
            sheet.open(part(ModulePart::FixedObjects));
            sheet.list(&Field::NrOfEntries, module.fixed_list.iter().map(index_text));
            sheet.close();
        }
        for (&index, object) in &module.fixed {
            self.object(sheet, index, object, Parts::Module(number));
        }
        if !module.extension_list.is_empty() {
            sheet.open(part(ModulePart::SubExtends));
            sheet.list(&Field::NrOfEntries, module.extension_list.iter().map(index_text));
            sheet.close();
        }
        for (&index, extension) in &module.extensions {
            self.extension(sheet, part(ModulePart::SubExt(index)), index, extension);
        }
    }
}
