use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/no-baud-rate", Warning, Device(check);
    summary: "no supported bit rate is given",
    checks: "Whether at least one `BaudRate_x` is 1, unless the device detects the bit rate (`BaudRate_auto=1`).",
    why: "Configuration tools offer only the bit rates given here, so they offer none.",
    example: "`[DeviceInfo]` without any `BaudRate_x`",
    remedy: "Add `BaudRate_125=1` and the other supported bit rates.",
    source: "CiA 306-1 §4.5",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let rates = &info.baud_rates;
    let is_known = |field: &Field| info.invalid_values.get(field).is_none();
    let unreadable = rates.iter().any(|(_, field, _)| !is_known(&field)) || !is_known(&Field::BaudRateAuto);
    if rates.supported().next().is_some() || rates.auto == Some(true) || unreadable {
        return;
    }
    let stated = rates.iter().find(|(.., supported)| supported.is_some());
    let (place, message, help) = match stated {
        Some((_, field, _)) => (
            Place::of(Part::DeviceInfo).field(field),
            say!("every `{BaudRate_x}` is 0"),
            say!("write 1 for each supported bit rate, such as `{BaudRate_125=1}`"),
        ),
        None => (
            Place::of(Part::DeviceInfo),
            say!("`{[DeviceInfo]}` has no `{BaudRate_x}`"),
            say!("add a key such as `{BaudRate_125=1}` for each supported bit rate"),
        ),
    };
    findings.push(Diagnostic::new(&RULE.info, place, message).help(help));
}
