use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Device;
use crate::{is_unstated, rule};

rule! {
    "cia301/device-type-without-value", Warning, Device(check);
    summary: "the device type has no value",
    checks: "Whether the value of 1000h is stated.",
    why: "The low word of 1000h names the device profile. Without it a tool cannot know what the objects from 6000h on mean, and no rule about profiles can be applied.",
    example: "`[1000]` without `DefaultValue`",
    remedy: "Write the value that the device answers; 0 when it follows no device profile.",
    source: "CiA 301 §7.5.2.1",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1000) else { return };
    if is_unstated(object, 0) {
        let place = device.value_place(0x1000, 0);
        let finding = Diagnostic::new(&RULE.info, place, "the device type 1000h has no value");
        findings.push(
            finding.help(say!("write it as `{DefaultValue}`: `0x00000000` for a device without a profile")),
        );
    }
}
