use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place, Value};
use crate::rule;

rule! {
    "cia306/lss-serial-number", Warning, Device(check);
    summary: "the serial number for LSS differs from 1018h",
    checks: "Whether `LSS_SerialNumber` equals 1018h sub-index 4, where both are given and not 0.",
    why: "LSS selects the node by its serial number; with a wrong number the node does not answer.",
    example: "`LSS_SerialNumber=1234` and `ParameterValue=1235` in `[1018sub4]`",
    remedy: "Write the number from the device label in both places.",
    source: "CiA 306-1 §5.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let stated = device.commissioning.as_ref().and_then(|node| node.lss_serial_number);
    let Some(stated) = stated.filter(|&number| number != 0) else { return };
    let Some(entry) = device.entry(0x1018, 4) else { return };
    let field = if entry.configured_value().is_some() { Field::ParameterValue } else { Field::DefaultValue };
    // an EDS has 0 for a number that differs in each device
    let Some(value) = entry.value().and_then(Value::as_integer).filter(|&value| value != 0) else {
        return;
    };
    if value != i128::from(stated) {
        let message = say!("`{LSS_SerialNumber}` is {}, but 1018h sub-index 4 is {}", stated, value);
        let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
        let finding = Diagnostic::new(&RULE.info, place, message)
            .label(Place::entry(0x1018, 4).field(field), "the serial number of the identity object");
        findings.push(finding.help("write the serial number of the device in both places"));
    }
}
