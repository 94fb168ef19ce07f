//! The modules that are connected to a modular device.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{
    Argument, Diagnostic, Findings, Fix, Severity, Text, counted, say, series, sub_index,
};
use crate::model::{
    DataType, Device, DeviceKind, ExtensionCount, Field, ModulePart, Modules, Object, Part, Place,
};
use crate::rule::rules;
use crate::stated;

rules! {
    source: "CiA 306-1 §6.4";

    "cia306/missing-module-object" = MISSING_MODULE_OBJECT, Warning, Device(missing_module_object);
    summary: "the DCF does not describe the objects of a connected module",
    checks: "Whether a DCF describes the fixed and extended objects of the modules in `[ConnectedModules]`: each sub-index of a fixed object, and at least as many elements of an extended object as the modules add to it; modules that share an element fill it with their bits.",
    why: "The DCF describes the complete station including its modules. Objects of modules that are not described are not configured.",
    example: "`1=2` in `[ConnectedModules]` and `1=0x6423` in `[M2FixedObjects]` without `[6423]`",
    remedy: "Describe the objects as defined by the modules.",

    "cia306/module-numbering" = MODULE_NUMBERING, Error, Device(module_numbering), fix Safe;
    summary: "the modules are not numbered consecutively from 1",
    checks: "Whether the sections of the modules (`[MxModuleInfo]` and others) have the numbers 1 to `NrOfEntries` of `[SupportedModules]`.",
    why: "Tools count from 1. They ignore modules above the count and stop at a gap.",
    example: "`NrOfEntries=2`, `[M1ModuleInfo]` and `[M3ModuleInfo]`",
    remedy: "Renumber the modules in all their sections and in `[ConnectedModules]`.",
    source: "CiA 306-1 §6.3",

    "cia306/unknown-connected-module" = UNKNOWN_CONNECTED_MODULE, Error,
        Device(unknown_connected_module), fix Unsafe;
    summary: "a connected module is not described, or not the one of the module list",
    checks: "Whether each number in `[ConnectedModules]` is the number of a described module, and in a DCF the value of 1027h (module list) at its position, if that is not 0. The second is a warning.",
    why: "The objects of such a module are unknown.",
    example: "`2=7` in `[ConnectedModules]` of a coupler with five modules",
    remedy: "Write the number of a described module, or copy the module description from the EDS.",
}

fn missing_module_object(device: &Device, findings: &mut Findings) {
    let Some(modules) = device.modules.as_ref().filter(|_| device.kind == DeviceKind::Node) else { return };
    check_sub_indexes_of_modules(device, modules, findings);
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
        let finding = MISSING_MODULE_OBJECT.at(place, message);
        findings.push(finding.help("describe the objects as defined by the modules"));
    }
}

/// Reports described objects that lack sub-indexes of the connected modules, each once.
fn check_sub_indexes_of_modules(device: &Device, modules: &Modules, findings: &mut Findings) {
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
        let Some(described) = described_structure(device, index) else { continue };
        let lacks = |sub: &u8| described.entry(*sub).is_none();
        if let Some(sub) = object.subs.iter().map(|(sub, _)| sub).find(lacks) {
            let message = say!(
                "a connected module defines sub-index {} of {:04X}h, missing in the {DCF}",
                sub_index(sub),
                index
            );
            findings.push(incomplete_object(index, message));
        }
    }
    for (index, added) in added {
        let Some(described) = described_structure(device, index) else { continue };
        let elements = described.entries().filter(|(sub, _)| (1..0xFF).contains(sub)).count();
        if elements < added {
            let message = say!(
                "the connected modules add {} to {:04X}h, but the object has {}",
                counted(added, "element", "elements"),
                index,
                elements
            );
            findings.push(incomplete_object(index, message));
        }
    }
}

fn described_structure(device: &Device, index: u16) -> Option<&Object> {
    device.object(index).filter(|object| !object.orphan && object.object_type().has_subs())
}

fn incomplete_object(index: u16, message: Text) -> Diagnostic {
    MISSING_MODULE_OBJECT
        .at(Place::object(index), message)
        .help("describe the sub-indexes as defined by the modules")
}

fn module_numbering(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    if modules.invalid_values.get(&Field::NrOfEntries).is_some() {
        return;
    }
    let described = modules.supported.len();
    let numbered = modules.supported.keys().zip(1..).all(|(&number, expected)| number == expected);
    let count = Place::of(Part::SupportedModules).field(Field::NrOfEntries);
    match modules.declared {
        None if described == 0 => {}
        None => {
            let message =
                say!("{} modules are described, but `{[SupportedModules]}` has no count", described);
            let fix = Fix::safe(say!("write `{}`", Argument::setting(Field::NrOfEntries, described)))
                .set(count, described.to_string());
            let finding = MODULE_NUMBERING.at(first_module(modules), message).fix(fix);
            findings.push(finding.help(say!(
                "write `{}` in `{[SupportedModules]}`",
                Argument::setting(Field::NrOfEntries, described)
            )));
        }
        Some(declared) if usize::from(declared) != described => {
            let message = say!("`{NrOfEntries}` is {}, but {} described", declared, modules_are(described));
            let fix = Fix::safe(say!("write `{}`", Argument::setting(Field::NrOfEntries, described)));
            let fix = fix.set(count.clone(), described.to_string());
            let finding = MODULE_NUMBERING.at(count, message).fix(fix);
            findings.push(finding.help(say!(
                "write `{}`, or describe the others",
                Argument::setting(Field::NrOfEntries, described)
            )));
        }
        Some(_) if numbered => {}
        Some(declared) => {
            let numbers = series(modules.supported.keys());
            let message = say!("{} modules have the numbers {}, not 1 to {}", declared, numbers, declared);
            findings.push(MODULE_NUMBERING.at(count, message).help("renumber the modules"));
        }
    }
}

fn modules_are(number: usize) -> Text {
    match number {
        0 => "no module is".into(),
        1 => "1 module is".into(),
        _ => say!("{} modules are", number),
    }
}

fn first_module(modules: &Modules) -> Place {
    let first = modules.supported.keys().next();
    first.map_or(Place::of(Part::SupportedModules), |&number| {
        Place::of(Part::Module(number, ModulePart::Info))
    })
}

fn unknown_connected_module(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    let is_node = device.kind == DeviceKind::Node;
    for (item, number) in (1..).zip(modules.connected.iter().flatten()) {
        let sub = u8::try_from(item).ok().filter(|_| is_node);
        let listed = sub.and_then(|sub| Some((sub, device.value(0x1027, sub)?.as_integer()?)));
        if let Some((sub, other)) = listed.filter(|&(_, other)| other != 0 && other != i128::from(*number)) {
            let place = Place::of(Part::ConnectedModules).field(Field::Item(item));
            let message = say!("module {} is connected, but 1027h:{} is {}", number, sub_index(sub), other);
            let finding = UNKNOWN_CONNECTED_MODULE.at(place, message).severity(Severity::Warning);
            let finding = finding.label(device.value_place(0x1027, sub), "the module list");
            findings.push(finding.help("write the module that is connected in both places"));
        }
        if !modules.supported.contains_key(number) {
            let place = Place::of(Part::ConnectedModules).field(Field::Item(item));
            let message = say!("module {} is connected, but not described", number);
            let fix = Fix::risky("remove the list entry").remove(place.clone());
            let finding = UNKNOWN_CONNECTED_MODULE.at(place, message).fix(fix);
            findings.push(finding.help(say!(
                "add the {sections} of the module (`{}` and others), or correct the number",
                Part::Module(*number, ModulePart::Info)
            )));
        }
    }
}
