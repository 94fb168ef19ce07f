//! The modules that are connected to a modular device; dynamic channels and their network variables.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{
    Argument, Diagnostic, Findings, Fix, Severity, Text, counted, listing_or, say, series, sub_index,
};
use crate::model::{
    DataType, Device, DeviceKind, DynamicChannels, ExtensionCount, Field, ModulePart, Modules, Object, Part,
    Place, Segment,
};
use crate::rule::rules;
use crate::stated;

rules! {
    source: "CiA 306-1 §6.4";

    "cia306/described-network-variable" = DESCRIBED_NETWORK_VARIABLE, Error,
        Device(described_network_variable);
    summary: "network variables of dynamic channels are described as objects",
    checks: "The EDS of a device with dynamic channels must not describe objects A000h to AFFFh.",
    why: "The application program of such a device defines these objects. The EDS describes only their segments. Objects described in addition conflict with the program.",
    example: "`DynamicChannelsSupported=1` and `[A040]`",
    remedy: "Remove the objects, or write `DynamicChannelsSupported=0` if they never change.",
    source: "CiA 306-1 §4.6.3.4.3",

    "cia306/dynamic-channels-flag" = DYNAMIC_CHANNELS_FLAG, Error, Device(dynamic_channels_flag), fix Unsafe;
    summary: "`DynamicChannelsSupported` and `[DynamicChannels]` disagree",
    checks: "A device with dynamic channels must describe their segments. A device with described segments must set `DynamicChannelsSupported`.",
    why: "A programming tool places network variables in the segments. Without segments it cannot place them, and without the flag it does not look for segments.",
    example: "`DynamicChannelsSupported=1` without `[DynamicChannels]`",
    remedy: "Add the section with `NrOfSeg` and the segments, or write 0.",
    source: "CiA 306-1 §4.5, CiA 302-4",

    "cia306/invalid-segment" = INVALID_SEGMENT, Error, Device(invalid_segment);
    summary: "a segment of the dynamic channels is not valid",
    checks: "Each segment must have type, direction and range. The range must be within A000h to BFFFh in ascending order, and ranges must not overlap.",
    why: "A programming tool chooses the indexes of network variables from these ranges.",
    example: "`Range1=0xA0BF-0xA080`",
    remedy: "Write the first and last index: `Range1=0xA080-0xA0BF`.",
    source: "CiA 302-4, CiA 306-1 §4.6.3.4.3",

    "cia306/missing-module-object" = MISSING_MODULE_OBJECT, Warning, Device(missing_module_object);
    summary: "the DCF does not describe the objects of a connected module",
    checks: "A DCF must describe the fixed and extended objects of the modules in `[ConnectedModules]`. It needs each sub-index of a fixed object and at least as many elements of an extended object as the modules add to it. Modules that share an element fill it with their bits.",
    why: "The DCF describes the complete station including its modules. Objects of modules that are not described are not configured.",
    example: "`1=2` in `[ConnectedModules]` and `1=0x6423` in `[M2FixedObjects]` without `[6423]`",
    remedy: "Describe the objects as defined by the modules.",

    "cia306/module-numbering" = MODULE_NUMBERING, Error, Device(module_numbering), fix Safe;
    summary: "the modules are not numbered consecutively from 1",
    checks: "The module sections (`[MxModuleInfo]` and others) must have the numbers 1 to `NrOfEntries` of `[SupportedModules]`.",
    why: "Tools count from 1. They ignore modules above the count and stop at a gap.",
    example: "`NrOfEntries=2`, `[M1ModuleInfo]` and `[M3ModuleInfo]`",
    remedy: "Renumber the modules in all their sections and in `[ConnectedModules]`.",
    source: "CiA 306-1 §6.3",

    "cia306/unknown-connected-module" = UNKNOWN_CONNECTED_MODULE, Error,
        Device(unknown_connected_module), fix Unsafe;
    summary: "a connected module is not described or does not match the module list",
    checks: "Each number in `[ConnectedModules]` must be the number of a described module. In a DCF, it must also equal the value of 1027h (module list) at its position if that value is not 0. A deviation from 1027h is a warning.",
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
        let message = say!("module {} defines {:04X}h{}, missing from the {DCF}", number, first, more);
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
                "a connected module defines sub-index {} of {:04X}h, which is missing from the {DCF}",
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
            findings.push(finding.help("write the connected module in both places"));
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

fn described_network_variable(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    if device.kind == DeviceKind::Node || info.dynamic_channels_supported.is_none_or(|number| number == 0) {
        return;
    }
    let mut variables = device.objects.range(0xA000..=0xAFFF);
    let Some((&first, _)) = variables.next() else { return };
    let objects = counted(1 + variables.count(), "object is", "objects are");
    let message = say!("the device has dynamic channels, but {} described in A000h to AFFFh", objects);
    let finding = DESCRIBED_NETWORK_VARIABLE
        .at(Place::object(first), message)
        .label(Place::of(Part::DeviceInfo).field(Field::DynamicChannelsSupported), "dynamic channels");
    findings.push(finding.help(say!("remove the objects, or write `{DynamicChannelsSupported=0}`")));
}

fn dynamic_channels_flag(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let supported = info.dynamic_channels_supported;
    let flag = Place::of(Part::DeviceInfo).field(Field::DynamicChannelsSupported);
    match (supported, &device.dynamic_channels) {
        (Some(number), None) if number > 0 => {
            let message =
                say!("`{DynamicChannelsSupported}` is {}, but `{[DynamicChannels]}` is missing", number);
            let fix = Fix::risky(say!("write `{DynamicChannelsSupported=0}`")).set(flag.clone(), "0");
            let finding = DYNAMIC_CHANNELS_FLAG.at(flag, message).fix(fix);
            findings.push(finding.help(say!("describe the segments in `{[DynamicChannels]}`, or write 0")));
        }
        (Some(0), Some(channels)) if !channels.segments.iter().all(Segment::is_empty) => {
            let message = say!("`{[DynamicChannels]}` has segments, but `{DynamicChannelsSupported}` is 0");
            let fix = Fix::risky(say!("write `{DynamicChannelsSupported=1}`")).set(flag.clone(), "1");
            let finding = DYNAMIC_CHANNELS_FLAG
                .at(flag, message)
                .fix(fix)
                .label(Place::of(Part::DynamicChannels), "segments");
            findings
                .push(finding.help(say!("write `{DynamicChannelsSupported=1}`, or remove the {section}")));
        }
        _ => {}
    }
}

fn invalid_segment(device: &Device, findings: &mut Findings) {
    let Some(channels) = &device.dynamic_channels else { return };
    let info = device.device_info.as_ref();
    let is_unused = info.is_none_or(|info| info.dynamic_channels_supported.unwrap_or_default() == 0);
    for (number, segment) in (1..).zip(&channels.segments) {
        // some tools write empty keys
        let severity = if is_unused && segment.is_empty() { Severity::Note } else { Severity::Error };
        check_segment_keys(channels, number, segment, severity, findings);
        if let Some(range) = segment.range {
            check_segment_range(channels, number, range, findings);
        }
    }
}

fn segment_field(word: &str, number: usize) -> Field {
    Field::Named(format!("{word}{number}").into())
}

fn segment_place(word: &str, number: usize) -> Place {
    Place::of(Part::DynamicChannels).field(segment_field(word, number))
}

fn check_segment_keys(
    channels: &DynamicChannels,
    number: usize,
    segment: &Segment,
    severity: Severity,
    findings: &mut Findings,
) {
    let direction = segment.direction.as_deref().is_some_and(|direction| !direction.is_empty());
    let stated =
        [("Type", segment.data_type.is_some()), ("Dir", direction), ("Range", segment.range.is_some())];
    let missing: Vec<Field> = stated
        .into_iter()
        .filter(|(_, stated)| !stated)
        .map(|(word, _)| segment_field(word, number))
        .filter(|field| channels.invalid_values.get(field).is_none())
        .collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("segment {} of the dynamic channels has no {}", number, listing_or(&missing));
    let finding = INVALID_SEGMENT.at(Place::of(Part::DynamicChannels), message).severity(severity);
    findings.push(finding.help("write `TypeN`, `DirN`, `RangeN` and `PPOffsetN` for each segment"));
}

fn check_segment_range(
    channels: &DynamicChannels,
    number: usize,
    (low, high): (u16, u16),
    findings: &mut Findings,
) {
    let at = segment_place("Range", number);
    let range = say!("{:04X}h to {:04X}h", low, high);
    if low > high {
        let finding = INVALID_SEGMENT.at(at, say!("the range {} is in descending order", range));
        findings.push(finding.help("write the smaller index first"));
    } else if low < 0xA000 || high > 0xBFFF {
        let message = say!("the range {} is not within A000h to BFFFh, the area of network variables", range);
        findings.push(INVALID_SEGMENT.at(at, message).help("write a range from 0xA000 to 0xBFFF"));
    } else {
        let before = (1..number).zip(&channels.segments);
        let overlaps = |range: (u16, u16)| range.0 <= high && low <= range.1;
        let other = before.into_iter().find(|(_, segment)| segment.range.is_some_and(overlaps));
        if let Some((other, _)) = other {
            let message = say!("the ranges of segments {} and {} overlap", other, number);
            let finding =
                INVALID_SEGMENT.at(at, message).label(segment_place("Range", other), "the other range");
            findings.push(finding.help("write separate ranges for the segments"));
        }
    }
}
