//! The object dictionary of a coupler with its connected modules (CiA 306-1 chapter 6).
//!
//! ```
//! use objdict_eds::{eds, ini};
//! use objdict_model::model::DeviceKind;
//! use objdict_model::source::SourceFile;
//! use objdict_node::coupler::flatten;
//!
//! let text = "[SupportedModules]\nNrOfEntries=1\n[M1ModuleInfo]\nProductName=DI8\n\
//!     [M1SubExtends]\nNrOfEntries=1\n1=0x6000\n\
//!     [M1SubExt6000]\nParameterName=Inputs\nDataType=0x0005\nAccessType=ro\nPDOMapping=1\nCount=1\n";
//! let document = ini::Document::new(SourceFile::from_text("coupler.eds", text));
//! let (coupler, _) = eds::read(&document, DeviceKind::Type);
//!
//! let plugged = flatten(&coupler, &[1, 1]).expect("module 1 is supported");
//! assert_eq!(plugged.object(0x6000).map(|inputs| inputs.subs.len()), Some(3));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod growth;

use std::collections::{BTreeMap, BTreeSet};

use self::growth::Growth;
use crate::model::{CobId, Device, DeviceKind, Entry, Module, ObjectList, Value};

/// Builds the object dictionary of a coupler with these modules, given by their number in [`Device::modules`]
/// in physical order.
///
/// A fixed object is added once, even if several modules describe it. Each module appends its sub-indexes to
/// the existing ones. Modules that share an element bit by bit start a new sub-index when the last one is
/// full. After `ObjExtend` sub-indexes the extension continues at the next index. Sub-index 0 is updated. A
/// default PDO mapping ends before the first missing entry; if that is its first entry, the PDO is marked as
/// not valid. The result describes a node and contains `ConnectedModules`.
///
/// # Errors
/// Lists every problem that prevents a module from being connected.
pub fn flatten(device: &Device, connected: &[u16]) -> Result<Device, Vec<ModuleProblem>> {
    let Some(modules) = device.modules.as_ref().filter(|modules| !modules.supported.is_empty()) else {
        return Err(vec![ModuleProblem::NotModular]);
    };
    let known: Vec<u16> = modules.supported.keys().copied().collect();
    let unknown: BTreeSet<u16> =
        connected.iter().copied().filter(|number| !modules.supported.contains_key(number)).collect();
    if !unknown.is_empty() {
        let problem = |number| ModuleProblem::Unknown { number, known: known.clone() };
        return Err(unknown.into_iter().map(problem).collect());
    }
    let mut rack =
        Rack { coupler: device, device: device.clone(), growths: BTreeMap::new(), problems: Vec::new() };
    let mut plugged = BTreeMap::new();
    for &number in connected {
        let Some(module) = modules.supported.get(&number) else { continue };
        if plugged.insert(number, module).is_none() {
            rack.fix(number, module, &plugged);
        }
        rack.extend(number, module);
    }
    if !rack.problems.is_empty() {
        rack.problems.dedup();
        return Err(rack.problems);
    }
    Ok(rack.finish(connected))
}

/// The coupler with the modules added so far.
struct Rack<'a> {
    coupler: &'a Device,
    device: Device,
    /// The extended objects, by the index in the module descriptions.
    growths: BTreeMap<u16, Growth>,
    problems: Vec<ModuleProblem>,
}

impl Rack<'_> {
    /// Adds the fixed objects of a module.
    fn fix(&mut self, number: u16, module: &Module, plugged: &BTreeMap<u16, &Module>) {
        for &index in module.fixed_list.iter().filter(|index| !module.fixed.contains_key(index)) {
            self.problems.push(ModuleProblem::NotDescribed { number, index });
        }
        for (&index, object) in &module.fixed {
            if self.coupler.objects.contains_key(&index) {
                self.problems.push(ModuleProblem::Taken { number, index });
                continue;
            }
            let other =
                plugged.iter().find(|(other, module)| **other != number && module.fixed.contains_key(&index));
            match other.map(|(&first, module)| (first, &module.fixed[&index])) {
                Some((first, other)) if other != object => {
                    self.problems.push(ModuleProblem::Conflict { numbers: (first, number), index });
                }
                _ => {
                    self.device.objects.insert(index, object.as_ref().clone());
                }
            }
        }
    }

    /// Adds the sub-indexes of a module.
    fn extend(&mut self, number: u16, module: &Module) {
        for &index in module.extension_list.iter().filter(|index| !module.extensions.contains_key(index)) {
            self.problems.push(ModuleProblem::NotDescribed { number, index });
        }
        for (&index, extension) in &module.extensions {
            let mut growth = self.growths.remove(&index).unwrap_or_else(|| Growth::of(&self.device, index));
            let taken = |next: u16| self.coupler.objects.contains_key(&next);
            if let Err(problem) = growth.add(&mut self.device, number, extension, taken) {
                self.problems.push(problem);
            }
            self.growths.insert(index, growth);
        }
    }

    fn finish(mut self, connected: &[u16]) -> Device {
        self.growths.values().for_each(|growth| growth.count(&mut self.device));
        shorten(&mut self.device);
        self.list();
        if let Some(modules) = &mut self.device.modules {
            modules.connected = Some(connected.to_vec());
        }
        self.device.kind = DeviceKind::Node;
        self.device
    }

    /// Adds the new objects to the object lists.
    fn list(&mut self) {
        let new = self.device.objects.keys().filter(|index| !self.coupler.objects.contains_key(index));
        for &index in &new.copied().collect::<Vec<u16>>() {
            let list = match index {
                0x2000..=0x5FFF => ObjectList::Manufacturer,
                _ => ObjectList::Optional,
            };
            if self.device.lists.contains(index) {
                continue;
            }
            let indexes = self.device.lists.get_mut(list).get_or_insert_default();
            let position = indexes.iter().position(|&other| other > index).unwrap_or(indexes.len());
            indexes.insert(position, index);
        }
    }
}

/// Truncates each mapping at the first missing entry. A PDO without mapped entries is marked as not valid:
/// bit 31 of its COB-ID is set.
fn shorten(device: &mut Device) {
    let mut shortened = Vec::new();
    for pdo in device.pdos() {
        let is_there = |slot: &crate::model::MappingSlot| {
            slot.object.is_some_and(|mapped| {
                mapped.is_unused() || mapped.is_dummy() || device.entry(mapped.index, mapped.sub).is_some()
            })
        };
        let there = pdo.used_slots().take_while(is_there).count();
        if there < pdo.used_slots().count() {
            shortened.push((pdo.communication_index(), pdo.mapping_index(), there as u8));
        }
    }
    for (communication, mapping, there) in shortened {
        configure(device, mapping, 0, |_| Some(Value::Unsigned(there.into())));
        if there == 0 {
            configure(device, communication, 1, |cob_id| {
                Some(CobId::from_value(cob_id?)?.disabled().to_value())
            });
        }
    }
}

/// Sets the value of an entry.
fn configure(device: &mut Device, index: u16, sub: u8, value: impl Fn(Option<&Value>) -> Option<Value>) {
    let entry = device.objects.get_mut(&index).and_then(|object| object.subs.get_mut(sub));
    let Some(entry) = entry else { return };
    if let Some(value) = value(Entry::value(entry)) {
        entry.configured_mut().value = Some(value);
    }
}

/// Why modules cannot be connected.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ModuleProblem {
    /// The description has no modules.
    NotModular,
    /// The coupler does not support a module with this number.
    Unknown {
        /// The requested number.
        number: u16,
        /// The supported numbers.
        known: Vec<u16>,
    },
    /// An object that the module adds already exists in the coupler.
    Taken {
        /// The module.
        number: u16,
        /// The object.
        index: u16,
    },
    /// Two modules describe the same fixed or shared object differently.
    Conflict {
        /// The modules.
        numbers: (u16, u16),
        /// The object.
        index: u16,
    },
    /// A module lists an object without describing it.
    NotDescribed {
        /// The module.
        number: u16,
        /// The object.
        index: u16,
    },
    /// An extension lacks the number of sub-indexes or the data type.
    Incomplete {
        /// The module.
        number: u16,
        /// The object.
        index: u16,
    },
    /// The extension continues at the next index, which is already in use.
    NoRoom {
        /// The module.
        number: u16,
        /// The extended object.
        index: u16,
        /// The index in use.
        next: u16,
    },
}

objdict_model::error_messages! { ModuleProblem: {
    Self::NotModular => "the description has no modules";
    Self::Unknown { number, known } => "unknown module `{number}`; the modules are {}", listed(known);
    Self::Taken { number, index } =>
        "module {number} adds the object `{index:04X}`, which the coupler already has";
    Self::Conflict { numbers: (first, second), index } =>
        "the modules {first} and {second} describe the object `{index:04X}` differently";
    Self::NotDescribed { number, index } =>
        "module {number} lists the object `{index:04X}` but does not describe it";
    Self::Incomplete { number, index } =>
        "the extension of `{index:04X}` by module {number} is incomplete: `Count` or `DataType` is missing";
    Self::NoRoom { number, index, next } =>
        "the extension of `{index:04X}` by module {number} continues in `{next:04X}`, which is a different object";
} }

fn listed(numbers: &[u16]) -> String {
    numbers.iter().map(u16::to_string).collect::<Vec<_>>().join(", ")
}
