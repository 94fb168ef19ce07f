//! The modules that a modular device supports.

use std::collections::{BTreeMap, HashMap};

use crate::IndexSet;
use crate::diagnostic::{Findings, Fix, listing, listing_or, say};
use crate::model::{
    DataType, Device, DeviceKind, Entry, ExtensionCount, Field, Module, ModulePart, Object, ObjectType, Part,
    Place,
};
use crate::rule::rules;

rules! {
    source: "CiA 306-1 §6.3";

    "cia306/invalid-extension-limit" = INVALID_EXTENSION_LIMIT, Error, Device(invalid_extension_limit);
    summary: "a module extends an object beyond its highest sub-index",
    checks: "`ObjExtend` of each extension must be at most 254, the highest sub-index of an element, and not below the number of sub-indexes in `Count`.",
    why: "`ObjExtend` is the sub-index after which the next object starts. With an invalid value, sub-indexes of the modules overlap or do not fit.",
    example: "`ObjExtend=4` and `Count=8` in `[M1SubExt6000]`",
    remedy: "Write 254, or 128 for CiA 401 objects with one bit per entry.",

    "cia306/missing-module-info" = MISSING_MODULE_INFO, Error, Device(missing_module_info);
    summary: "a module lacks its product information",
    checks: "Each module must have `[MxModuleInfo]` with `ProductName`, `ProductVersion`, `ProductRevision` and `OrderCode`.",
    why: "Configuration tools show these values to users who assemble modules.",
    example: "`[M1FixedObjects]` without `[M1ModuleInfo]`",
    remedy: "Add the section or the missing keys.",

    "cia306/missing-obj-extend" = MISSING_OBJ_EXTEND, Warning, Device(missing_obj_extend), fix Unsafe;
    summary: "modules add bits to an object that cannot continue in the next one",
    checks: "Extensions of the CiA 401 objects with one bit per sub-index (6020h to 603Fh, 6220h to 6267h) must have `ObjExtend`.",
    why: "Each of these objects has 128 bits, and the next 128 bits are at the next index. Without `ObjExtend` all bits go to the first object, up to sub-index 254.",
    example: "`[M1SubExt6020]` with `Count=8` and without `ObjExtend`",
    remedy: "Write `ObjExtend=128`.",
    source: "CiA 306-1 §6.3, CiA 401-1 §7.3",

    "cia306/module-conflict" = MODULE_CONFLICT, Error, Device(module_conflict);
    summary: "two modules describe the same object differently",
    checks: "A fixed object or extension of several modules must be identical in all of them: object type, data type, access, mapping, default, limits and flags, including sub-indexes. Names and `Count` may differ. An extension of an ARRAY of the coupler must also have the data type of its elements. Defaults of extensions of 1027h (module list) may differ too: they are the module numbers.",
    why: "The assembled device has the object only once, so only one description can be correct.",
    example: "`[M1SubExt6000]` with UNSIGNED8 and `[M2SubExt6000]` with UNSIGNED16",
    remedy: "Use the same description in all modules.",

    "cia306/module-list-mismatch" = MODULE_LIST_MISMATCH, Error, Device(module_list_mismatch), fix Mixed;
    summary: "the lists of a module do not match its objects",
    checks: "Each index of `[MxFixedObjects]` and `[MxSubExtends]` must be described in `[MxFixedxxxx]` or `[MxSubExtxxxx]`, and each described index must be listed. Each sub-index of a fixed object must have its object.",
    why: "Tools that assemble modules use the lists and ignore objects that are not listed.",
    example: "`1=0x6423` in `[M1FixedObjects]`, and no `[M1Fixed6423]`",
    remedy: "Describe the object, or correct the list and its `NrOfEntries`.",

    "cia306/module-overlap" = MODULE_OVERLAP, Error, Device(module_overlap);
    summary: "an object is defined by a module and elsewhere",
    checks: "In an EDS, a fixed object of a module must not be a device object too. No index may be both a fixed object and an extension. A DCF contains the objects of the connected modules in addition to the modules.",
    why: "The object of the coupler and the object of the module share an index.",
    example: "`[6423]` and `[M1Fixed6423]`",
    remedy: "Keep only one definition.",

    "cia306/module-without-objects" = MODULE_WITHOUT_OBJECTS, Warning, Device(module_without_objects);
    summary: "a module adds no objects",
    checks: "Each supported module must have its own objects (`[MxFixedObjects]`) or extend the device's objects (`[MxSubExtends]`).",
    why: "A configuration tool offers the module, but nothing changes when it is plugged in. Most likely its sections were forgotten or are misspelt.",
    example: "`[M2ModuleInfo]` without `[M2FixedObjects]` and `[M2SubExtends]`",
    remedy: "Describe the objects of the module, or remove the module if it has none, such as a power supply.",
}

fn invalid_extension_limit(device: &Device, findings: &mut Findings) {
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        for (&index, extension) in &module.extensions {
            let Some(limit) = extension.obj_extend.filter(|&limit| limit > 0) else { continue };
            let count = match extension.count {
                Some(ExtensionCount::Subs(count)) => count,
                _ => 0,
            };
            let place = |field| Place::of(Part::Module(number, ModulePart::SubExt(index))).field(field);
            let finding = if limit == 255 {
                let message = "`255` is above 254, the highest sub-index of an element";
                INVALID_EXTENSION_LIMIT.at(place(Field::ObjExtend), message)
            } else if count > limit {
                let message = say!(
                    "module {} adds {} sub-indexes per instance to {:04X}h, but `{ObjExtend}` is {}",
                    number,
                    count,
                    index,
                    limit
                );
                INVALID_EXTENSION_LIMIT
                    .at(place(Field::ObjExtend), message)
                    .label(place(Field::Count), "number of added sub-indexes")
            } else {
                continue;
            };
            findings.push(finding.help("write 254, or 128 for objects with one bit per entry"));
        }
    }
}

fn missing_module_info(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    for (&number, module) in &modules.supported {
        let missing = missing_info_keys(module);
        let Some(first) = missing.first() else { continue };
        let message = if missing.len() == 4 {
            say!(
                "module {} has no `{}`, or the {section} is empty",
                number,
                Part::Module(number, ModulePart::Info)
            )
        } else {
            say!("`{}` has no {}", Part::Module(number, ModulePart::Info), listing_or(&missing))
        };
        let info = Place::of(Part::Module(number, ModulePart::Info)).field(first.clone());
        let place = if missing.len() == 4 { first_section(number, module) } else { info };
        findings.push(MISSING_MODULE_INFO.at(place, message).help(say!("add {}", listing(&missing))));
    }
}

fn missing_info_keys(module: &Module) -> Vec<Field> {
    let stated = [
        (Field::ProductName, module.product_name.is_some()),
        (Field::ProductVersion, module.product_version.is_some()),
        (Field::ProductRevision, module.product_revision.is_some()),
        (Field::OrderCode, module.order_code.is_some()),
    ];
    let is_missing = |(field, stated): &(Field, bool)| !stated && module.invalid_values.get(field).is_none();
    stated.into_iter().filter(is_missing).map(|(field, _)| field).collect()
}

/// Any section of a module without information.
fn first_section(number: u16, module: &Module) -> Place {
    let part = if let Some(&index) = module.fixed.keys().next() {
        ModulePart::Fixed(index)
    } else if let Some(&index) = module.extensions.keys().next() {
        ModulePart::SubExt(index)
    } else if !module.fixed_list.is_empty() {
        ModulePart::FixedObjects
    } else if !module.extension_list.is_empty() {
        ModulePart::SubExtends
    } else if !module.comments.is_empty() {
        ModulePart::Comments
    } else {
        ModulePart::Info
    };
    Place::of(Part::Module(number, part))
}

fn missing_obj_extend(device: &Device, findings: &mut Findings) {
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        for (&index, extension) in &module.extensions {
            let is_bit = extension.entry.data_type == Some(DataType::BOOLEAN)
                && matches!(index, 0x6020..=0x603F | 0x6220..=0x6267);
            let is_stated = extension.obj_extend.is_some_and(|limit| limit > 0)
                || extension.entry.invalid_values.get(&Field::ObjExtend).is_some();
            if !is_bit || is_stated {
                continue;
            }
            let place = Place::of(Part::Module(number, ModulePart::SubExt(index))).field(Field::ObjExtend);
            let message = say!("module {} adds bits to {:04X}h without `{ObjExtend}`", number, index);
            let title = say!("write `{ObjExtend=128}`");
            let finding = MISSING_OBJ_EXTEND.at(place.clone(), message).help(title.clone());
            findings.push(finding.fix(Fix::risky(title).set(place, "128")));
        }
    }
}

/// 1027h: each element is a module number.
const MODULE_LIST: u16 = 0x1027;

fn module_conflict(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    let mut fixed: HashMap<u16, (u16, &Object)> = HashMap::new();
    let mut extensions: HashMap<u16, (u16, &Entry)> = HashMap::new();
    for (&number, module) in &modules.supported {
        for (&index, object) in &module.fixed {
            let (first, other) = *fixed.entry(index).or_insert((number, object));
            let (field, place) = (different_object(other, object), ModulePart::Fixed(index));
            report_conflict(index, (first, number), place, &field, findings);
        }
        for (&index, extension) in &module.extensions {
            let (first, other) = *extensions.entry(index).or_insert((number, &extension.entry));
            let mut fields = different_entry(other, &extension.entry);
            let coupler = element_type(device, index);
            fields.retain(|field| match field {
                Field::DefaultValue => index != MODULE_LIST,
                Field::DataType => coupler.is_none(),
                _ => true,
            });
            if let (Some(right), Some(found)) = (coupler, extension.entry.data_type)
                && right != found
            {
                let message =
                    say!("module {} adds {} to {:04X}h, whose elements are {}", number, found, index, right);
                let place = Place::of(Part::Module(number, ModulePart::SubExt(index))).field(Field::DataType);
                let finding = MODULE_CONFLICT.at(place, message).label(Place::object(index), "the coupler's");
                findings.push(finding.help("use the data type of the coupler, or extend a different object"));
            }
            report_conflict(index, (first, number), ModulePart::SubExt(index), &fields, findings);
        }
    }
}

/// The data type of the elements of an ARRAY of the coupler.
fn element_type(device: &Device, index: u16) -> Option<DataType> {
    let object = device.object(index).filter(|object| object.object_type() == ObjectType::Array)?;
    object.entries().find(|&(sub, _)| sub > 0)?.1.data_type
}

fn different_object(first: &Object, second: &Object) -> Vec<Field> {
    let mut fields = different_entry(&first.main, &second.main);
    let subs = |object: &Object| object.subs.iter().map(|(sub, _)| sub).collect::<Vec<u8>>();
    if subs(first) != subs(second) {
        fields.push(Field::SubNumber);
    }
    for ((_, first), (_, second)) in first.subs.iter().zip(second.subs.iter()) {
        fields.extend(different_entry(first, second));
    }
    fields.sort_unstable();
    fields.dedup();
    fields
}

fn different_entry(first: &Entry, second: &Entry) -> Vec<Field> {
    let same = [
        (Field::ObjectType, first.object_type == second.object_type),
        (Field::DataType, first.data_type == second.data_type),
        (Field::AccessType, first.access == second.access),
        (Field::PdoMapping, first.is_mappable() == second.is_mappable()),
        (Field::DefaultValue, first.default == second.default),
        (Field::LowLimit, first.low_limit == second.low_limit),
        (Field::HighLimit, first.high_limit == second.high_limit),
        (Field::ObjFlags, first.flags() == second.flags()),
    ];
    same.into_iter().filter(|(_, same)| !same).map(|(field, _)| field).collect()
}

fn report_conflict(
    index: u16,
    (first, second): (u16, u16),
    part: ModulePart,
    fields: &[Field],
    findings: &mut Findings,
) {
    if fields.is_empty() {
        return;
    }
    let place = |number| Place::of(Part::Module(number, part));
    let message = say!("{:04X}h of modules {} and {} differs in {}", index, first, second, listing(fields));
    let finding = MODULE_CONFLICT.at(place(second), message).label(place(first), "the other description");
    findings.push(finding.help("use the same description in all modules"));
}

fn module_list_mismatch(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    for (&number, module) in &modules.supported {
        check_fixed_list(number, module, findings);
        check_extension_list(number, module, findings);
    }
}

fn check_fixed_list(number: u16, module: &Module, findings: &mut Findings) {
    let list = Part::Module(number, ModulePart::FixedObjects);
    let listed: IndexSet = module.fixed_list.iter().copied().collect();
    for (item, index) in (1..).zip(&module.fixed_list) {
        if !module.fixed.contains_key(index) {
            listed_only(&list, (item, *index), &Part::Module(number, ModulePart::Fixed(*index)), findings);
        }
    }
    for (&index, object) in &module.fixed {
        let section = Part::Module(number, ModulePart::Fixed(index));
        if let Some((sub, _)) = object.subs.iter().next().filter(|_| object.orphan) {
            let place = Place::of(Part::Module(number, ModulePart::FixedEntry(index, sub)));
            let message = say!(
                "sub-indexes of the fixed object {:04X}h are described, but the object is missing",
                index
            );
            let finding = MODULE_LIST_MISMATCH.at(place, message);
            findings.push(
                finding.help(say!("add {a section} `{}`", Part::Module(number, ModulePart::Fixed(index)))),
            );
        } else if !listed.contains(index) {
            described_only(section, index, (&list, module.fixed_list.len()), findings);
        }
    }
}

fn check_extension_list(number: u16, module: &Module, findings: &mut Findings) {
    let list = Part::Module(number, ModulePart::SubExtends);
    let listed: IndexSet = module.extension_list.iter().copied().collect();
    for (item, index) in (1..).zip(&module.extension_list) {
        if !module.extensions.contains_key(index) {
            listed_only(&list, (item, *index), &Part::Module(number, ModulePart::SubExt(*index)), findings);
        }
    }
    for &index in module.extensions.keys().filter(|&&index| !listed.contains(index)) {
        let section = Part::Module(number, ModulePart::SubExt(index));
        described_only(section, index, (&list, module.extension_list.len()), findings);
    }
}

fn listed_only(list: &Part, (item, index): (u32, u16), section: &Part, findings: &mut Findings) {
    let place = Place::of(list.clone()).field(Field::Item(item));
    let fix = Fix::risky("remove the list entry").remove(place.clone());
    let message = say!("{:04X}h is listed, but {section} `{}` is missing", index, section);
    let finding = MODULE_LIST_MISMATCH.at(place, message).fix(fix);
    findings.push(finding.help("describe the object, or remove its list entry"));
}

fn described_only(section: Part, index: u16, (list, length): (&Part, usize), findings: &mut Findings) {
    let next = u32::try_from(length + 1).unwrap_or(u32::MAX);
    let place = Place::of(list.clone()).field(Field::Item(next));
    let title = say!("add `0x{:04X}` to `{}`", index, list);
    let fix = Fix::safe(title.clone()).set(place, format!("0x{index:04X}"));
    let message = say!("{:04X}h is described, but not listed in `{}`", index, list);
    findings.push(MODULE_LIST_MISMATCH.at(Place::of(section), message).help(title).fix(fix));
}

fn module_overlap(device: &Device, findings: &mut Findings) {
    let Some(modules) = &device.modules else { return };
    let mut extended: BTreeMap<u16, u16> = BTreeMap::new();
    for (&number, module) in &modules.supported {
        for &index in module.extensions.keys() {
            extended.entry(index).or_insert(number);
        }
    }
    let mut seen = IndexSet::new();
    for (&number, module) in &modules.supported {
        // objects of several modules are reported at the first one
        for &index in module.fixed.keys().filter(|&&index| seen.insert(index)) {
            let place = Place::of(Part::Module(number, ModulePart::Fixed(index)));
            let fixed = say!("{:04X}h is a fixed object of module {}", index, number);
            if device.kind == DeviceKind::Type && device.objects.contains_key(&index) {
                let finding = MODULE_OVERLAP
                    .at(place, say!("{} and also an object of the device", fixed))
                    .label(Place::object(index), "the device's");
                findings.push(finding.help("keep only one definition"));
            } else if let Some(&other) = extended.get(&index) {
                let extension = Place::of(Part::Module(other, ModulePart::SubExt(index)));
                let finding = MODULE_OVERLAP
                    .at(place, say!("{} and is extended by module {}", fixed, other))
                    .label(extension, "the extension");
                findings.push(finding.help("describe the object either as fixed or as extension"));
            }
        }
    }
}

fn module_without_objects(device: &Device, findings: &mut Findings) {
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        if adds_something(module) {
            continue;
        }
        let part = |part| Part::Module(number, part);
        let message = say!(
            "module {} has neither `{}` nor `{}`",
            number,
            part(ModulePart::FixedObjects),
            part(ModulePart::SubExtends)
        );
        let finding = MODULE_WITHOUT_OBJECTS.at(Place::of(part(ModulePart::Info)), message);
        findings.push(finding.help("describe the objects of the module"));
    }
}

fn adds_something(module: &Module) -> bool {
    !(module.fixed_list.is_empty()
        && module.fixed.is_empty()
        && module.extension_list.is_empty()
        && module.extensions.is_empty())
}
