use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia305/serial-number-without-lss", Warning, Device(check);
    summary: "a node without LSS has a serial number for LSS",
    checks: "Whether a DCF with an `LSS_SerialNumber` other than 0 has `LSS_Supported=0`.",
    why: "A manager tries to select the node by LSS at every start and waits for an answer that never comes.",
    example: "`LSS_SerialNumber=1234` with `LSS_Supported=0`",
    remedy: "Write `LSS_Supported=1` if the device supports it, otherwise remove the number.",
    source: "CiA 305, CiA 306-1 §4.5, §5.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let number =
        device.commissioning.as_ref().and_then(|node| node.lss_serial_number).filter(|&number| number != 0);
    let refuses = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(false));
    let Some(number) = number.filter(|_| refuses) else { return };
    let message = say!("serial number {:h} is set for LSS, but the device does not support LSS", number);
    let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
    let finding = Diagnostic::new(&RULE.info, place, message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS is not supported");
    findings.push(
        finding.help(say!("remove the number, or write `{LSS_Supported=1}` if the device supports LSS")),
    );
}
