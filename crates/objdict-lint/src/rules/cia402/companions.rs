//! Objects of a drive that need each other.

use crate::demands::Applied;
use crate::diagnostic::{Findings, Text, say, series};
use crate::rule::rules;
use crate::{Drive, Facts};

rules! {
    "cia402/incomplete-touch-probe" = INCOMPLETE_TOUCH_PROBE, Warning, Drive(incomplete_touch_probe);
    summary: "the description of a touch probe is incomplete",
    checks: "If 60B8h (touch probe function), 60B9h (touch probe status) or one of 60BAh to 60BDh (positions of touch probes) is described, both 60B8h and 60B9h must be described.",
    why: "Without the function the probe cannot be enabled. Without the status a master cannot know that the position was sampled.",
    example: "`[60B8]` and `[60BA]` without `[60B9]`",
    remedy: "Describe the missing object.",
    source: "CiA 402-2, touch probe",

    "cia402/interpolation-without-data" = INTERPOLATION_WITHOUT_DATA, Warning,
        Drive(interpolation_without_data);
    summary: "interpolation is supported without its data record or its time",
    checks: "If 6502h indicates interpolated position mode, the drive must have 60C1h (interpolation data record) and 60C2h (interpolation time period). A drive with 60C0h (interpolation sub mode select) or 60C4h (interpolation data configuration) must have 60C1h. A missing 60C0h is named together with the others.",
    why: "A master writes the set-points to the data record and the time between two of them to 60C2h. Without them the drive cannot interpolate.",
    example: "`DefaultValue=0x00000041` in `[6502]`, without `[60C1]` and `[60C2]`",
    remedy: "Describe the objects, or clear bit 6 of 6502h.",
    source: "CiA 402-2, interpolated position mode",

    "cia402/notation-without-dimension" = NOTATION_WITHOUT_DIMENSION, Warning,
        Drive(notation_without_dimension);
    summary: "only one of notation index and dimension index is described",
    checks: "If one of the two unit objects of version 2 is described, the other must be described too: 6089h and 608Ah for positions, 608Bh and 608Ch for velocities, 608Dh and 608Eh for accelerations.",
    why: "The notation index is a power of ten and the dimension index is a unit: neither is meaningful without the other.",
    example: "`[6089]` without `[608A]`",
    remedy: "Describe the other object, or use 60A8h to 60ABh of version 4.",
    source: "CiA 402 version 2, factor group",

    "cia402/target-without-actual-value" = TARGET_WITHOUT_ACTUAL_VALUE, Warning,
        Applied(target_without_actual_value);
    summary: "a target is described without its actual value",
    checks: "The actual value of each target must be described: 6044h for 6042h, 6064h for 607Ah, 606Ch for 60FFh, 6077h for 6071h. If 6502h indicates a mode that requires the actual value, `cia402/missing-object` reports it instead.",
    why: "Without the actual value a master cannot monitor the axis or detect that it has reached the target.",
    example: "`[607A]` without `[6064]`",
    remedy: "Describe the actual value.",
    source: "CiA 402-2, IEC 61800-7-201",

    "cia402/time-without-window" = TIME_WITHOUT_WINDOW, Note, Drive(time_without_window);
    summary: "a time is described without its window",
    checks: "If a time is described, its window must be described too: 6065h (following error window) with 6066h (its time out), 6067h (position window) with 6068h, 606Dh (velocity window) with 606Eh, 606Fh (velocity threshold) with 6070h.",
    why: "The time limits how long the value may be outside, or must be inside, a window that cannot be set.",
    example: "`[6068]` without `[6067]`",
    remedy: "Describe the window, or remove the time.",
    source: "CiA 402-2, IEC 61800-7-201",
}

fn incomplete_touch_probe(drive: Drive<'_>, findings: &mut Findings) {
    let Some(there) = (0x60B8..=0x60BD).find(|&index| drive.has(index)) else { return };
    let missing = [(0x60B8, "touch probe function"), (0x60B9, "touch probe status")];
    let missing = missing.into_iter().filter(|&(index, _)| drive.lacks(index));
    let missing: Vec<Text> = missing.map(|(index, name)| say!("{} ({})", drive.name(index), name)).collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("{} is described without {}", drive.name(there), series(&missing));
    findings
        .push(INCOMPLETE_TOUCH_PROBE.at(drive.place(there), message).help("describe the missing objects"));
}

fn interpolation_without_data(drive: Drive<'_>, findings: &mut Findings) {
    let is_stated = drive.supports(6) == Some(true);
    let there = [0x60C0, 0x60C4].into_iter().find(|&index| drive.has(index));
    let lacks_data = drive.lacks(0x60C1) && (is_stated || there.is_some());
    let lacks_time = is_stated && drive.lacks(0x60C2) && !has_cyclic_mode(drive);
    if !lacks_data && !lacks_time {
        return;
    }
    let missing = [(0x60C0, is_stated && drive.lacks(0x60C0)), (0x60C1, lacks_data), (0x60C2, lacks_time)];
    let missing: Vec<Text> = missing.iter().filter(|one| one.1).map(|one| drive.name(one.0)).collect();
    let verb = if missing.len() == 1 { "is" } else { "are" };
    let missing = series(missing);
    let finding = match there.filter(|_| !is_stated) {
        Some(there) => {
            let message =
                say!("{} is described without {} (interpolation data record)", drive.name(there), missing);
            INTERPOLATION_WITHOUT_DATA.at(drive.place(there), message)
        }
        None => {
            let message =
                say!("interpolated position mode is supported, but {} {} missing", missing.clone(), verb);
            INTERPOLATION_WITHOUT_DATA.at(drive.value_place(0x6502, 0), message)
        }
    };
    findings
        .push(finding.help(say!("describe the missing objects, or clear bit 6 of {}", drive.name(0x6502))));
}

/// Whether a cyclic mode requires the time, which another rule checks.
fn has_cyclic_mode(drive: Drive<'_>) -> bool {
    (7..=9).any(|bit| drive.supports(bit) == Some(true))
}

fn notation_without_dimension(drive: Drive<'_>, findings: &mut Findings) {
    for notation in [0x6089, 0x608B, 0x608D] {
        let (there, missing, name) = match (drive.has(notation), drive.has(notation + 1)) {
            (true, false) => (notation, notation + 1, "dimension index"),
            (false, true) => (notation + 1, notation, "notation index"),
            _ => continue,
        };
        if drive.lacks(missing) {
            let (there_name, missing) = (drive.name(there), drive.name(missing));
            let message = say!("{} is described without its {} {}", there_name, name, missing);
            let finding = NOTATION_WITHOUT_DIMENSION.at(drive.place(there), message);
            findings.push(finding.help(say!("describe {}", missing)));
        }
    }
}

const TARGETS: [(u16, u16, &str); 4] = [
    (0x6042, 0x6044, "vl velocity actual value"),
    (0x607A, 0x6064, "position actual value"),
    (0x60FF, 0x606C, "velocity actual value"),
    (0x6071, 0x6077, "torque actual value"),
];

fn target_without_actual_value(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (target, actual, name) in TARGETS {
        if !drive.has(target) || !drive.lacks(actual) || is_demanded(facts, applied, actual) {
            continue;
        }
        let (target_name, actual_name) = (drive.name(target), drive.name(actual));
        let message = say!("{} is described without {} ({})", target_name, actual_name, name);
        let finding = TARGET_WITHOUT_ACTUAL_VALUE.at(drive.place(target), message);
        findings.push(finding.help(say!("describe {}", actual_name)));
    }
}

/// Whether the document requires an object, which another rule checks.
fn is_demanded(facts: &Facts<'_>, applied: &Applied<'_>, index: u16) -> bool {
    let wanted = applied.profile.object(index);
    wanted.is_some_and(|wanted| wanted.is_demanded(facts.device, applied.block))
}

fn time_without_window(drive: Drive<'_>, findings: &mut Findings) {
    for (window, time, name) in [
        (0x6065, 0x6066, "following error window"),
        (0x6067, 0x6068, "position window"),
        (0x606D, 0x606E, "velocity window"),
        (0x606F, 0x6070, "velocity threshold"),
    ] {
        if drive.has(time) && drive.lacks(window) {
            let (time_name, window) = (drive.name(time), drive.name(window));
            let message = say!("{} is described without its {} {}", time_name, name, window);
            let finding = TIME_WITHOUT_WINDOW.at(drive.place(time), message);
            findings.push(finding.help(say!("describe {}", window)));
        }
    }
}
