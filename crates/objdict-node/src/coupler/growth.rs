//! Objects extended by each connected module.

use std::collections::BTreeMap;

use super::ModuleProblem;
use crate::model::{Access, DataType, Device, Entry, Extension, ExtensionCount, Object, ObjectType, Value};

/// 1027h: the module list. Each element contains the number of its module, so the default values differ.
const MODULE_LIST: u16 = 0x1027;

/// The highest sub-index available for elements.
const LAST: u8 = 0xFE;

/// State of an object that modules extend.
#[derive(Debug)]
pub(super) struct Growth {
    /// The index in the module descriptions.
    index: u16,
    /// The object that receives the next element; differs from `index` after an overflow at `ObjExtend`.
    current: u16,
    /// The highest sub-index of `current`.
    last: u8,
    /// Unused bits of the last element, available to modules that share it.
    free: u32,
    /// Number of elements added so far; used to number their names.
    added: u32,
    /// The module that added the first element, and that element.
    first: Option<(u16, Entry)>,
}

impl Growth {
    pub(super) fn of(device: &Device, index: u16) -> Self {
        let entries = device.object(index).into_iter().flat_map(Object::entries);
        let last = entries.map(|(sub, _)| sub).filter(|&sub| sub <= LAST).max().unwrap_or(0);
        Self { index, current: index, last, free: 0, added: 0, first: None }
    }

    /// Adds the sub-indexes of one module.
    pub(super) fn add(
        &mut self,
        device: &mut Device,
        number: u16,
        extension: &Extension,
        taken: impl Fn(u16) -> bool,
    ) -> Result<(), ModuleProblem> {
        let index = self.index;
        let entry = &extension.entry;
        match &self.first {
            Some((first, other)) if !is_alike(index, other, entry) => {
                return Err(ModuleProblem::Conflict { numbers: (*first, number), index });
            }
            Some(_) => {}
            None => self.first = Some((number, entry.clone())),
        }
        let incomplete = ModuleProblem::Incomplete { number, index };
        match extension.count {
            Some(ExtensionCount::Subs(count)) => {
                // whole elements do not use the remaining bits of a shared element
                self.free = 0;
                for _ in 0..count {
                    self.element(device, number, extension, &taken)?;
                }
                Ok(())
            }
            Some(ExtensionCount::SharedBits(bits)) => {
                let size = entry.data_type.and_then(DataType::bit_length).map(u32::from).ok_or(incomplete)?;
                let bits = u32::from(bits);
                if self.free < bits {
                    self.element(device, number, extension, &taken)?;
                    self.free = size;
                }
                self.free = self.free.saturating_sub(bits);
                Ok(())
            }
            None => Err(incomplete),
        }
    }

    /// Adds one element.
    fn element(
        &mut self,
        device: &mut Device,
        number: u16,
        extension: &Extension,
        taken: &impl Fn(u16) -> bool,
    ) -> Result<(), ModuleProblem> {
        let last = match extension.obj_extend {
            None | Some(0) => LAST,
            Some(last) => last.min(LAST),
        };
        if self.last >= last {
            let next = self.current.checked_add(1).filter(|&next| !taken(next));
            let in_the_way = self.current.wrapping_add(1);
            let index = self.index;
            self.current = next.ok_or(ModuleProblem::NoRoom { number, index, next: in_the_way })?;
            self.last = 0;
        }
        self.last += 1;
        self.added += 1;
        let name = self.object_name(device, &extension.entry);
        let object = device.objects.get_or_insert_with(self.current, || array(name));
        if object.compact.is_some() {
            *object = object.expanded().into_owned();
        }
        let name = format!("{} {}", extension.entry.name, self.added).into_boxed_str();
        let object_type = Some(extension.entry.object_type.unwrap_or(ObjectType::Var));
        object.subs.insert(self.last, Entry { name, object_type, ..extension.entry.clone() });
        Ok(())
    }

    /// The name of an added object. A continuation object has the name of the first object plus a number.
    fn object_name(&self, device: &Device, element: &Entry) -> Box<str> {
        match (self.current - self.index, device.object(self.index)) {
            (number @ 1.., Some(first)) => format!("{} {}", first.name(), number + 1).into(),
            _ => element.name.clone(),
        }
    }

    /// Updates sub-index 0 of each extended object to the number of elements.
    pub(super) fn count(&self, device: &mut Device) {
        for index in self.index..=self.current {
            let Some(object) = device.objects.get_mut(&index) else { continue };
            let highest =
                object.subs.iter().map(|(sub, _)| sub).filter(|&sub| sub <= LAST).max().unwrap_or(0);
            let described = object.subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
            object.sub_number = u8::try_from(described).ok();
            if let Some(count) = object.subs.get_mut(0) {
                count.default = Some(Value::Unsigned(highest.into()));
            }
        }
    }
}

/// Whether two modules describe the elements identically, apart from the name.
fn is_alike(index: u16, first: &Entry, second: &Entry) -> bool {
    first.data_type == second.data_type
        && first.access == second.access
        && first.is_mappable() == second.is_mappable()
        && (first.default == second.default || index == MODULE_LIST)
        && first.low_limit == second.low_limit
        && first.high_limit == second.high_limit
}

/// An ARRAY without elements.
fn array(name: Box<str>) -> Object {
    let count = Entry {
        name: "Number of elements".into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(DataType::UNSIGNED8),
        access: Some(Access::Const),
        default: Some(Value::Unsigned(0)),
        ..Entry::default()
    };
    let main = Entry { name, object_type: Some(ObjectType::Array), ..Entry::default() };
    Object { main, subs: BTreeMap::from([(0, count)]).into_iter().collect(), ..Object::default() }
}
