use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia305/serial-number-without-lss", Warning, Device(check);
    summary: "a serial number for LSS is given to a node without LSS",
    checks: "Whether a DCF with an `LSS_SerialNumber` other than 0 is of a device with `LSS_Supported=1`, where it says either.",
    why: "A manager tries to select the node by LSS at every start, and waits for an answer that does not come.",
    example: "`LSS_SerialNumber=1234` and `LSS_Supported=0`",
    remedy: "Write `LSS_Supported=1` if the device supports it, else remove the number.",
    source: "CiA 305, CiA 306-1 §4.5, §5.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let number =
        device.commissioning.as_ref().and_then(|node| node.lss_serial_number).filter(|&number| number != 0);
    let refuses = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(false));
    let Some(number) = number.filter(|_| refuses) else { return };
    let message = say!("LSS shall find the node by `{}`, and it does not support LSS", number);
    let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
    let finding = Diagnostic::new(&RULE.info, place, message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "says so");
    findings.push(finding.help(say!("remove the number, or write `{LSS_Supported=1}` if that is so")));
}
