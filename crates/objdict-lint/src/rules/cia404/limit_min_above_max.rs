use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::Object;
use crate::{Facts, rule, with_others};

rule! {
    "cia404/limit-min-above-max", Error, Applied(check);
    summary: "the lower limit of a channel is above the upper limit",
    checks: "Whether, for each channel, the lower limit of the interrupt (x134h, x144h), the set-point (x404h) and the controller output (6413h) is not greater than the upper limit (x135h, x145h, x405h, 6414h), configured or default.",
    why: "No value is between the limits: the interrupt is always or never active, and the controller cannot follow its set-point.",
    example: "`DefaultValue=1000` in `[7134sub1]`, `DefaultValue=-1000` in `[7135sub1]`",
    remedy: "Swap the values.",
    source: "CiA 404-1, analogue inputs and controllers",
}

/// The lower limits, as offsets from 6000h, 7000h, 8000h or 9000h; the upper one is next to each.
const LOWER: [u16; 3] = [0x134, 0x144, 0x404];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, _: &Applied<'_>, findings: &mut Findings) {
    let families = [0x6000, 0x7000, 0x8000, 0x9000];
    let pairs = families.iter().flat_map(|family| LOWER.map(|offset| family + offset)).chain([0x6413]);
    for lower in pairs {
        let upper = lower + 1;
        let (Some(low), Some(high)) = (facts.device.object(lower), facts.device.object(upper)) else {
            continue;
        };
        let number = |object: &Object, sub| object.value(sub).and_then(|value| value.as_real());
        let crossed = |&sub: &u8| matches!((number(low, sub), number(high, sub)), (Some(low), Some(high)) if low > high);
        let channels: Vec<u8> = (1..=199).filter(crossed).collect();
        let Some(&first) = channels.first() else { continue };
        let message = say!(
            "the lower limit `{}` of {:04X}h is above the upper limit `{}` of {:04X}h",
            number(low, first).unwrap_or_default(),
            lower,
            number(high, first).unwrap_or_default(),
            upper
        );
        let finding = Diagnostic::new(rule, facts.device.value_place(lower, first), message);
        let finding = finding.label(facts.device.value_place(upper, first), "the upper limit");
        let others = channels.iter().skip(1);
        let others = others.map(|&sub| (facts.device.value_place(lower, sub), "also here"));
        findings.push(with_others(finding, others).help("swap the values"));
    }
}
