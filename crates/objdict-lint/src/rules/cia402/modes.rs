//! The modes of operation of a drive.

use crate::demands::Applied;
use crate::diagnostic::{Findings, say, series};
use crate::model::{Field, Value};
use crate::rule::rules;
use crate::{Drive, Facts, MODES};

rules! {
    source: "CiA 402-2, supported drive modes";

    "cia402/cyclic-mode-without-sync" = CYCLIC_MODE_WITHOUT_SYNC, Warning, Applied(cyclic_mode_without_sync);
    summary: "a drive with cyclic modes has no SYNC",
    checks: "If 6502h of a drive indicates a cyclic synchronous mode, the drive must have 1005h, the COB-ID of SYNC.",
    why: "In these modes SYNC synchronizes the interpolation of drive and master. Without 1005h the drive does not know when a target takes effect.",
    example: "`DefaultValue=0x00000080` in `[6502]`, and no `[1005]`",
    remedy: "Add 1005h with the default 80h, or clear the bits of the modes in 6502h.",
    source: "CiA 402-2, cyclic synchronous modes; CiA 301 §7.5.2.5",

    "cia402/homing-method-not-supported" = HOMING_METHOD_NOT_SUPPORTED, Error,
        Drive(homing_method_not_supported);
    summary: "the homing method of a drive is not in its list of supported methods",
    checks: "The configured or default value of 6098h (homing method) must be in 60E3h (supported homing methods), if all entries of that list have a value. 0 (no homing) is not checked.",
    why: "The drive rejects homing with its start-up method.",
    example: "`DefaultValue=17` in `[6098]`, and `[60E3]` with the methods 35 and 37",
    remedy: "Choose a supported method, or complete the list.",
    source: "CiA 402-2, homing method and supported homing methods (version 4)",

    "cia402/mode-not-stated" = MODE_NOT_STATED, Warning, Drive(mode_not_stated);
    summary: "a drive has the objects of a mode that 6502h does not indicate",
    checks: "If the objects that only one mode uses are described, 6502h must have the bit of that mode set: 6042h and 6044h of velocity, 6081h and 607Ah of profile position, 6071h and 6087h of torque, 6098h and 6099h of homing, 60C0h and 60C1h of interpolated position. 60FFh and 606Ch belong to profile velocity or cyclic synchronous velocity. The rule reports one finding per mode, or none if 6502h indicates no mode at all.",
    why: "A master reads 6502h and does not offer the mode although the drive supports it. Otherwise the objects are obsolete and have no effect.",
    example: "`[6098]` and `[6099]`, and `DefaultValue=0x00000001` in `[6502]`",
    remedy: "Set the bit of the mode, or remove its objects. If a file for a family of drives has the objects on purpose, add an `allow` comment.",

    "cia402/mode-outside-limits" = MODE_OUTSIDE_LIMITS, Warning, Drive(mode_outside_limits);
    summary: "the limits of modes of operation exclude a mode that the drive supports",
    checks: "The number of each mode in 6502h (supported drive modes) must be between `LowLimit` and `HighLimit` of 6060h (modes of operation), if they are given.",
    why: "Tools that check values do not write the mode to 6060h.",
    example: "`HighLimit=6` in `[6060]`, and `DefaultValue=0x00000080` in `[6502]`, which is mode 8",
    remedy: "Correct the limits, or clear the bit of the mode.",
    source: "CiA 402-2, modes of operation and supported drive modes",

    "cia402/mode-without-display" = MODE_WITHOUT_DISPLAY, Warning, Drive(mode_without_display);
    summary: "only one of modes of operation and modes of operation display is described",
    checks: "If 6060h (modes of operation) or 6061h (modes of operation display) is described, the other must be described too. `cia402/no-mode-selection` reports a drive with several modes and without 6060h.",
    why: "A drive may change its mode with a delay: a master waits until 6061h shows the mode before it sends targets.",
    example: "`[6060]` without `[6061]`",
    remedy: "Describe the other object.",
    source: "CiA 402-2, modes of operation",

    "cia402/no-drive-mode" = NO_DRIVE_MODE, Warning, Drive(no_drive_mode);
    summary: "6502h indicates no mode",
    checks: "At least one bit of 6502h (supported drive modes) must be set, manufacturer-specific bits included.",
    why: "A master finds no mode that it can use.",
    example: "`DefaultValue=0` in `[6502]`",
    remedy: "Set the bits of the modes that the drive supports.",

    "cia402/no-mode-selection" = NO_MODE_SELECTION, Warning, Drive(no_mode_selection);
    summary: "a drive with several modes has no object to select one",
    checks: "If 6502h of a drive indicates more than one mode of operation, the drive must have 6060h.",
    why: "Without 6060h (modes of operation) a master cannot leave the start-up mode.",
    example: "`DefaultValue=0x00000005` in `[6502]`, and no `[6060]`",
    remedy: "Describe 6060h (INTEGER8, `rw`) and 6061h (INTEGER8, `ro`), or indicate only the mode that is always active.",
    source: "CiA 402-2, modes of operation and supported drive modes",

    "cia402/no-supported-modes" = NO_SUPPORTED_MODES, Warning, Drive(no_supported_modes);
    summary: "a drive does not specify its modes",
    checks: "A drive with the controlword 6040h must have 6502h (supported drive modes).",
    why: "Masters read 6502h before they select a mode, and many do not use an axis without it. The object was optional in version 2 and has been mandatory since version 3. More than a quarter of the real drives examined lack it, so the finding is a warning.",
    example: "`[6040]` without `[6502]`",
    remedy: "Describe 6502h (UNSIGNED32, `ro`) with the bits of the modes.",

    "cia402/reserved-drive-mode" = RESERVED_DRIVE_MODE, Warning, Drive(reserved_drive_mode);
    summary: "6502h has a reserved bit set",
    checks: "Bits 4 and 11 to 15 of 6502h (supported drive modes) must be 0.",
    why: "Bit 4 was never assigned to a mode, and the others are reserved for a later version. Mostly the numbers of modes were used as bit numbers: the bit of homing, mode 6, is 5.",
    example: "`DefaultValue=0x00000010` in `[6502]`",
    remedy: "Set the bits of the modes; the bit number is the mode number minus 1. Manufacturer-specific modes use bits 16 to 31.",

    "cia402/unsupported-mode" = UNSUPPORTED_MODE, Warning, Drive(unsupported_mode);
    summary: "a drive starts in a mode that it does not support",
    checks: "The bit of the configured or default mode in 6060h or 6061h must be set in 6502h. Manufacturer-specific modes (below 0) and 0 (no mode) are not checked.",
    why: "One of the two is wrong. A master that relies on 6502h never uses the mode. A master that relies on 6060h sends targets that the drive rejects.",
    example: "`DefaultValue=8` in `[6060]`, and `DefaultValue=0x00000005` in `[6502]`",
    remedy: "Correct the mode, or set its bit in 6502h.",
    source: "CiA 402-2, modes of operation and supported drive modes",
}

fn cyclic_mode_without_sync(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let cyclic =
        MODES.iter().find(|mode| (7..=10).contains(&mode.bit) && drive.supports(mode.bit) == Some(true));
    let Some(mode) = cyclic.filter(|_| applied.block == 0 && drive.lacks(0x1005)) else { return };
    let message = say!("{} mode is supported, but 1005h (COB-ID SYNC) is missing", mode.name);
    let finding = CYCLIC_MODE_WITHOUT_SYNC.at(drive.value_place(0x6502, 0), message);
    findings.push(finding.help("add 1005h (COB-ID SYNC, UNSIGNED32, default 0x80)"));
}

fn homing_method_not_supported(drive: Drive<'_>, findings: &mut Findings) {
    let Some(method) = drive.value(0x6098, 0).filter(|&method| method != 0) else { return };
    let Some(list) = drive.object(0x60E3) else { return };
    let methods: Option<Vec<i128>> = list
        .entries()
        .filter(|&(sub, _)| sub != 0 && sub != 0xFF)
        .map(|(_, entry)| entry.value().and_then(Value::as_integer))
        .collect();
    let Some(methods) = methods.filter(|methods| !methods.is_empty() && !methods.contains(&method)) else {
        return;
    };
    let message = say!(
        "homing method `{}` is not supported: {} lists {}",
        method,
        drive.name(0x60E3),
        series(methods.iter().take(20))
    );
    let finding = HOMING_METHOD_NOT_SUPPORTED.at(drive.value_place(0x6098, 0), message);
    let finding = finding.label(drive.place(0x60E3), "the supported homing methods");
    findings.push(finding.help("choose a supported method or complete the list"));
}

/// A mode, the objects that only this mode uses and the bits of 6502h of which one must be set.
const OBJECTS_OF_MODES: [(&str, [u16; 2], u32); 6] = [
    ("velocity", [0x6042, 0x6044], 1 << 1),
    ("profile position", [0x607A, 0x6081], 1),
    ("profile velocity or cyclic synchronous velocity", [0x60FF, 0x606C], 1 << 2 | 1 << 8),
    ("torque profile", [0x6071, 0x6087], 1 << 3),
    ("homing", [0x6098, 0x6099], 1 << 5),
    ("interpolated position", [0x60C0, 0x60C1], 1 << 6),
];

fn mode_not_stated(drive: Drive<'_>, findings: &mut Findings) {
    let Some(modes) = drive.modes().filter(|&modes| modes & 0xFFFF != 0) else { return };
    for (mode, objects, bits) in OBJECTS_OF_MODES {
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
        let finding = MODE_NOT_STATED.at(drive.value_place(0x6502, 0), message);
        let finding = finding.label(drive.place(objects[0]), "an object of the mode");
        let help = say!("set bit {} or remove the objects", bits.trailing_zeros());
        findings.push(finding.help(help));
    }
}

fn mode_outside_limits(drive: Drive<'_>, findings: &mut Findings) {
    let Some(entry) = drive.variable(0x6060) else { return };
    let limit = |limit: &Option<Value>| limit.as_ref().and_then(Value::as_integer);
    let (low, high) = (limit(&entry.low_limit), limit(&entry.high_limit));
    // another rule reports limits in the wrong order
    if low.zip(high).is_some_and(|(low, high)| low > high) {
        return;
    }
    for mode in MODES.iter().filter(|mode| drive.supports(mode.bit) == Some(true)) {
        let field = match mode.number {
            number if low.is_some_and(|low| number < low) => Field::LowLimit,
            number if high.is_some_and(|high| number > high) => Field::HighLimit,
            _ => continue,
        };
        let message =
            say!("the limits of {} exclude mode `{}` ({})", drive.name(0x6060), mode.number, mode.name);
        let finding = MODE_OUTSIDE_LIMITS.at(drive.place(0x6060).field(field), message);
        let finding = finding.label(drive.value_place(0x6502, 0), "the supported drive modes");
        findings.push(finding.help(say!("correct the limit, or clear bit {}", mode.bit)));
    }
}

fn mode_without_display(drive: Drive<'_>, findings: &mut Findings) {
    let (there, missing) = match (drive.has(0x6060), drive.has(0x6061)) {
        (true, false) => (0x6060, 0x6061),
        // with several modes the selection is missing, which another rule reports
        (false, true) if !has_several_modes(drive) => (0x6061, 0x6060),
        _ => return,
    };
    if drive.lacks(missing) {
        let name = |index| match index {
            0x6060 => "modes of operation",
            _ => "modes of operation display",
        };
        let message = say!(
            "{} ({}) is described without {} ({})",
            drive.name(there),
            name(there),
            drive.name(missing),
            name(missing)
        );
        let finding = MODE_WITHOUT_DISPLAY.at(drive.place(there), message);
        findings.push(finding.help(say!("describe {}", drive.name(missing))));
    }
}

fn has_several_modes(drive: Drive<'_>) -> bool {
    let modes = drive.modes().unwrap_or_default();
    MODES.iter().filter(|mode| modes >> mode.bit & 1 == 1).count() > 1
}

fn no_drive_mode(drive: Drive<'_>, findings: &mut Findings) {
    if drive.modes() == Some(0) {
        let message = say!("{} states no mode of operation", drive.name(0x6502));
        let finding = NO_DRIVE_MODE.at(drive.value_place(0x6502, 0), message);
        findings.push(
            finding.help("set the bits of the modes, such as `0x00000021` for profile position and homing"),
        );
    }
}

fn no_mode_selection(drive: Drive<'_>, findings: &mut Findings) {
    let modes = drive.modes().unwrap_or_default();
    let names = MODES.iter().filter(|mode| modes >> mode.bit & 1 == 1).map(|mode| mode.name);
    let names: Vec<&str> = names.collect();
    if names.len() < 2 || !drive.lacks(0x6060) {
        return;
    }
    let message = say!("{} is missing, so a master cannot select {}", drive.name(0x6060), series(names));
    let finding = NO_MODE_SELECTION.at(drive.value_place(0x6502, 0), message);
    findings
        .push(finding.help(say!("describe {}, the modes of operation (INTEGER8, `rw`)", drive.name(0x6060))));
}

fn no_supported_modes(drive: Drive<'_>, findings: &mut Findings) {
    if drive.has(0x6040) && drive.lacks(0x6502) {
        let message = say!("{} (supported drive modes) is missing", drive.name(0x6502));
        let finding = NO_SUPPORTED_MODES.at(drive.place(0x6040), message);
        findings.push(
            finding
                .help(say!("describe {} (UNSIGNED32, `ro`) with the bits of the modes", drive.name(0x6502))),
        );
    }
}

const RESERVED_MODES: u32 = 1 << 4 | 0xF800;

fn reserved_drive_mode(drive: Drive<'_>, findings: &mut Findings) {
    let Some(modes) = drive.modes().filter(|modes| modes & RESERVED_MODES != 0) else { return };
    let bits = (0..16u32).filter(|bit| modes & RESERVED_MODES & (1 << bit) != 0);
    let bits: Vec<u32> = bits.collect();
    let plural = if bits.len() == 1 { "bit" } else { "bits" };
    let message =
        say!("the supported drive modes `0x{:08X}` set the reserved {} {}", modes, plural, series(bits));
    let finding = RESERVED_DRIVE_MODE.at(drive.value_place(0x6502, 0), message);
    findings.push(finding.help("use bits 16 to 31 for manufacturer-specific modes"));
}

fn unsupported_mode(drive: Drive<'_>, findings: &mut Findings) {
    for index in [0x6060, 0x6061] {
        let Some(number) = drive.value(index, 0) else { continue };
        let Some(mode) = MODES.iter().find(|mode| mode.number == number) else { continue };
        if drive.supports(mode.bit) != Some(false) {
            continue;
        }
        let (name, modes) = (drive.name(index), drive.name(0x6502));
        let message = say!(
            "{} is `{}` ({}), but {} does not have bit {} set",
            name,
            number,
            mode.name,
            modes,
            mode.bit
        );
        let finding = UNSUPPORTED_MODE.at(drive.value_place(index, 0), message);
        let finding = finding.label(drive.value_place(0x6502, 0), "the supported drive modes");
        findings.push(finding.help("correct the mode or set the bit"));
    }
}
