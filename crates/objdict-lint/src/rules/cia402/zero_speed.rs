use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Severity, say};
use crate::{Drive, Facts, rule, with_others};

rule! {
    "cia402/zero-speed", Note, Applied(check);
    summary: "a speed, a ramp or a torque of a drive is 0",
    checks: "Whether the speeds, ramps and torques that the modes of 6502h need are not 0: 6048h, 6046h sub-index 2, the speeds of 6049h and 604Ah, 6081h, 6083h, 6084h, 6087h, 6099h, 609Ah and 60C2h, and for all modes 6072h, 6073h, 6075h, 6076h, 6085h, 60E0h and 60E1h, in position modes also 6065h (following error window), and 607Fh (max profile velocity). One finding for each axis. A configured value is a warning; a default is a note, because a master may write another value first. 6065h, 607Fh and 60C2h are always a note, because some drives take 0 for no limit or no interpolation; other limits of speeds and accelerations are not checked.",
    why: "The axis accepts the command and does not move, or has no torque.",
    example: "`[6081]` with `ParameterValue=0`, and profile position mode in 6502h",
    remedy: "Write the value of the machine.",
    source: "CiA 402-2, the object descriptions of the modes",
}

/// The modes that follow a position: profile, interpolated and cyclic synchronous.
const POSITION: u32 = 1 << 0 | 1 << 6 | 1 << 7;

/// The objects in which 0 switches off a limit or the interpolation of some drives.
const MAYBE_OFF: [u16; 3] = [0x6065, 0x607F, 0x60C2];

/// The values that must not be 0, with the modes that need them as bits of 6502h; 0 for all modes.
const VALUES: [(u16, u8, u32, &str); 22] = [
    (0x6046, 2, 1 << 1, "vl velocity max amount"),
    (0x6048, 1, 1 << 1, "vl velocity acceleration"),
    (0x6048, 2, 1 << 1, "vl velocity acceleration"),
    (0x6049, 1, 1 << 1, "vl velocity deceleration"),
    (0x604A, 1, 1 << 1, "vl velocity quick stop"),
    (0x6065, 0, POSITION, "following error window"),
    (0x6072, 0, 0, "max torque"),
    (0x6073, 0, 0, "max current"),
    (0x6075, 0, 0, "motor rated current"),
    (0x6076, 0, 0, "motor rated torque"),
    (0x607F, 0, 1 << 0 | 1 << 2, "max profile velocity"),
    (0x6081, 0, 1 << 0, "profile velocity"),
    (0x6083, 0, 1 << 0 | 1 << 2, "profile acceleration"),
    (0x6084, 0, 1 << 0 | 1 << 2, "profile deceleration"),
    (0x6085, 0, 0, "quick stop deceleration"),
    (0x6087, 0, 1 << 3, "torque slope"),
    (0x6099, 1, 1 << 5, "speed during search for switch"),
    (0x6099, 2, 1 << 5, "speed during search for zero"),
    (0x609A, 0, 1 << 5, "homing acceleration"),
    (0x60C2, 1, 0x3C0, "interpolation time period"),
    (0x60E0, 0, 0, "positive torque limit"),
    (0x60E1, 0, 0, "negative torque limit"),
];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let modes = drive.modes().unwrap_or(0);
    let zeros = VALUES.iter().filter(|&&(index, sub, needed, _)| {
        (needed == 0 || modes & needed != 0) && drive.value(index, sub) == Some(0)
    });
    let is_configured = |&(index, sub, ..): &(u16, u8, u32, &str)| {
        let entry = drive.object(index).and_then(|object| object.entry(sub));
        !MAYBE_OFF.contains(&index) && entry.is_some_and(|entry| entry.configured_value().is_some())
    };
    // the configured ones first, because they are certain
    let (configured, defaults): (Vec<_>, Vec<_>) = zeros.copied().partition(is_configured);
    let mut all = configured.iter().chain(&defaults);
    let Some(&(index, sub, _, name)) = all.next() else { return };
    let finding = Diagnostic::new(rule, drive.value_place(index, sub), say!("the {} is `0`", name));
    let others = all.map(|&(index, sub, _, name)| (drive.value_place(index, sub), say!("the {} too", name)));
    let finding = with_others(finding, others).help("write a value that fits the machine");
    findings.push(if configured.is_empty() { finding } else { finding.severity(Severity::Warning) });
}
