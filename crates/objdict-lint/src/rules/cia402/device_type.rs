//! The device types of a drive and of its further axes.

use crate::demands::Applied;
use crate::diagnostic::{Findings, say};
use crate::rule::rules;
use crate::{Drive, Facts, profile};

rules! {
    "cia402/axis-without-device-type" = AXIS_WITHOUT_DEVICE_TYPE, Note, Applied(axis_without_device_type);
    summary: "a further axis has no device type",
    checks: "Whether each axis after the first, 800h indexes apart, has a device type at the end of its range: 6FFFh, 77FFh and so on.",
    why: "1000h states the type of the first axis, these objects that of the others: without it a master does not detect the axis or its kind.",
    example: "`[6840]` and `[6841]` without `[6FFF]`",
    remedy: "Describe the device type of the axis (UNSIGNED32, `ro`).",
    source: "CiA 301 §7.5.2.1; CiA 402-3, single device type",

    "cia402/device-type-without-drive" = DEVICE_TYPE_WITHOUT_DRIVE, Note, Applied(device_type_without_drive);
    summary: "the device type of a drive does not state the kind of drive",
    checks: "Whether 1000h, or 67FFh of an axis, has one of the bits 16 (frequency converter), 17 (servo drive) and 18 (stepper motor) set if it states profile 402. Bits 24 to 31 are manufacturer-specific, and FFFFh in the high word means several devices.",
    why: "Masters select the default PDOs by these bits.",
    example: "`DefaultValue=0x00000192` in `[1000]`",
    remedy: "Set the bit: `0x00020192` for a servo drive.",
    source: "CiA 402-3, device type",

    "cia402/different-device-type" = DIFFERENT_DEVICE_TYPE, Warning, Applied(different_device_type);
    summary: "1000h and 67FFh state different device types",
    checks: "Whether 67FFh (single device type) of a drive with one axis is 1000h (device type). A device with several logical devices has `0xFFFF` in a half of 1000h and is not checked.",
    why: "The two objects say which drive it is and which PDOs it has. A master that reads the other one sets the axis up differently.",
    example: "`[1000]` with `DefaultValue=0x00020192`, `[67FF]` with `DefaultValue=0x00040192`",
    remedy: "Write the type of the drive to both.",
    source: "CiA 402-3 (1000h, 67FFh)",
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
    // axes without their own device type have that of 1000h
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
        findings.push(finding.help("write the type of the drive to both"));
    }
}
