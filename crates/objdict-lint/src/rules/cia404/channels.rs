//! The scaling and limits of a channel.

use crate::Facts;
use crate::demands::{Applied, is_there};
use crate::diagnostic::{Findings, say, series};
use crate::model::{Object, Place};
use crate::rule::rules;

rules! {
    "cia404/incomplete-scaling" = INCOMPLETE_SCALING, Warning, Applied(incomplete_scaling);
    summary: "the scaling of a channel is incomplete",
    checks: "Four objects scale a field value to a process value by two points: x120h to x123h for analogue inputs, x320h to x323h for analogue outputs. If one of the four is described, all must be described.",
    why: "A linear scaling needs two points of two numbers each. If one is missing, the scaling cannot be changed.",
    example: "`[7120]`, `[7121]` and `[7122]` without `[7123]`",
    remedy: "Describe the missing objects.",
    source: "CiA 404-1, analogue inputs and analogue outputs",

    "cia404/limit-min-above-max" = LIMIT_MIN_ABOVE_MAX, Error, Applied(limit_min_above_max);
    summary: "the lower limit of a channel is above the upper limit",
    checks: "For each channel, the lower limit of the interrupt (x134h, x144h), the set-point (x404h) and the controller output (6413h) must not be greater than the upper limit (x135h, x145h, x405h, 6414h), configured or by default.",
    why: "No value is between the limits: the interrupt is always or never active, and the controller cannot follow its set-point.",
    example: "`DefaultValue=1000` in `[7134sub1]`, `DefaultValue=-1000` in `[7135sub1]`",
    remedy: "Swap the values.",
    source: "CiA 404-1, analogue inputs and controllers",
}

fn incomplete_scaling(facts: &Facts<'_>, _: &Applied<'_>, findings: &mut Findings) {
    let families = [0x6000, 0x7000, 0x8000, 0x9000];
    for first in families.iter().flat_map(|family| [family + 0x120, family + 0x320]) {
        let is_described = |index: &u16| is_there(facts.device, *index);
        let Some(there) = (first..=first + 3).find(is_described) else { continue };
        let missing = (first..=first + 3).filter(|index| !is_described(index));
        let missing: Vec<String> = missing.map(|index| format!("{index:04X}h")).collect();
        if missing.is_empty() {
            continue;
        }
        let message = say!("{:04X}h needs {} for a complete scaling", there, series(&missing));
        let finding = INCOMPLETE_SCALING.at(Place::object(there), message);
        findings.push(finding.help("describe the missing objects"));
    }
}

/// The lower limits, as offsets from 6000h, 7000h, 8000h or 9000h; the upper one is next to each.
const LOWER_LIMITS: [u16; 3] = [0x134, 0x144, 0x404];

fn limit_min_above_max(facts: &Facts<'_>, _: &Applied<'_>, findings: &mut Findings) {
    let families = [0x6000, 0x7000, 0x8000, 0x9000];
    let pairs = families.iter().flat_map(|family| LOWER_LIMITS.map(|offset| family + offset)).chain([0x6413]);
    for lower in pairs {
        let upper = lower + 1;
        let (Some(low), Some(high)) = (facts.device.object(lower), facts.device.object(upper)) else {
            continue;
        };
        let number = |object: &Object, sub| object.value(sub).and_then(|value| value.as_real());
        let crossed = |&sub: &u8| matches!((number(low, sub), number(high, sub)), (Some(low), Some(high)) if low > high);
        for sub in (1..=199).filter(crossed) {
            let message = say!(
                "the lower limit `{}` of {:04X}h is above the upper limit `{}` of {:04X}h",
                number(low, sub).unwrap_or_default(),
                lower,
                number(high, sub).unwrap_or_default(),
                upper
            );
            let finding = LIMIT_MIN_ABOVE_MAX.at(facts.device.value_place(lower, sub), message);
            let finding = finding.label(facts.device.value_place(upper, sub), "the upper limit");
            findings.push(finding.help("swap the values"));
        }
    }
}
