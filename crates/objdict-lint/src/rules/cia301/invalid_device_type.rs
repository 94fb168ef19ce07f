use crate::diagnostic::{Diagnostic, Findings, Severity, Text, say};
use crate::model::Place;
use crate::{Facts, rule};

rule! {
    "cia301/invalid-device-type", Error, Facts(check);
    summary: "the device type is contradictory",
    checks: "Whether the high word of 1000h is 0 if the low word, the profile number, is 0 (no profile). For `0x00010000`, which tools write for a generic device, the finding is a warning. Warnings are also a profile number in hexadecimal digits that is meant in decimal (0402h, which is 1026), and a device type whose words are exchanged. A note is a device with the controlword, statusword and mode of a drive (6040h, 6041h, 6060h) and profile number 0.",
    why: "The high word has a meaning only within a profile. A master that compares the device type or derives the profile from it reaches the wrong conclusion.",
    example: "`[1000]` with `DefaultValue=0x00030000`",
    remedy: "Write the profile number to the low word, such as `0x00030191` for CiA 401, or write 0.",
    source: "CiA 301 §7.5.2.1",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(device_type) = facts.number(0x1000, 0) else { return };
    let (profile, additional) = (device_type & 0xFFFF, device_type >> 16);
    if let Some((message, meant)) = misread(profile, additional) {
        let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1000, 0), message);
        findings.push(finding.severity(Severity::Warning).help(say!("write `0x{:08X}`", meant)));
    }
    let has_drive = [0x6040, 0x6041, 0x6060].iter().all(|&index| facts.device.object(index).is_some());
    if device_type == 0 && has_drive {
        let message = "the device has the objects of a drive, but states no profile";
        let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1000, 0), message);
        let finding = finding.severity(Severity::Note).label(Place::object(0x6040), "the controlword");
        findings.push(finding.help("write `0x00020192` for a servo drive that follows CiA 402"));
    }
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

/// The mistake in a device type whose profile number is that of a device profile in another place or notation, and
/// what is meant. CiA numbers device profiles from 401 on; none is from 1025 (401h) to 1177 (499h).
fn misread(profile: i128, additional: i128) -> Option<(Text, i128)> {
    let is_profile = |number: &i128| (401..=499).contains(number);
    let digits = format!("{profile:X}").parse().ok().filter(|digits| is_profile(digits) && profile > 499);
    if let Some(digits) = digits {
        let message = say!("the profile number `{}` is {} in hexadecimal digits", profile, digits);
        return Some((message, additional << 16 | digits));
    }
    let is_exchanged = is_profile(&additional) && profile < 0x100 && profile != 0;
    let message = say!("the profile number `{}` is in the high word", additional);
    is_exchanged.then_some((message, profile << 16 | additional))
}
