use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/mode-not-stated", Warning, Applied(check);
    summary: "a drive has the objects of a mode that 6502h does not state",
    checks: "Whether 6502h has the bit of a mode set if the objects that only this mode uses are described: 6042h and 6044h of velocity, 6081h and 607Ah of profile position, 6071h and 6087h of torque, 6098h and 6099h of homing, 60C0h and 60C1h of interpolated position; 60FFh and 606Ch belong to profile velocity or cyclic synchronous velocity. One finding per mode; none if 6502h states no mode at all.",
    why: "A master reads 6502h and does not offer the mode although the drive has it; or the objects are obsolete and have no effect.",
    example: "`[6098]` and `[6099]`, and `DefaultValue=0x00000001` in `[6502]`",
    remedy: "Set the bit of the mode, or remove its objects. A file for a family of drives may have the objects on purpose; then add an `allow` comment.",
    source: "CiA 402-2, supported drive modes",
}

/// A mode, the objects that only this mode uses, and the bits of 6502h of which one must be set.
const SHOWN_BY: [(&str, [u16; 2], u32); 6] = [
    ("velocity", [0x6042, 0x6044], 1 << 1),
    ("profile position", [0x607A, 0x6081], 1),
    ("profile velocity or cyclic synchronous velocity", [0x60FF, 0x606C], 1 << 2 | 1 << 8),
    ("torque profile", [0x6071, 0x6087], 1 << 3),
    ("homing", [0x6098, 0x6099], 1 << 5),
    ("interpolated position", [0x60C0, 0x60C1], 1 << 6),
];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let Some(modes) = drive.modes().filter(|&modes| modes & 0xFFFF != 0) else { return };
    for (mode, objects, bits) in SHOWN_BY {
        if modes & bits != 0 || !objects.iter().all(|&index| drive.has(index)) {
            continue;
        }
        let [first, second] = objects.map(|index| drive.name(index));
        let message = say!(
            "`0x{:08X}` does not state {} mode, but {} and {} are described",
            modes,
            mode,
            first,
            second
        );
        let finding = Diagnostic::new(rule, drive.value_place(0x6502, 0), message);
        let finding = finding.label(drive.place(objects[0]), "an object of the mode");
        let help = say!("set bit {} or remove the objects", bits.trailing_zeros());
        findings.push(finding.help(help));
    }
}
