use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Facts, rule};

rule! {
    "cia402/different-device-type", Warning, Applied(check);
    summary: "1000h and 67FFh state different device types",
    checks: "Whether 67FFh (single device type) of a drive with one axis is 1000h (device type). A device with several logical devices has `0xFFFF` in a half of 1000h and is not checked.",
    why: "The two objects say which drive it is and which PDOs it has. A master that reads the other one sets the axis up differently.",
    example: "`[1000]` with `DefaultValue=0x00020192`, `[67FF]` with `DefaultValue=0x00040192`",
    remedy: "Write the type of the drive to both.",
    source: "CiA 402-3 (1000h, 67FFh)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let (Some(whole), Some(single)) = (facts.number(0x1000, 0), facts.number(0x67FF, 0)) else { return };
    let is_multiple = whole & 0xFFFF == 0xFFFF || whole >> 16 == 0xFFFF || device.object(0x6FFF).is_some();
    if applied.block == 0 && !is_multiple && whole != single {
        let message = say!("67FFh is `0x{:08X}`, but 1000h is `0x{:08X}`", single, whole);
        let finding = Diagnostic::new(rule, device.value_place(0x67FF, 0), message);
        let finding = finding.label(device.value_place(0x1000, 0), "the device type");
        findings.push(finding.help("write the type of the drive to both"));
    }
}
