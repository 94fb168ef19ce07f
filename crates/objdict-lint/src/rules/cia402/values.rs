//! The values of a drive that stop or start it unintentionally.

use crate::demands::Applied;
use crate::diagnostic::{Findings, Severity, say};
use crate::rule::rules;
use crate::{Drive, Facts};

rules! {
    "cia402/enabled-by-default" = ENABLED_BY_DEFAULT, Warning, Drive(enabled_by_default);
    summary: "the controlword of a drive enables operation from the start",
    checks: "The configured or default value of 6040h must not be `Enable operation`: bits 0 to 3 set and bit 7 clear.",
    why: "The axis is powered as soon as its state allows it, before a master has checked anything. It may move after a restart or a repaired fault.",
    example: "`DefaultValue=0x000F` in `[6040]`",
    remedy: "Write 0 and let the master command the states one after the other.",
    source: "CiA 402-2, controlword",

    "cia402/interpolation-time-differs" = INTERPOLATION_TIME_DIFFERS, Warning,
        Drive(interpolation_time_differs);
    summary: "the interpolation time does not match the SYNC period",
    checks: "The time in 60C2h, value times ten to the power of the index in seconds, must be a multiple or a divisor of 1006h (communication cycle period), if both are not 0.",
    why: "The drive interpolates towards the next target for the time in 60C2h, but the next target arrives with SYNC. If the times differ, the axis stutters.",
    example: "`DefaultValue=3` in `[60C2sub1]` and `-3` in `[60C2sub2]`, which is 3 ms, and `DefaultValue=2000` in `[1006]`",
    remedy: "Set both to the same time.",
    source: "CiA 402-2, interpolation time period; CiA 301 §7.5.2.6",

    "cia402/reserved-value" = RESERVED_VALUE, Warning, Drive(reserved_value);
    summary: "an option or bit of a drive is reserved",
    checks: "605Dh (halt option code) must not be 0, which only version 2 defines. Bits 0 to 5 of 607Eh (polarity) must be 0. Both apply to configured and default values.",
    why: "The drive rejects the value or reacts in an undefined way. In 607Eh, mostly 1 was written to invert the direction, but bit 7 inverts positions and bit 6 velocities.",
    example: "`DefaultValue=1` in `[607E]`",
    remedy: "Write 1 to 4 to 605Dh, and 0, 64, 128 or 192 to 607Eh.",
    source: "CiA 402-2, halt option code and polarity",

    "cia402/zero-factor" = ZERO_FACTOR, Error, Applied(zero_factor);
    summary: "a factor or resolution of a drive is 0",
    checks: "Sub-indexes 1 and 2 of the factors 604Bh, 604Ch, 608Fh to 6097h and 60A2h must not be 0, configured or by default.",
    why: "The drive divides by one sub-index and multiplies by the other. With 0 it cannot compute positions.",
    example: "`DefaultValue=0` in `[6091sub2]`",
    remedy: "Write 1 for no scaling, or remove the default if the value depends on the motor.",
    source: "CiA 402-2, factor group",

    "cia402/zero-speed" = ZERO_SPEED, Note, Drive(zero_speed);
    summary: "a speed, a ramp or a torque of a drive is 0",
    checks: "The speeds, ramps and torques that the modes of 6502h need must not be 0: 6048h, 6046h sub-index 2, the speeds of 6049h and 604Ah, 6081h, 6083h, 6084h, 6087h, 6099h, 609Ah, 60C2h and 607Fh (max profile velocity). Position modes also need 6065h (following error window). For all modes, 6072h, 6073h, 6075h, 6076h, 6085h, 60E0h and 60E1h must not be 0. The rule reports one finding per axis. A configured value is a warning; a default is a note, because a master may write a different value first. 6065h, 607Fh and 60C2h are always a note, because some drives interpret 0 as no limit or no interpolation. Other limits of speeds and accelerations are not checked.",
    why: "The axis accepts the command but does not move or has no torque.",
    example: "`[6081]` with `ParameterValue=0`, and profile position mode in 6502h",
    remedy: "Write the value of the machine.",
    source: "CiA 402-2, the object descriptions of the modes",
}

fn enabled_by_default(drive: Drive<'_>, findings: &mut Findings) {
    let Some(command) = drive.value(0x6040, 0).filter(|command| command & 0x8F == 0x0F) else { return };
    let message = say!("the controlword `0x{:04X}` enables the operation at power-on", command);
    let finding = ENABLED_BY_DEFAULT.at(drive.value_place(0x6040, 0), message);
    findings.push(finding.help("write 0, and let the master enable the operation"));
}

fn interpolation_time_differs(drive: Drive<'_>, findings: &mut Findings) {
    let (Some(value), Some(index)) = (drive.value(0x60C2, 1), drive.value(0x60C2, 2)) else { return };
    let Some(period) = drive.value(0x1006, 0).filter(|&period| period > 0) else { return };
    let Some(time) = microseconds(value, index).filter(|&time| time > 0) else { return };
    if period % time == 0 || time % period == 0 {
        return;
    }
    let message = say!(
        "the interpolation time of {} is {} µs, but the SYNC period is `{}` µs",
        drive.name(0x60C2),
        time,
        period
    );
    let finding = INTERPOLATION_TIME_DIFFERS.at(drive.value_place(0x60C2, 1), message);
    let finding = finding.label(drive.value_place(0x1006, 0), "the SYNC period");
    findings.push(finding.help("set both to the same time"));
}

fn reserved_value(drive: Drive<'_>, findings: &mut Findings) {
    let mut report = |index, message| {
        let help = if index == 0x607E {
            "use bit 7 to invert positions and bit 6 to invert velocities"
        } else {
            "write 1 (slow down ramp) to 4 (voltage limit)"
        };
        findings.push(RESERVED_VALUE.at(drive.value_place(index, 0), message).help(help));
    };
    if drive.value(0x605D, 0) == Some(0) {
        report(0x605D, say!("the halt option code of {} is `0`, which is reserved", drive.name(0x605D)));
    }
    if let Some(polarity) = drive.value(0x607E, 0).filter(|polarity| polarity & 0x3F != 0) {
        report(
            0x607E,
            say!("the polarity `0x{:02X}` sets reserved bits of {}", polarity, drive.name(0x607E)),
        );
    }
}

/// The time in microseconds for a value in seconds and a power of ten; `None` below a microsecond and above
/// all periods.
fn microseconds(value: i128, index: i128) -> Option<i128> {
    let power = u32::try_from(index + 6).ok().filter(|&power| power <= 12)?;
    Some(value * 10i128.pow(power))
}

fn zero_factor(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for index in [0x604B, 0x604C].into_iter().chain(0x608F..=0x6097).chain([0x60A2]) {
        let name = applied.profile.object(index).map_or("", |facts| facts.name);
        for sub in [1, 2].into_iter().filter(|&sub| drive.value(index, sub) == Some(0)) {
            let message = say!("{} ({}) is a ratio, but has the value `0`", drive.name(index), name);
            let finding = ZERO_FACTOR.at(drive.value_place(index, sub), message);
            findings.push(finding.help("write 1 for no scaling"));
        }
    }
}

/// The modes that follow a position: profile, interpolated and cyclic synchronous.
const POSITION_MODES: u32 = 1 << 0 | 1 << 6 | 1 << 7;

/// The objects in which 0 disables a limit or the interpolation of some drives.
const MAYBE_OFF: [u16; 3] = [0x6065, 0x607F, 0x60C2];

/// The values that must not be 0, with the modes that need them as bits of 6502h; 0 for all modes.
const NON_ZERO_VALUES: [(u16, u8, u32, &str); 22] = [
    (0x6046, 2, 1 << 1, "vl velocity max amount"),
    (0x6048, 1, 1 << 1, "vl velocity acceleration"),
    (0x6048, 2, 1 << 1, "vl velocity acceleration"),
    (0x6049, 1, 1 << 1, "vl velocity deceleration"),
    (0x604A, 1, 1 << 1, "vl velocity quick stop"),
    (0x6065, 0, POSITION_MODES, "following error window"),
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

fn zero_speed(drive: Drive<'_>, findings: &mut Findings) {
    let modes = drive.modes().unwrap_or(0);
    let zeros = NON_ZERO_VALUES.iter().filter(|&&(index, sub, needed, _)| {
        (needed == 0 || modes & needed != 0) && drive.value(index, sub) == Some(0)
    });
    let is_configured = |&(index, sub, ..): &(u16, u8, u32, &str)| {
        let entry = drive.object(index).and_then(|object| object.entry(sub));
        !MAYBE_OFF.contains(&index) && entry.is_some_and(|entry| entry.configured_value().is_some())
    };
    for zero in zeros {
        let &(index, sub, _, name) = zero;
        let finding = ZERO_SPEED.at(drive.value_place(index, sub), say!("the {} is `0`", name));
        let finding = finding.help("write a value that fits the machine");
        // a value that was configured is certain
        findings.push(if is_configured(zero) { finding.severity(Severity::Warning) } else { finding });
    }
}
