//! The limits of a drive: positions, speeds and set-points.

use crate::Drive;
use crate::diagnostic::{Findings, Severity, say};
use crate::rule::rules;

rules! {
    "cia402/limit-min-above-max" = LIMIT_MIN_ABOVE_MAX, Error, Drive(limit_min_above_max);
    summary: "no position or speed is between the limits of a drive",
    checks: "Sub-index 1 of 607Bh (position range limit), 607Dh (software position limit) and 6046h (vl velocity min max amount) must not be greater than sub-index 2, configured or by default. Two equal positions other than 0 are a warning.",
    why: "No position is between the limits: depending on the vendor, the drive rejects every target or treats the limits as disabled.",
    example: "`DefaultValue=1000` in `[607Dsub1]`, `DefaultValue=-1000` in `[607Dsub2]`",
    remedy: "Swap the values, or write the limits of the machine. If both limits are 0, many drives disable them, so they are not reported.",
    source: "CiA 402-2, IEC 61800-7-201",

    "cia402/limit-outside-range" = LIMIT_OUTSIDE_RANGE, Warning, Drive(limit_outside_range);
    summary: "a software limit is outside the position range",
    checks: "The limits of 607Dh (software position limit) must be within 607Bh (position range limit), if both have a lower limit below the upper one.",
    why: "Positions wrap at the end of the range before they reach the limit, so the limit never stops the axis.",
    example: "`DefaultValue=100000` in `[607Dsub2]`, `DefaultValue=36000` in `[607Bsub2]`",
    remedy: "Move the software limit into the range, or widen the range.",
    source: "CiA 402-2, position range limit and software position limit",

    "cia402/set-point-above-limit" = SET_POINT_ABOVE_LIMIT, Warning, Drive(set_point_above_limit);
    summary: "a set-point of a drive is above its limit",
    checks: "Set-points must not be above their limits, configured or by default. The limit is 607Fh (max profile velocity) for 6081h and 60FFh (profile and target velocity), 60C5h for 6083h and 609Ah (profile and homing acceleration) and 60C6h for 6084h and 6085h (profile and quick stop deceleration). It is 6072h (max torque) for 6071h, 60E0h and 60E1h (target torque and torque limits), and sub-index 2 of 6046h for 6042h (vl target velocity). A limit of 0 or without a value is ignored.",
    why: "The drive moves more slowly than configured or rejects the set-point.",
    example: "`DefaultValue=5000` in `[6081]`, `DefaultValue=3000` in `[607F]`",
    remedy: "Lower the set-point, or increase the limit.",
    source: "CiA 402-2, IEC 61800-7-201",

    "cia402/target-outside-limits" = TARGET_OUTSIDE_LIMITS, Warning, Drive(target_outside_limits);
    summary: "a target position is outside the limits of the axis",
    checks: "The configured or default value of 607Ah (target position) must be within 607Dh (software position limit) and 607Bh (position range limit), if the lower limit is below the upper one.",
    why: "The axis stops at the limit or rejects the first set-point.",
    example: "`DefaultValue=5000` in `[607A]`, `DefaultValue=1000` in `[607Dsub2]`",
    remedy: "Correct the target or the limits.",
    source: "CiA 402-2, target position and software position limit",

    "cia402/value-beyond-support" = VALUE_BEYOND_SUPPORT, Warning, Drive(value_beyond_support);
    summary: "a value exceeds the limit in a related sub-index or object",
    checks: "The actual buffer size of 60C4h (sub-index 2) must be at most the maximum (sub-index 1). 60A4h must have at least as many jerks as 60A3h specifies. Each digital output that 60FEh switches on (sub-index 1) must be enabled in the bit mask (sub-index 2). The mask must not be 0 if it is configured, or if an RPDO maps the outputs without the mask.",
    why: "The drive rejects the size of the buffer or has no value for a jerk. An output that the mask does not enable stays off.",
    example: "`DefaultValue=0x00010000` in `[60FEsub1]`, and `DefaultValue=0` in `[60FEsub2]`",
    remedy: "Correct one of the two values.",
    source: "CiA 402-2, interpolation data configuration, profile jerk and digital outputs",
}

fn limit_min_above_max(drive: Drive<'_>, findings: &mut Findings) {
    for index in [0x607B, 0x607D, 0x6046] {
        let (Some(min), Some(max)) = (drive.value(index, 1), drive.value(index, 2)) else { continue };
        // a speed may be fixed, and two limits of 0 usually mean that they are disabled
        let is_one_position = min == max && min != 0 && index != 0x6046;
        let (message, help, severity) = if min > max {
            let message =
                say!("the lower limit `{}` of {} is above the upper limit `{}`", min, drive.name(index), max);
            (message, "swap the values", Severity::Error)
        } else if is_one_position {
            let message = say!("both limits of {} are `{}`: no movement is possible", drive.name(index), min);
            (message, "write the limits of the machine, or 0 to both", Severity::Warning)
        } else {
            continue;
        };
        let finding = LIMIT_MIN_ABOVE_MAX.at(drive.value_place(index, 1), message).severity(severity);
        findings.push(finding.label(drive.value_place(index, 2), "the upper limit").help(help));
    }
}

fn limit_outside_range(drive: Drive<'_>, findings: &mut Findings) {
    let limits =
        |index| Some((drive.value(index, 1)?, drive.value(index, 2)?)).filter(|(min, max)| min < max);
    let (Some((first, last)), Some((min, max))) = (limits(0x607B), limits(0x607D)) else { return };
    let outside = if !(first..=last).contains(&max) {
        (2, max)
    } else if min < first {
        (1, min)
    } else {
        return;
    };
    let (sub, limit) = outside;
    let message = say!(
        "the limit `{}` of {} is outside the range {} to {} of {}",
        limit,
        drive.name(0x607D),
        first,
        last,
        drive.name(0x607B)
    );
    let finding = LIMIT_OUTSIDE_RANGE.at(drive.value_place(0x607D, sub), message);
    let finding = finding.label(drive.value_place(0x607B, sub), "the position range");
    findings.push(finding.help("move the limit into the range or widen the range"));
}

/// A set-point, its limit with the sub-index and the name of the set-point.
const SET_POINT_LIMITS: [(u16, (u16, u8), &str); 10] = [
    (0x6042, (0x6046, 2), "vl target velocity"),
    (0x6081, (0x607F, 0), "profile velocity"),
    (0x60FF, (0x607F, 0), "target velocity"),
    (0x6083, (0x60C5, 0), "profile acceleration"),
    (0x609A, (0x60C5, 0), "homing acceleration"),
    (0x6084, (0x60C6, 0), "profile deceleration"),
    (0x6085, (0x60C6, 0), "quick stop deceleration"),
    (0x6071, (0x6072, 0), "target torque"),
    (0x60E0, (0x6072, 0), "positive torque limit"),
    (0x60E1, (0x6072, 0), "negative torque limit"),
];

fn set_point_above_limit(drive: Drive<'_>, findings: &mut Findings) {
    for (index, (limit_index, sub), name) in SET_POINT_LIMITS {
        let (Some(value), Some(limit)) = (drive.value(index, 0), drive.value(limit_index, sub)) else {
            continue;
        };
        if limit <= 0 || value.abs() <= limit {
            continue;
        }
        let message = say!("the {} `{}` is above its limit `{}`", name, value, limit);
        let finding = SET_POINT_ABOVE_LIMIT.at(drive.value_place(index, 0), message);
        let finding = finding.label(drive.value_place(limit_index, sub), "the limit");
        findings.push(finding.help("lower the set-point or raise the limit"));
    }
}

fn target_outside_limits(drive: Drive<'_>, findings: &mut Findings) {
    let Some(target) = drive.value(0x607A, 0) else { return };
    for (index, name) in [(0x607D, "software limits"), (0x607B, "position range")] {
        let (Some(min), Some(max)) = (drive.value(index, 1), drive.value(index, 2)) else { continue };
        if min >= max || (min..=max).contains(&target) {
            continue;
        }
        let sub = if target < min { 1 } else { 2 };
        let message = say!(
            "the target position `{}` is outside the {} {} to {} of {}",
            target,
            name,
            min,
            max,
            drive.name(index)
        );
        let finding = TARGET_OUTSIDE_LIMITS.at(drive.value_place(0x607A, 0), message);
        let finding = finding.label(drive.value_place(index, sub), "the limit");
        findings.push(finding.help("correct the target or the limits"));
        return;
    }
}

fn value_beyond_support(drive: Drive<'_>, findings: &mut Findings) {
    let values = |index| Some((drive.value(index, 1)?, drive.value(index, 2)?));
    if let Some((maximum, actual)) = values(0x60C4).filter(|(maximum, actual)| actual > maximum) {
        let message = say!("the buffer size `{}` is above the maximum `{}`", actual, maximum);
        let finding = VALUE_BEYOND_SUPPORT.at(drive.value_place(0x60C4, 2), message);
        let finding = finding.label(drive.value_place(0x60C4, 1), "the maximum");
        findings.push(finding.help("lower the buffer size"));
    }
    let jerks = drive.object(0x60A4).and_then(crate::model::Object::highest_sub);
    if let (Some(used), Some(jerks)) = (drive.value(0x60A3, 0), jerks)
        && used > jerks.into()
    {
        let message = say!("the profile uses {} jerks, but {} has {}", used, drive.name(0x60A4), jerks);
        let finding = VALUE_BEYOND_SUPPORT.at(drive.value_place(0x60A3, 0), message);
        let finding = finding.label(drive.value_place(0x60A4, 0), "the number of jerks");
        findings.push(finding.help("describe the jerks, or use fewer"));
    }
    if let Some((outputs, mask)) = values(0x60FE).filter(|(outputs, mask)| outputs & !mask != 0) {
        let message = say!(
            "{} switches on outputs (`0x{:08X}`) that the bit mask `0x{:08X}` does not enable",
            drive.name(0x60FE),
            outputs & !mask,
            mask
        );
        let finding = VALUE_BEYOND_SUPPORT.at(drive.value_place(0x60FE, 1), message);
        let finding = finding.label(drive.value_place(0x60FE, 2), "the bit mask");
        findings.push(finding.help("enable the outputs in the bit mask, or switch them off"));
    } else if drive.value(0x60FE, 2) == Some(0) && is_mask_in_use(drive) {
        let message = say!("the bit mask of {} is `0`, so no digital output can be set", drive.name(0x60FE));
        let finding = VALUE_BEYOND_SUPPORT.at(drive.value_place(0x60FE, 2), message);
        findings.push(finding.help("set the bits of the outputs"));
    }
}

/// Whether the bit mask of the digital outputs is configured, or PDOs set the outputs but not the mask.
fn is_mask_in_use(drive: Drive<'_>) -> bool {
    let mask = drive.object(0x60FE).and_then(|object| object.entry(2));
    mask.is_some_and(|mask| mask.configured_value().is_some())
        || drive.is_received(0x60FE, 1) && !drive.is_received(0x60FE, 2)
}
