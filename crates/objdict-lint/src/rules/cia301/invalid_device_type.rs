use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::{Facts, rule};

rule! {
    "cia301/invalid-device-type", Error, Facts(check);
    summary: "the device type is contradictory",
    checks: "Whether the high word of 1000h is 0 if the low word, the profile number, is 0 (no profile). For `0x00010000`, which tools write for a generic device, the finding is a warning.",
    why: "The high word has a meaning only within a profile. A master that compares the device type or derives the profile from it reaches the wrong conclusion.",
    example: "`[1000]` with `DefaultValue=0x00030000`",
    remedy: "Write the profile number to the low word, such as `0x00030191` for CiA 401, or write 0.",
    source: "CiA 301 §7.5.2.1",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(device_type) = facts.number(0x1000, 0).filter(|&number| number > 0) else { return };
    let (profile, additional) = (device_type & 0xFFFF, device_type >> 16);
    if profile != 0 || additional == 0 {
        return;
    }
    let message = say!(
        "`0x{:08X}` has no profile number, but additional information `0x{:04X}`",
        device_type,
        additional
    );
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1000, 0), message);
    let finding = finding.help("write the profile number to the low word, or write 0");
    findings.push(if device_type == 0x0001_0000 { finding.severity(Severity::Warning) } else { finding });
}
