use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, DeviceKind, Field, Part, Place};
use crate::rule;

rule! {
    "cia305/serial-number-in-eds", Warning, Device(check);
    summary: "the description assigns one serial number to all devices of the type",
    checks: "Whether the default of 1018h sub-index 4, the serial number, is 0 or missing in an EDS of a device with `LSS_Supported=1`.",
    why: "LSS distinguishes devices of a type by their serial numbers. A number in the EDS belongs to a single device; a tool that uses it for the other devices does not find them.",
    example: "`LSS_Supported=1` with `DefaultValue=123456` in `[1018sub4]`",
    remedy: "Remove the value, or write 0; the serial number of a node belongs in its DCF.",
    source: "CiA 305, CiA 301 §7.5.2.21",
}

fn check(device: &Device, findings: &mut Findings) {
    let supports_lss = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(true));
    let serial_number = device.identity().serial_number.filter(|&number| number != 0);
    let Some(serial_number) = serial_number.filter(|_| supports_lss && device.kind == DeviceKind::Type)
    else {
        return;
    };
    let message = say!("all devices of the type have the serial number `{}`", serial_number);
    let finding = Diagnostic::new(&RULE.info, device.value_place(0x1018, 4), message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS needs a unique serial number");
    findings.push(finding.help(say!("remove the value; the serial number of a node belongs in its {DCF}")));
}
