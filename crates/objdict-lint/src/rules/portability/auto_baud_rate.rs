use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "portability/auto-baud-rate", Warning, Device(check);
    summary: "`BaudRate_auto` is unknown to a tool",
    checks: "Whether `[DeviceInfo]` has the key `BaudRate_auto`.",
    why: "dcf-tools has the keys of the first edition of CiA 306 and refuses a file with another one.",
    example: "`BaudRate_auto=0`",
    remedy: "Remove the key where it is 0; else give the tool a copy without it.",
    source: "dcf-tools 2.4.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(auto) = device.device_info.as_ref().and_then(|info| info.baud_rates.auto) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::BaudRateAuto);
    let finding = Diagnostic::new(&RULE.info, place, say!("`{BaudRate_auto}` is {a key} of later editions"));
    findings.push(finding.help(if auto {
        say!("give the tool a copy without {the key}")
    } else {
        say!("remove {the key}: 0 is what its absence means")
    }));
}
