use crate::diagnostic::{Diagnostic, Findings, Severity, say, series};
use crate::model::{BaudRates, Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/invalid-baud-rate", Error, Device(check);
    summary: "the bit rate of a DCF is not valid",
    checks: "Whether `Baudrate` is a CiA 301 bit rate (10, 20, 50, 125, 250, 500, 800, 1000 kbit/s) and the device supports it according to `BaudRate_x`. 0, which tools write when no bit rate is selected, is a warning.",
    why: "A node with a wrong bit rate disturbs the network or cannot communicate.",
    example: "`Baudrate=500000`",
    remedy: "Write the bit rate in kbit/s.",
    source: "CiA 306-1 §5.4, CiA 301 §6.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(rate) = device.commissioning.as_ref().and_then(|node| node.baud_rate) else { return };
    let place = Place::of(Part::Commissioning).field(Field::Baudrate);
    if !BaudRates::DEFINED.contains(&rate) {
        let message = match rate {
            0 => say!("`{Baudrate}` is 0: no bit rate is selected").to_owned(),
            _ => say!("`{Baudrate}` is {}, but CANopen does not define this bit rate", rate),
        };
        let finding = Diagnostic::new(&RULE.info, place, message).severity(if rate == 0 {
            Severity::Warning
        } else {
            Severity::Error
        });
        findings
            .push(finding.help(say!("write one of the bit rates in kbit/s: {}", series(BaudRates::DEFINED))));
        return;
    }
    let Some(info) = &device.device_info else { return };
    let supported: Vec<u16> = info.baud_rates.supported().collect();
    // another rule reports a device without bit rates
    if supported.is_empty() || supported.contains(&rate) {
        return;
    }
    let field = info.baud_rates.iter().find(|(other, ..)| *other == rate).map(|(_, field, _)| field);
    if field.as_ref().is_some_and(|field| info.invalid_values.get(field).is_some()) {
        return;
    }
    let message = say!("`{Baudrate}` is {}, which the device does not support", rate);
    let label = Place { field, ..Place::of(Part::DeviceInfo) };
    let finding = Diagnostic::new(&RULE.info, place, message).label(label, "not supported");
    findings
        .push(finding.help(say!("write a bit rate that the device supports: {} kbit/s", series(supported))));
}
