//! The measuring range of an encoder: resolution, revolutions, preset and limits.

use crate::Facts;
use crate::demands::Applied;
use crate::diagnostic::{Findings, Fix, say};
use crate::model::DeviceKind;
use crate::profile::{device_type_index, index_in};
use crate::rule::rules;

rules! {
    "cia406/different-measuring-range" = DIFFERENT_MEASURING_RANGE, Warning,
        Applied(different_measuring_range), fix Unsafe;
    summary: "the measuring range is not the product of resolution and revolutions",
    checks: "In the EDS of a rotary encoder, the default of 6002h must be the resolution (6501h) times the revolutions (6502h). Products above 32 bits are not compared.",
    why: "Scaling is off by default, so the measuring range must be the physical one.",
    example: "`[6501]` with `DefaultValue=8192`, `[6502]` with `DefaultValue=4096`, `[6002]` with `DefaultValue=4096`",
    remedy: "Write the product, in the description and in the device.",
    source: "CiA 406 (6002h, 6501h, 6502h)",

    "cia406/limit-min-above-max" = LIMIT_MIN_ABOVE_MAX, Warning, Applied(limit_min_above_max);
    summary: "the lower limit of an encoder is above the upper limit",
    checks: "6401h (work area low limit) must not be above 6402h (high limit), channel by channel. Sub-index 2 of 650Ah (minimum position) must not be above sub-index 3 (maximum position). The rule checks configured and default values.",
    why: "The encoder is outside its work area at every position.",
    example: "`[6401sub1]` with `DefaultValue=2000`, `[6402sub1]` with `DefaultValue=1000`",
    remedy: "Swap the limits.",
    source: "CiA 406 (6401h, 6402h, 650Ah)",

    "cia406/position-too-long" = POSITION_TOO_LONG, Warning, Applied(position_too_long);
    summary: "the positions of an encoder do not fit into 32 bits",
    checks: "In a rotary encoder, resolution (6501h) times revolutions (6502h) must be at most 2^32, unless it has a position of high precision (6008h).",
    why: "The position wraps to 0 before the encoder reaches its number of revolutions.",
    example: "`[6501]` with `DefaultValue=0x01000000`, `[6502]` with `DefaultValue=4096`: 36 bits",
    remedy: "Correct resolution or revolutions, or offer 6008h.",
    source: "CiA 406 (6004h, 6008h, 6501h, 6502h)",

    "cia406/preset-outside-range" = PRESET_OUTSIDE_RANGE, Warning, Applied(preset_outside_range);
    summary: "the preset of an encoder is outside the measuring range",
    checks: "6003h (preset value) must be from 0 to one less than 6002h (measuring range), configured or by default. A measuring range of 0 has its own rule.",
    why: "Positions are smaller than the measuring range, so the encoder rejects the preset or shows a different position.",
    example: "`[6002]` with `DefaultValue=4096`, `[6003]` with `DefaultValue=5000`",
    remedy: "Write a preset inside the measuring range.",
    source: "CiA 406 (6002h, 6003h)",

    "cia406/revolutions-of-single-turn" = REVOLUTIONS_OF_SINGLE_TURN, Warning,
        Applied(revolutions_of_single_turn);
    summary: "the number of revolutions contradicts the type of the encoder",
    checks: "6502h must be 1 in an encoder of type 1 (absolute, single-turn) and above 1 in an encoder of type 2 (absolute, multi-turn). Type 3 is not checked because it counts revolutions.",
    why: "Either the type is wrong, or a master that multiplies resolution and revolutions computes a wrong measuring range.",
    example: "`[1000]` with `DefaultValue=0x00010196`, `[6502]` with `DefaultValue=4096`",
    remedy: "Correct the type in 1000h or the revolutions in 6502h.",
    source: "CiA 406 (1000h, 6502h)",

    "cia406/value-beyond-resolution" = VALUE_BEYOND_RESOLUTION, Warning, Applied(value_beyond_resolution);
    summary: "a setting of an encoder exceeds its resolution",
    checks: "6001h (measuring units per revolution) must not be above 6501h (resolution). Without 6002h (measuring range), 6003h (preset value) must be below 6501h times 6502h (revolutions). The rule checks configured and default values. Values of 0 have other rules.",
    why: "The encoder cannot resolve the units, so it rejects the value or omits positions.",
    example: "`[6501]` with `DefaultValue=8192`, `[6001]` with `ParameterValue=10000`",
    remedy: "Write a value that the encoder can resolve.",
    source: "CiA 406 (6001h, 6003h, 6501h, 6502h)",

    "cia406/zero-resolution" = ZERO_RESOLUTION, Error, Applied(zero_resolution);
    summary: "a resolution or a range of an encoder is 0",
    checks: "6501h (resolution), 6001h and 6002h (units per revolution and measuring range) and the measuring steps of 6005h must not be 0, configured or by default. In a rotary encoder, the same applies to 6502h (revolutions).",
    why: "A master computes positions with these values and divides by some of them. An encoder without a step or a revolution measures nothing.",
    example: "`[6501]` with `DefaultValue=0`",
    remedy: "Write the value of the encoder; a single-turn encoder has one revolution.",
    source: "CiA 406 (6001h, 6002h, 6005h, 6501h, 6502h)",
}

fn different_measuring_range(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let turns = value(device_type_index(device, block)).is_some_and(|kind| (1..=5).contains(&(kind >> 16)));
    let [range, resolution, revolutions] = [0x6002, 0x6501, 0x6502].map(|index| index_in(block, index));
    let all = (value(range), value(resolution), value(revolutions));
    let (Some(stated), Some(steps), Some(turned)) = all else { return };
    let right = steps * turned;
    // another rule reports a value of 0
    let is_comparable =
        stated > 0 && right > 0 && turns && device.kind == DeviceKind::Type && u32::try_from(right).is_ok();
    if is_comparable && stated != right {
        let message = say!(
            "the measuring range is `{}`, but {} steps times {} revolutions is {}",
            stated,
            steps,
            turned,
            right
        );
        let place = device.value_place(range, 0);
        let finding = DIFFERENT_MEASURING_RANGE.at(place.clone(), message);
        let finding = finding.label(device.value_place(resolution, 0), "steps per revolution");
        let finding = finding.label(device.value_place(revolutions, 0), "revolutions");
        let finding = finding.help(say!("write {}", right));
        findings.push(finding.fix(Fix::risky(say!("write `{}`", right)).set(place, right.to_string())));
    }
}

fn limit_min_above_max(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let areas = (1..=254).map(|sub| ((at(0x6401), sub), (at(0x6402), sub)));
    let highest = device.object(at(0x6401)).and_then(crate::model::Object::highest_sub).unwrap_or(0);
    let areas = areas.take(highest.into());
    for (low, high) in areas.chain([((at(0x650A), 2), (at(0x650A), 3))]) {
        let value = |(index, sub): (u16, u8)| device.object(index)?.value(sub)?.as_integer();
        let (Some(min), Some(max)) = (value(low), value(high)) else { continue };
        if min > max {
            let message = say!("the lower limit `{}` is above the upper limit `{}`", min, max);
            let finding = LIMIT_MIN_ABOVE_MAX.at(device.value_place(low.0, low.1), message);
            let finding = finding.label(device.value_place(high.0, high.1), "the upper limit");
            findings.push(finding.help("swap the limits"));
        }
    }
}

/// The number of positions that 32 bits can distinguish.
const POSITIONS_OF_32_BITS: i128 = 1 << 32;

fn position_too_long(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let [resolution, revolutions] = [0x6501, 0x6502].map(|index| index_in(block, index));
    let turns = value(device_type_index(device, block)).is_some_and(|kind| (1..=5).contains(&(kind >> 16)));
    let is_longer = device.objects.contains_key(&index_in(block, 0x6008));
    let (Some(steps), Some(turned)) = (value(resolution), value(revolutions)) else { return };
    if turns && !is_longer && steps * turned > POSITIONS_OF_32_BITS {
        let message = say!("{} steps times {} revolutions exceeds a 32-bit position", steps, turned);
        let finding = POSITION_TOO_LONG.at(device.value_place(revolutions, 0), message);
        let finding = finding.label(device.value_place(resolution, 0), "steps per revolution");
        findings
            .push(finding.help("correct resolution or revolutions, or add 6008h (high precision position)"));
    }
}

fn preset_outside_range(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let [range, preset] = [0x6002, 0x6003].map(|index| index_in(applied.block, index));
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let (Some(units), Some(position)) = (value(range), value(preset)) else { return };
    if units > 0 && !(0..units).contains(&position) {
        let message = say!("the preset `{}` is outside the measuring range of `{}` units", position, units);
        let finding = PRESET_OUTSIDE_RANGE.at(device.value_place(preset, 0), message);
        let finding = finding.label(device.value_place(range, 0), "the measuring range");
        findings.push(finding.help(say!("write a preset from 0 to {}", units - 1)));
    }
}

fn revolutions_of_single_turn(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let (device_type, index) = (device_type_index(device, block), index_in(block, 0x6502));
    let (Some(kind), Some(revolutions)) = (value(device_type), value(index)) else { return };
    // in a template without the values of a device, the resolution is also 1
    let has_steps = value(index_in(block, 0x6501)) != Some(1);
    let (message, label, help) = match (kind >> 16, revolutions) {
        (1, 2..) => (
            say!("a single-turn encoder has `{}` revolutions", revolutions),
            "type 1, single-turn",
            "write 1 or the type of a multi-turn encoder",
        ),
        (2, 1) if has_steps => (
            "a multi-turn encoder has only `1` revolution".into(),
            "type 2, multi-turn",
            "write the number of revolutions or the type of a single-turn encoder",
        ),
        _ => return,
    };
    let finding = REVOLUTIONS_OF_SINGLE_TURN.at(device.value_place(index, 0), message);
    findings.push(finding.label(device.value_place(device_type, 0), label).help(help));
}

fn value_beyond_resolution(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let value = |index: u16| device.object(at(index))?.value(0)?.as_integer().filter(|&value| value > 0);
    let Some(resolution) = value(0x6501) else { return };
    let mut report = |index: u16, message| {
        let finding = VALUE_BEYOND_RESOLUTION.at(device.value_place(at(index), 0), message);
        let finding = finding.label(device.value_place(at(0x6501), 0), "the resolution");
        findings.push(finding.help("write a value that the encoder can resolve"));
    };
    if let Some(units) = value(0x6001).filter(|&units| units > resolution) {
        report(0x6001, say!("`{}` units per revolution are more than the {} steps", units, resolution));
    }
    let steps = resolution * value(0x6502).unwrap_or(1);
    if let Some(preset) = value(0x6003).filter(|&preset| preset >= steps && value(0x6002).is_none()) {
        report(0x6003, say!("the preset `{}` exceeds the encoder's {} steps", preset, steps));
    }
}

/// The values that must not be 0, and whether only rotary encoders have them.
const NON_ZERO_VALUES: [(u16, u8, bool, &str); 6] = [
    (0x6501, 0, false, "the resolution"),
    (0x6502, 0, true, "the number of revolutions"),
    (0x6001, 0, true, "the number of measuring units per revolution"),
    (0x6002, 0, false, "the measuring range"),
    (0x6005, 1, false, "the position step"),
    (0x6005, 2, false, "the speed step"),
];

fn zero_resolution(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16, sub: u8| device.object(index)?.value(sub)?.as_integer();
    let is_rotary =
        value(device_type_index(device, block), 0).is_some_and(|kind| (1..=5).contains(&(kind >> 16)));
    let zeros = NON_ZERO_VALUES.iter().filter_map(|&(index, sub, of_rotary, name)| {
        let index = index_in(block, index);
        let is_zero = value(index, sub) == Some(0) && (is_rotary || !of_rotary);
        is_zero.then(|| (device.value_place(index, sub), name))
    });
    for (place, name) in zeros {
        let finding = ZERO_RESOLUTION.at(place, say!("{} is `0`", name));
        findings.push(finding.help("write the encoder's value"));
    }
}
