//! The device type, the identity object and the objects that a device must or should not have.

use std::ops::RangeInclusive;

use crate::demands::Applied;
use crate::diagnostic::{Argument, Findings, Severity, Text, say};
use crate::model::{Access, Device, DeviceKind, Identity, Object, ObjectList, Part, Place};
use crate::profile::Need;
use crate::rule::rules;
use crate::{Facts, is_unstated, profile, stated};

rules! {
    "cia301/device-type-without-value" = DEVICE_TYPE_WITHOUT_VALUE, Warning,
        Device(device_type_without_value);
    summary: "the device type has no value",
    checks: "1000h must have a value.",
    why: "The low word of 1000h is the number of the device profile. Without it a tool does not know the meaning of the objects from 6000h on, and no profile rule applies.",
    example: "`[1000]` without `DefaultValue`",
    remedy: "Write the value that the device returns, or 0 if it follows no device profile.",
    source: "CiA 301 §7.5.2.1",

    "cia301/invalid-device-type" = INVALID_DEVICE_TYPE, Error, Facts(invalid_device_type);
    summary: "the device type is contradictory",
    checks: "If the low word of 1000h, the profile number, is 0 (no profile), the high word must be 0 too. For `0x00010000`, which tools write for a generic device, the finding is a warning. Two other warnings are a profile number in hexadecimal digits instead of decimal (0402h, which is 1026) and swapped words. A note is a device with the controlword, statusword and mode of a drive (6040h, 6041h, 6060h) and profile number 0.",
    why: "The high word has a meaning only within a profile. A master that compares the device type or derives the profile from it reaches the wrong conclusion.",
    example: "`[1000]` with `DefaultValue=0x00030000`",
    remedy: "Write the profile number to the low word, such as `0x00030191` for CiA 401, or write 0.",
    source: "CiA 301 §7.5.2.1",

    "cia301/missing-mandatory-object" = MISSING_MANDATORY_OBJECT, Error, Applied(missing_mandatory_object);
    summary: "a mandatory object is missing",
    checks: "1000h (device type), 1001h (error register) and 1018h (identity) must be described. Objects that are listed but not described, or are in the wrong list, have their own rules.",
    why: "A manager reads 1000h and 1018h when a node boots and rejects a node that responds with an abort. Tools identify devices by 1018h.",
    example: "no section `[1018]`",
    remedy: "Describe the object and add it to `MandatoryObjects`.",
    source: "CiA 301 §7.5.2.1, §7.5.2.2, §7.5.2.21; CiA 306-1 §4.6.3.1",

    "cia301/missing-module-list" = MISSING_MODULE_LIST, Warning, Device(missing_module_list);
    summary: "a modular device has no module list",
    checks: "A device with modules in `[SupportedModules]` must have 1027h, the module list.",
    why: "A master reads 1027h to identify the modules that are plugged in. Without it, the master cannot compare the station with its configuration.",
    example: "`[SupportedModules]` with `NrOfEntries=2`, without `[1027]`",
    remedy: "Add 1027h, an ARRAY of UNSIGNED16 with an element for each module, or describe it as a fixed object of the modules.",
    source: "CiA 301 §7.5.2.30, CiA 306-1 §6.2",

    "cia301/missing-vendor-id" = MISSING_VENDOR_ID, Error, Device(missing_vendor_id);
    summary: "the identity object has no vendor-ID",
    checks: "1018h must have sub-index 1. The other entries are optional.",
    why: "The vendor-ID is the only mandatory entry of the identity object. Managers compare it with 1F85h, and product code and revision number are meaningless without it.",
    example: "`[1018]` with only `[1018sub0]` and `[1018sub2]`",
    remedy: "Describe `[1018sub1]`, a read-only UNSIGNED32 with the vendor-ID assigned by CiA as its default.",
    source: "CiA 301 §7.5.2.21",

    "cia301/module-list-without-modules" = MODULE_LIST_WITHOUT_MODULES, Warning,
        Device(module_list_without_modules);
    summary: "a device has a module list but supports no modules",
    checks: "A device with 1027h, the module list, must describe the modules that it supports.",
    why: "1027h contains the numbers of the described modules. Without the descriptions, a configuration tool cannot offer the modules or add their objects.",
    example: "`[1027]` without `[SupportedModules]`",
    remedy: "Describe the modules, or remove 1027h if the device is not modular.",
    source: "CiA 301 §7.5.2.30, CiA 306-1 §6.2",

    "cia301/obsolete-object" = OBSOLETE_OBJECT, Note, ObjectOf(obsolete_object);
    summary: "the object belongs to an old edition of CiA 301",
    checks: "Reports 1004h, 100Bh, 100Eh and 100Fh, which are reserved since version 4 of CiA 301. The finding is a warning if 1004h contradicts the description: its upper half was the number of RPDOs, its lower half the number of TPDOs.",
    why: "The objects are harmless but unused: 1018h, 1200h and the PDO parameters provide the same information. A master that reads wrong numbers in 1004h expects different PDOs.",
    example: "`[100B]`, the node-ID",
    remedy: "Omit the object in new devices; set the node-ID with LSS (CiA 305) or an object from 2000h to 5FFFh instead of 100Bh.",
    source: "CiA 301 annex A, list of objects; CiA 301 version 3.0",

    "cia301/vendor-id-zero" = VENDOR_ID_ZERO, Warning, Device(vendor_id_zero);
    summary: "the vendor-ID is 0 or missing",
    checks: "1018h sub-index 1 must not be 0. A missing value is a note. In public files, 30 in 100 have 0 and 12 have no value. These are demonstrations, tests and software masters without a vendor-ID, where the finding is correct.",
    why: "CiA assigns vendor-IDs and never assigns 0. Two devices with 0 cannot be distinguished, LSS cannot address them, and a conformance test fails.",
    example: "`[1018sub1]` with `DefaultValue=0x00000000`",
    remedy: "Write the vendor-ID that CiA assigned to the vendor. Turn the rule off for a description that never leaves the laboratory.",
    source: "CiA 301 §7.5.2.21",
}

fn device_type_without_value(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1000) else { return };
    if is_unstated(object, 0) {
        let place = device.value_place(0x1000, 0);
        let finding = DEVICE_TYPE_WITHOUT_VALUE.at(place, "the device type 1000h has no value");
        findings.push(finding.help(say!(
            "add `{DefaultValue}` with the value of the device; `0x00000000` if it follows no profile"
        )));
    }
}

fn invalid_device_type(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(device_type) = facts.number(0x1000, 0) else { return };
    let (profile, additional) = (device_type & 0xFFFF, device_type >> 16);
    if let Some((message, meant)) = misread_profile(profile, additional) {
        let finding = INVALID_DEVICE_TYPE.at(facts.device.value_place(0x1000, 0), message);
        findings.push(finding.severity(Severity::Warning).help(say!("write `0x{:08X}`", meant)));
    }
    let has_drive = [0x6040, 0x6041, 0x6060].iter().all(|&index| facts.device.object(index).is_some());
    if device_type == 0 && has_drive {
        let message = "the device has the objects of a drive, but states no profile";
        let finding = INVALID_DEVICE_TYPE.at(facts.device.value_place(0x1000, 0), message);
        let finding = finding.severity(Severity::Note).label(Place::object(0x6040), "the controlword");
        findings.push(finding.help("write `0x00020192` for a servo drive that follows CiA 402"));
    }
    if profile != 0 || additional == 0 {
        return;
    }
    let message = say!(
        "`0x{:08X}` has no profile number, but additional information `0x{:04X}`",
        device_type,
        additional
    );
    let finding = INVALID_DEVICE_TYPE.at(facts.device.value_place(0x1000, 0), message);
    let finding = finding.help("write the profile number to the low word, or write 0");
    findings.push(if device_type == 0x0001_0000 { finding.severity(Severity::Warning) } else { finding });
}

/// The mistake in a device type whose profile number is a device profile in the wrong word or notation, and the intended
/// value. CiA numbers device profiles from 401 on; none is from 1025 (401h) to 1177 (499h).
fn misread_profile(profile: i128, additional: i128) -> Option<(Text, i128)> {
    let is_profile = |number: &i128| (401..=499).contains(number);
    let digits = format!("{profile:X}").parse().ok().filter(|digits| is_profile(digits) && profile > 499);
    if let Some(digits) = digits {
        let message = say!("the profile number `{}` is {} in hexadecimal digits", profile, digits);
        return Some((message, additional << 16 | digits));
    }
    let is_exchanged = is_profile(&additional) && profile < 0x100 && profile != 0;
    let message = say!("the profile number `{}` is in the high word", additional);
    is_exchanged.then_some((message, profile << 16 | additional))
}

fn missing_mandatory_object(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    // a file without any part of a device has no missing objects
    if device.objects.is_empty() && device.device_info.is_none() && device.file_info.is_none() {
        return;
    }
    for facts in applied.profile.objects().filter(|facts| facts.need == Need::Mandatory) {
        let (index, name) = (facts.first, facts.name);
        // another rule reports objects that are listed but not described
        if stated::is_there(device, index) {
            continue;
        }
        let place = match device.lists.mandatory {
            Some(_) => Place::of(Part::List(ObjectList::Mandatory)),
            None => Place::device(),
        };
        let message = say!("the mandatory object {:04X}h ({}) is missing", index, name);
        let help = say!(
            "add `{}`{}",
            Part::Object(index),
            Argument::OfLists(say!(" and list `0x{:04X}` in `MandatoryObjects`", index))
        );
        findings.push(MISSING_MANDATORY_OBJECT.at(place, message).help(help));
    }
}

fn missing_module_list(device: &Device, findings: &mut Findings) {
    let Some(modules) = device.modules.as_ref().filter(|modules| !modules.supported.is_empty()) else {
        return;
    };
    let by_module = modules
        .supported
        .values()
        .any(|module| module.fixed.contains_key(&0x1027) || module.extensions.contains_key(&0x1027));
    if by_module || stated::is_there(device, 0x1027) {
        return;
    }
    let message = "the device supports modules, but has no module list (1027h)";
    let finding = MISSING_MODULE_LIST.at(Place::of(Part::SupportedModules), message);
    findings.push(finding.help("add 1027h (module list, ARRAY of UNSIGNED16)"));
}

fn missing_vendor_id(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(Identity::INDEX) else { return };
    if object.orphan || object.has(1) || !object.object_type().has_subs() {
        return;
    }
    let place = Place::object(Identity::INDEX);
    let finding = MISSING_VENDOR_ID.at(place, "the identity object 1018h has no sub-index 1, the vendor-ID");
    findings.push(finding.help(say!(
        "add `{[1018sub1]}` with `{DataType=0x0007}`, `{AccessType=ro}` and the vendor-ID as `{DefaultValue}`"
    )));
}

fn module_list_without_modules(device: &Device, findings: &mut Findings) {
    let is_there = |object: &Object| !object.orphan;
    let has_modules = device.modules.as_ref().is_some_and(|modules| !modules.supported.is_empty());
    if device.kind == DeviceKind::Type && device.object(0x1027).is_some_and(is_there) && !has_modules {
        let message = say!("1027h is the module list, but no module is described");
        let finding = MODULE_LIST_WITHOUT_MODULES.at(Place::object(0x1027), message);
        findings.push(finding.help("describe the supported modules, or remove 1027h"));
    }
}

fn obsolete_object(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(purpose) = profile::obsolete(index) else { return };
    let message = say!("{:04X}h ({}) is obsolete since version 4 of CiA 301", index, purpose);
    let contradiction = if index == 0x1004 { wrong_pdo_numbers(device, object) } else { None };
    let finding = match contradiction {
        Some(contradiction) => {
            let message = say!("{}; {}", message, contradiction);
            OBSOLETE_OBJECT.at(Place::object(index), message).severity(Severity::Warning)
        }
        None => OBSOLETE_OBJECT.at(Place::object(index), message),
    };
    let main = object.subs.get(0).unwrap_or(&object.main);
    findings.push(finding.help(match main.access.is_some_and(Access::is_writable) {
        // without the object, the device could no longer be configured
        true if index == 0x100B => {
            "in a new device, set the node-ID with LSS or an object from 2000h to 5FFFh"
        }
        _ => "omit the object in new devices",
    }));
}

/// The deviation of the PDO counts in 1004h from the description; PDOs that `CompactPDO` implies are not described.
fn wrong_pdo_numbers(device: &Device, object: &Object) -> Option<Text> {
    let compact = device.device_info.as_ref().and_then(|info| info.compact_pdo);
    let stated = object.subs.get(0).unwrap_or(&object.main).value()?.as_integer()?;
    let count = |range: RangeInclusive<u16>| {
        i128::try_from(device.objects.range(range).filter(|(_, object)| !object.orphan).count()).ok()
    };
    let (rpdos, tpdos) = (count(0x1400..=0x15FF)?, count(0x1800..=0x19FF)?);
    let is_wrong = stated != rpdos << 16 | tpdos && compact.is_none_or(|mask| mask == 0);
    is_wrong.then(|| {
        say!(
            "its value states {} RPDOs and {} TPDOs, but {} and {} are described",
            stated >> 16,
            stated & 0xFFFF,
            rpdos,
            tpdos
        )
    })
}

fn vendor_id_zero(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(Identity::INDEX) else { return };
    let place = device.value_place(Identity::INDEX, 1);
    let help = "write the vendor-ID that CiA assigned to the vendor of the device";
    if device.identity().vendor_id == Some(0) {
        let message = "the vendor-ID is `0`, which CiA never assigns";
        findings.push(VENDOR_ID_ZERO.at(place, message).help(help));
    } else if is_unstated(object, 1) {
        let finding = VENDOR_ID_ZERO.at(place, "the vendor-ID has no value");
        findings.push(finding.severity(Severity::Note).help(help));
    }
}
