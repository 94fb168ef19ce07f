//! The modules of a modular device.

use super::EdsWriter;
use super::info::comments;
use super::objects::{ObjectOwner, index_text};
use super::section_writer::SectionWriter;
use crate::model::{Field, Module, ModulePart, Part};

impl EdsWriter<'_> {
    /// The supported modules, and the connected ones.
    pub(super) fn modules(&self, sections: &mut SectionWriter<'_>) {
        let Some(modules) = &self.device.modules else { return };
        let counted = u16::try_from(modules.supported.len()).ok();
        let declared = match modules.invalid_values.get(&Field::NrOfEntries) {
            Some(_) => modules.declared,
            None => modules.declared.or(counted),
        };
        sections.open(Part::SupportedModules);
        sections.put_number(&Field::NrOfEntries, declared);
        sections.close_with(&modules.extra, &modules.invalid_values);
        for (&number, module) in &modules.supported {
            self.module(sections, number, module);
        }
        if let Some(connected) = &modules.connected {
            sections.open(Part::ConnectedModules);
            sections.list(&Field::NrOfEntries, connected.iter().map(u16::to_string));
            sections.close();
        }
    }

    fn module(&self, sections: &mut SectionWriter<'_>, number: u16, module: &Module) {
        let part = |part| Part::Module(number, part);
        sections.open(part(ModulePart::Info));
        sections.put_some(&Field::ProductName, module.product_name.as_ref());
        sections.put_number(&Field::ProductVersion, module.product_version);
        sections.put_number(&Field::ProductRevision, module.product_revision);
        sections.put_some(&Field::OrderCode, module.order_code.as_ref());
        sections.close_with(&module.extra, &module.invalid_values);
        if !module.comments.is_empty() {
            comments(sections, part(ModulePart::Comments), &module.comments);
        }
        if !module.fixed_list.is_empty() {
            sections.open(part(ModulePart::FixedObjects));
            sections.list(&Field::NrOfEntries, module.fixed_list.iter().map(index_text));
            sections.close();
        }
        for (&index, object) in &module.fixed {
            self.object(sections, index, object, ObjectOwner::Module(number));
        }
        if !module.extension_list.is_empty() {
            sections.open(part(ModulePart::SubExtends));
            sections.list(&Field::NrOfEntries, module.extension_list.iter().map(index_text));
            sections.close();
        }
        for (&index, extension) in &module.extensions {
            self.extension(sections, part(ModulePart::SubExt(index)), index, extension);
        }
    }
}
