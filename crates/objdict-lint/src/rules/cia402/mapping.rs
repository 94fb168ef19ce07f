//! The device types of a drive and its further axes and the objects that its PDOs must carry.

use crate::demands::Applied;
use crate::diagnostic::{Findings, say};
use crate::model::{Entry, Field, PdoKind};
use crate::rule::rules;
use crate::{Drive, Facts, PdoFacts, profile};

rules! {
    "cia402/axis-without-device-type" = AXIS_WITHOUT_DEVICE_TYPE, Note, Applied(axis_without_device_type);
    summary: "a further axis has no device type",
    checks: "Each axis after the first, 800h indexes apart, must have a device type at the end of its range: 6FFFh, 77FFh and so on.",
    why: "1000h defines the type of the first axis, and these objects define the types of the others. Without them a master does not detect the axis or its kind.",
    example: "`[6840]` and `[6841]` without `[6FFF]`",
    remedy: "Describe the device type of the axis (UNSIGNED32, `ro`).",
    source: "CiA 301 §7.5.2.1; CiA 402-3, single device type",

    "cia402/controlword-not-mappable" = CONTROLWORD_NOT_MAPPABLE, Warning, Applied(controlword_not_mappable);
    summary: "the controlword or the statusword is not mappable",
    checks: "In a drive with RPDOs and TPDOs, 6040h and 6041h must be marked as mappable.",
    why: "Masters control the state machine by PDO. If the objects cannot be mapped, each transition needs an SDO transfer, which most masters do not support.",
    example: "`PDOMapping=0` in `[6040]`",
    remedy: "Write `PDOMapping=1` if the drive supports it.",
    source: "CiA 402-2, controlword and statusword; CiA 402-3, default PDOs",

    "cia402/controlword-not-mapped" = CONTROLWORD_NOT_MAPPED, Note, Applied(controlword_not_mapped);
    summary: "no PDO carries the controlword or the statusword by default",
    checks: "In drives whose PDOs have a default mapping, at least one RPDO must map 6040h and one TPDO must map 6041h by default. Only the first axis is checked. Drives with an incomplete default mapping and objects that are not mappable are skipped.",
    why: "The default PDOs of CiA 402-3 begin with these objects, and a master that keeps the default mapping relies on them.",
    example: "`DefaultValue=0x607A0020` in `[1600sub1]`, and no RPDO with 60400010h",
    remedy: "Map the objects by default, first in RPDO 1 and TPDO 1. You can ignore the note if every master configures the mapping, because the drive works with such a master.",
    source: "CiA 402-3, default PDOs",

    "cia402/cyclic-target-not-mappable" = CYCLIC_TARGET_NOT_MAPPABLE, Warning,
        Drive(cyclic_target_not_mappable);
    summary: "the target of a cyclic mode is not mappable",
    checks: "If 6502h indicates a cyclic synchronous mode, its target must be marked as mappable: 607Ah (target position), 60FFh (target velocity) or 6071h (target torque).",
    why: "A cyclic mode needs a new target with every SYNC; SDO transfers are too slow.",
    example: "`DefaultValue=0x00000080` in `[6502]`, and `PDOMapping=0` in `[607A]`",
    remedy: "Write `PDOMapping=1`, or clear the bit of the mode in 6502h.",
    source: "CiA 402-2, cyclic synchronous modes",

    "cia402/device-type-without-drive" = DEVICE_TYPE_WITHOUT_DRIVE, Note, Applied(device_type_without_drive);
    summary: "the device type of a drive does not indicate the kind of drive",
    checks: "If 1000h, or 67FFh of an axis, indicates profile 402, one of the bits 16 (frequency converter), 17 (servo drive) and 18 (stepper motor) must be set. Bits 24 to 31 are manufacturer-specific, and FFFFh in the high word means several devices.",
    why: "Masters select the default PDOs by these bits.",
    example: "`DefaultValue=0x00000192` in `[1000]`",
    remedy: "Set the bit: `0x00020192` for a servo drive.",
    source: "CiA 402-3, device type",

    "cia402/different-device-type" = DIFFERENT_DEVICE_TYPE, Warning, Applied(different_device_type);
    summary: "1000h and 67FFh have different device types",
    checks: "In a drive with one axis, 67FFh (single device type) must equal 1000h (device type). A device with several logical devices has `0xFFFF` in a half of 1000h and is not checked.",
    why: "The two objects define the kind of drive and its PDOs. A master that reads the other object sets the axis up differently.",
    example: "`[1000]` with `DefaultValue=0x00020192`, `[67FF]` with `DefaultValue=0x00040192`",
    remedy: "Write the type of the drive to both.",
    source: "CiA 402-3 (1000h, 67FFh)",
}

fn controlword_not_mappable(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (index, name, kind) in [(0x6040, "controlword", PdoKind::Rpdo), (0x6041, "statusword", PdoKind::Tpdo)]
    {
        let has_pdos = facts.pdos.iter().any(|facts| facts.pdo.kind == kind);
        let Some(entry) = drive.variable(index).filter(|_| has_pdos) else { continue };
        if entry.is_mappable() || entry.invalid_values.get(&Field::PdoMapping).is_some() {
            continue;
        }
        let message = say!("{} ({}) is not mappable, so no {} can carry it", drive.name(index), name, kind);
        let place = drive.place(index).field(Field::PdoMapping);
        findings.push(CONTROLWORD_NOT_MAPPABLE.at(place, message).help(say!("write `{PDOMapping=1}`")));
    }
}

fn controlword_not_mapped(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    if applied.block > 0 {
        return;
    }
    let drive = Drive::new(facts, applied);
    for (index, name, kind) in [(0x6040, "controlword", PdoKind::Rpdo), (0x6041, "statusword", PdoKind::Tpdo)]
    {
        let pdos = facts.pdos.iter().filter(|facts| facts.pdo.kind == kind);
        let is_open = pdos.clone().any(|facts| facts.pdo.used_slots().any(|slot| slot.object.is_none()));
        let maps = |facts: &PdoFacts<'_>| {
            facts.mapped.iter().any(|mapped| mapped.object.index == drive.index(index))
        };
        let Some(first) = pdos.clone().find(|facts| !facts.mapped.is_empty()) else { continue };
        let is_mappable = drive.variable(index).is_some_and(Entry::is_mappable);
        if is_open || !is_mappable || pdos.clone().any(maps) {
            continue;
        }
        let message = say!("no {!} maps {} ({}) by default", kind, drive.name(index), name);
        let finding = CONTROLWORD_NOT_MAPPED.at(drive.place(index), message);
        let place = facts.device.value_place(first.pdo.mapping_index(), 1);
        let help = say!("map it as the first object: `0x{:04X}0010`", drive.index(index));
        findings.push(finding.label(place, say!("{} maps this", first.pdo)).help(help));
    }
}

fn cyclic_target_not_mappable(drive: Drive<'_>, findings: &mut Findings) {
    for (bit, index, mode) in [(7, 0x607A, "position"), (8, 0x60FF, "velocity"), (9, 0x6071, "torque")] {
        let Some(entry) = drive.variable(index) else { continue };
        let is_readable = entry.invalid_values.get(&Field::PdoMapping).is_none();
        if drive.supports(bit) == Some(true) && is_readable && !entry.is_mappable() {
            let name = drive.name(index);
            let message =
                say!("{} is not mappable, but cyclic synchronous {} mode needs it in a PDO", name, mode);
            let finding = CYCLIC_TARGET_NOT_MAPPABLE.at(drive.place(index).field(Field::PdoMapping), message);
            let finding = finding.label(drive.value_place(0x6502, 0), say!("bit {} states the mode", bit));
            findings.push(finding.help(say!("write `{PDOMapping=1}`")));
        }
    }
}

fn axis_without_device_type(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let is_axis = applied.block > 0 && drive.has(0x6040);
    if is_axis && drive.lacks(0x67FF) {
        let (axis, name) = (applied.block + 1, drive.name(0x67FF));
        let message = say!("axis {} has no device type: {} is missing", axis, name);
        let finding = AXIS_WITHOUT_DEVICE_TYPE.at(drive.place(0x6040), message);
        findings.push(finding.help(say!("describe {} (UNSIGNED32, `ro`)", name)));
    }
}

fn device_type_without_drive(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let index = profile::device_type_index(facts.device, applied.block);
    // axes without their own device type use 1000h
    if applied.block > 0 && index == 0x1000 {
        return;
    }
    let value = facts.device.object(index).and_then(|object| object.value(0)?.as_integer());
    let Some(value) = value.filter(|value| value & 0xFFFF == 402 && value & 0x7_0000 == 0) else { return };
    let message = say!("the device type `0x{:08X}` does not state the kind of drive", value);
    let place = facts.device.value_place(index, 0);
    let servo = value | 0x2_0000;
    let help = say!("set bit 16, 17 or 18; for a servo drive write `0x{:08X}`", servo);
    findings.push(DEVICE_TYPE_WITHOUT_DRIVE.at(place, message).help(help));
}

fn different_device_type(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let (Some(whole), Some(single)) = (facts.number(0x1000, 0), facts.number(0x67FF, 0)) else { return };
    let is_multiple = whole & 0xFFFF == 0xFFFF || whole >> 16 == 0xFFFF || device.object(0x6FFF).is_some();
    if applied.block == 0 && !is_multiple && whole != single {
        let message = say!("67FFh is `0x{:08X}`, but 1000h is `0x{:08X}`", single, whole);
        let finding = DIFFERENT_DEVICE_TYPE.at(device.value_place(0x67FF, 0), message);
        let finding = finding.label(device.value_place(0x1000, 0), "the device type");
        findings.push(finding.help("write the drive type to both"));
    }
}
