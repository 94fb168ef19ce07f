//! The LSS address and nodes that get their node-ID by LSS.

use crate::diagnostic::{Findings, say, series};
use crate::is_unstated;
use crate::model::{Device, DeviceKind, Field, Part, Place};
use crate::rule::rules;

rules! {
    "cia305/incomplete-address" = INCOMPLETE_ADDRESS, Warning, Device(incomplete_address);
    summary: "the LSS address of the device is incomplete",
    checks: "On a device with `LSS_Supported=1`, 1018h sub-indexes 2 and 3 (product code and revision number) must have a value. The vendor-ID has its own rule. The serial number is specific to each device.",
    why: "An LSS manager selects the device by vendor-ID, product code, revision number and serial number. The description must contain the first three.",
    example: "`LSS_Supported=1` without `DefaultValue` in `[1018sub2]`",
    remedy: "Write the values.",
    source: "CiA 305, CiA 301 §7.5.2.21",

    "cia305/serial-number-in-eds" = SERIAL_NUMBER_IN_EDS, Warning, Device(serial_number_in_eds);
    summary: "the description assigns one serial number to all devices of the type",
    checks: "In an EDS with `LSS_Supported=1`, the default of 1018h sub-index 4 (serial number) must be 0 or missing.",
    why: "LSS distinguishes devices of a type by their serial numbers. A number in the EDS belongs to a single device. A tool that uses it for the other devices does not find them.",
    example: "`LSS_Supported=1` with `DefaultValue=123456` in `[1018sub4]`",
    remedy: "Remove the value, or write 0; the serial number of a node belongs in its DCF.",
    source: "CiA 305, CiA 301 §7.5.2.21",

    "cia305/serial-number-without-lss" = SERIAL_NUMBER_WITHOUT_LSS, Warning,
        Device(serial_number_without_lss);
    summary: "a node without LSS has a serial number for LSS",
    checks: "Reports a DCF with an `LSS_SerialNumber` other than 0 and `LSS_Supported=0`.",
    why: "A manager tries to select the node by LSS at every start and waits for a response that never arrives.",
    example: "`LSS_SerialNumber=1234` with `LSS_Supported=0`",
    remedy: "Write `LSS_Supported=1` if the device supports it, otherwise remove the number.",
    source: "CiA 305, CiA 306-1 §4.5, §5.4",

    "cia305/unconfigured-without-address" = UNCONFIGURED_WITHOUT_ADDRESS, Warning,
        Device(unconfigured_without_address);
    summary: "a node gets its node-ID by LSS, but its LSS address is incomplete",
    checks: "A DCF with `NodeID=255` must specify the four numbers of the LSS address: vendor-ID, product code, revision number and serial number. The serial number may be in 1018h sub-index 4 or `LSS_SerialNumber`. A 0 is treated as missing, except for product code and revision number.",
    why: "A manager without the numbers must search for the node and may find a different device of the same type.",
    example: "`NodeID=255` and `LSS_SerialNumber=0`, without a value in `[1018sub4]`",
    remedy: "Write the serial number from the label of the device as `LSS_SerialNumber`.",
    source: "CiA 305, CiA 306-1 §5.4",

    "cia305/unconfigured-without-lss" = UNCONFIGURED_WITHOUT_LSS, Error, Device(unconfigured_without_lss);
    summary: "a node waits for a node-ID by LSS but does not support LSS",
    checks: "Reports a DCF with `NodeID=255` (node-ID assigned by LSS) and `LSS_Supported=0`.",
    why: "The node is never accessible: without a node-ID it has no SDO, and without LSS it gets no node-ID.",
    example: "`NodeID=255` with `LSS_Supported=0`",
    remedy: "Write the node-ID, or `LSS_Supported=1` if the device supports it.",
    source: "CiA 305, CiA 306-1 §5.4",
}

fn incomplete_address(device: &Device, findings: &mut Findings) {
    let supports_lss = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(true));
    let Some(object) = device.object(0x1018).filter(|object| supports_lss && object.compact.is_none()) else {
        return;
    };
    for (sub, name) in [(2, "product code"), (3, "revision number")] {
        let has_type = object.subs.get(sub).is_some_and(|entry| entry.data_type.is_some());
        if has_type && is_unstated(object, sub) {
            let message = say!("the {}, part of the LSS address, has no value", name);
            let finding = INCOMPLETE_ADDRESS
                .at(device.value_place(0x1018, sub), message)
                .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "the device supports LSS");
            findings.push(finding.help("add the value"));
        }
    }
}

fn serial_number_in_eds(device: &Device, findings: &mut Findings) {
    let supports_lss = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(true));
    let serial_number = device.identity().serial_number.filter(|&number| number != 0);
    let Some(serial_number) = serial_number.filter(|_| supports_lss && device.kind == DeviceKind::Type)
    else {
        return;
    };
    let message = say!("serial number `{}` applies to all devices of this type", serial_number);
    let finding = SERIAL_NUMBER_IN_EDS
        .at(device.value_place(0x1018, 4), message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS needs a unique serial number");
    findings.push(finding.help(say!("remove the value; a node's serial number belongs in its {DCF}")));
}

fn serial_number_without_lss(device: &Device, findings: &mut Findings) {
    let number =
        device.commissioning.as_ref().and_then(|node| node.lss_serial_number).filter(|&number| number != 0);
    let refuses = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(false));
    let Some(number) = number.filter(|_| refuses) else { return };
    let message = say!("serial number {:h} is set for LSS, but the device does not support LSS", number);
    let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
    let finding = SERIAL_NUMBER_WITHOUT_LSS
        .at(place, message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS is not supported");
    findings.push(
        finding.help(say!("remove the number, or write `{LSS_Supported=1}` if the device supports LSS")),
    );
}

fn unconfigured_without_address(device: &Device, findings: &mut Findings) {
    let Some(node) = device.commissioning.as_ref().filter(|node| node.node_id == Some(255)) else { return };
    let Some(info) = device.device_info.as_ref().filter(|info| info.lss_supported != Some(false)) else {
        return;
    };
    let identity = device.identity();
    let known = |number: Option<u32>| number.is_some_and(|number| number != 0);
    let numbers = [
        ("vendor-ID", known(identity.vendor_id) || known(info.vendor_number)),
        ("product code", identity.product_code.or(info.product_number).is_some()),
        ("revision number", identity.revision_number.or(info.revision_number).is_some()),
        ("serial number", known(identity.serial_number) || known(node.lss_serial_number)),
    ];
    let missing: Vec<&str> =
        numbers.into_iter().filter(|(_, is_known)| !is_known).map(|(name, _)| name).collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("`255` requires LSS, but the LSS address is missing the {}", series(missing));
    let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
    let finding = UNCONFIGURED_WITHOUT_ADDRESS.at(place, message);
    findings.push(finding.help("write the numbers from the device label"));
}

fn unconfigured_without_lss(device: &Device, findings: &mut Findings) {
    let waits = device.commissioning.as_ref().is_some_and(|node| node.node_id == Some(255));
    let refuses = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(false));
    if !waits || !refuses {
        return;
    }
    let message = "`255` makes the node wait for LSS, but the device does not support LSS";
    let place = Place::of(Part::Commissioning).field(Field::NodeId);
    let finding = UNCONFIGURED_WITHOUT_LSS
        .at(place, message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS is not supported");
    findings.push(finding.help("write the node-ID"));
}
