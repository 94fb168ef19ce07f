use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Findings, Text, counted, say, sub_index};
use crate::model::{DataType, Device, DeviceKind, ExtensionCount, Field, Modules, Object, Part, Place};
use crate::{rule, stated};

rule! {
    "cia306/missing-module-object", Warning, Device(check);
    summary: "the DCF does not describe the objects of a connected module",
    checks: "Whether a DCF describes the fixed and extended objects of the modules in `[ConnectedModules]`: each sub-index of a fixed object, and at least as many elements of an extended object as the modules add to it; modules that share an element fill it with their bits.",
    why: "The DCF describes the complete station including its modules. Objects of modules that are not described are not configured.",
    example: "`1=2` in `[ConnectedModules]` and `1=0x6423` in `[M2FixedObjects]` without `[6423]`",
    remedy: "Describe the objects as defined by the modules.",
    source: "CiA 306-1 §6.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = device.modules.as_ref().filter(|_| device.kind == DeviceKind::Node) else { return };
    check_sub_indexes(device, modules, findings);
    let mut seen = BTreeSet::new();
    for (at, &number) in modules.connected.iter().flatten().enumerate() {
        let Some(module) = modules.supported.get(&number).filter(|_| seen.insert(number)) else { continue };
        let brings = module.fixed.keys().chain(module.extensions.keys());
        let mut missing = brings.filter(|&&index| !stated::is_there(device, index));
        let Some(first) = missing.next() else { continue };
        let more = match missing.count() {
            0 => Text::default(),
            others => say!(" and {} more", others),
        };
        let item = u32::try_from(at + 1).unwrap_or(u32::MAX);
        let message = say!("module {} defines {:04X}h{}, missing in the {DCF}", number, first, more);
        let place = Place::of(Part::ConnectedModules).field(Field::Item(item));
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("describe the objects as defined by the modules"));
    }
}

/// Reports described objects that lack sub-indexes of the connected modules, each once.
fn check_sub_indexes(device: &Device, modules: &Modules, findings: &mut Findings) {
    let connected = modules.connected.iter().flatten().filter_map(|number| modules.supported.get(number));
    let mut added: BTreeMap<u16, usize> = BTreeMap::new();
    let mut shared: BTreeMap<(u16, u32), u32> = BTreeMap::new();
    let mut fixed: BTreeMap<u16, &Object> = BTreeMap::new();
    for module in connected {
        for (&index, extension) in &module.extensions {
            let length = extension.entry.data_type.and_then(DataType::bit_length).map(u32::from);
            match (extension.count, length) {
                // extensions that continue in the next object add no fixed number
                _ if extension.obj_extend.unwrap_or(0) > 0 => {}
                (Some(ExtensionCount::Subs(count)), _) => {
                    *added.entry(index).or_default() += usize::from(count);
                }
                (Some(ExtensionCount::SharedBits(bits)), Some(length @ 1..)) => {
                    *shared.entry((index, length)).or_default() += u32::from(bits);
                }
                _ => {}
            }
        }
        fixed.extend(module.fixed.iter().map(|(&index, object)| (index, &**object)));
    }
    for ((index, length), bits) in shared {
        *added.entry(index).or_default() += bits.div_ceil(length) as usize;
    }
    for (index, object) in fixed {
        let Some(described) = described(device, index) else { continue };
        let lacks = |sub: &u8| described.entry(*sub).is_none();
        if let Some(sub) = object.subs.iter().map(|(sub, _)| sub).find(lacks) {
            let message = say!(
                "a connected module defines sub-index {} of {:04X}h, missing in the {DCF}",
                sub_index(sub),
                index
            );
            findings.push(report(index, message));
        }
    }
    for (index, added) in added {
        let Some(described) = described(device, index) else { continue };
        let elements = described.entries().filter(|(sub, _)| (1..0xFF).contains(sub)).count();
        if elements < added {
            let message = say!(
                "the connected modules add {} to {:04X}h, but the object has {}",
                counted(added, "element", "elements"),
                index,
                elements
            );
            findings.push(report(index, message));
        }
    }
}

fn described(device: &Device, index: u16) -> Option<&Object> {
    device.object(index).filter(|object| !object.orphan && object.object_type().has_subs())
}

fn report(index: u16, message: Text) -> Diagnostic {
    Diagnostic::new(&RULE.info, Place::object(index), message)
        .help("describe the sub-indexes as defined by the modules")
}
