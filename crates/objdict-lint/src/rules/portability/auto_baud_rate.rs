use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "portability/auto-baud-rate", Error, Device(check);
    summary: "a tool does not know `BaudRate_auto`",
    checks: "Whether `[DeviceInfo]` has the key `BaudRate_auto`.",
    why: "dcf-tools knows only the keys of the first edition of CiA 306 and refuses a file with other keys.",
    example: "`BaudRate_auto=0`",
    remedy: "Remove the key if it is 0; otherwise use a copy without the key for the tool.",
    source: "dcf-tools 2.4.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(auto) = device.device_info.as_ref().and_then(|info| info.baud_rates.auto) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::BaudRateAuto);
    let finding =
        Diagnostic::new(&RULE.info, place, say!("`{BaudRate_auto}` is {a key} of later editions of CiA 306"));
    findings.push(finding.help(if auto {
        say!("use a copy without {the key} for the tool")
    } else {
        say!("remove {the key}: 0 is the default")
    }));
}
