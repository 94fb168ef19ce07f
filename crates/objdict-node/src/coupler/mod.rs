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
mod mapping;
mod problem;

use std::collections::{BTreeMap, BTreeSet};

use self::growth::Growth;
pub use self::problem::ModuleProblem;
use crate::model::{Device, DeviceKind, Module, ObjectList};

/// Builds the object dictionary of a coupler with these modules, given by their number in [`Device::modules`]
/// in physical order.
///
/// A fixed object is added once, even if several modules describe it. Each module appends its sub-indexes to
/// the existing ones. Modules that share an element bit by bit start a new sub-index when the last one is
/// full. After `ObjExtend` sub-indexes the extension continues at the next index. Sub-index 0 is updated. A
/// default PDO mapping ends before the first missing entry; if that is its first entry, the PDO becomes not
/// valid. The result describes a node and contains `ConnectedModules`.
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
        mapping::shorten(&mut self.device);
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
