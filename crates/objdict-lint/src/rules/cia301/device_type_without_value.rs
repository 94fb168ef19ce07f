use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Device;
use crate::{is_unstated, rule};

rule! {
    "cia301/device-type-without-value", Warning, Device(check);
    summary: "the device type has no value",
    checks: "Whether 1000h has a value.",
    why: "The low word of 1000h is the number of the device profile. Without it a tool does not know the meaning of the objects from 6000h on, and no profile rule applies.",
    example: "`[1000]` without `DefaultValue`",
    remedy: "Write the value that the device returns, or 0 if it follows no device profile.",
    source: "CiA 301 §7.5.2.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1000) else { return };
    if is_unstated(object, 0) {
        let place = device.value_place(0x1000, 0);
        let finding = Diagnostic::new(&RULE.info, place, "the device type 1000h has no value");
        findings.push(finding.help(say!(
            "add `{DefaultValue}` with the value of the device; `0x00000000` if it follows no profile"
        )));
    }
}
