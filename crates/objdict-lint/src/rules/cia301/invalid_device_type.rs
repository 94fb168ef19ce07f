use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia301/invalid-device-type", Error, Facts(check);
    summary: "the device type contradicts itself",
    checks: "Whether 1000h with the profile number 0 in its low word, which says that the device follows no profile, has 0 in its high word too.",
    why: "The high word means something within a profile only. A master that compares the device type, or takes the profile from it, draws the wrong conclusion.",
    example: "`[1000]` with `DefaultValue=0x00030000`",
    remedy: "Write the number of the profile into the low word, such as `0x00030191` for CiA 401, or 0 as a whole.",
    source: "CiA 301 §7.5.2.1",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(device_type) = facts.number(0x1000, 0).filter(|&number| number > 0) else { return };
    let (profile, additional) = (device_type & 0xFFFF, device_type >> 16);
    if profile != 0 || additional == 0 {
        return;
    }
    let message = say!("`0x{:08X}` names no profile, and adds `0x{:04X}` to it", device_type, additional);
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1000, 0), message);
    findings.push(finding.help("write the number of the profile into the low word, or 0 as a whole"));
}
