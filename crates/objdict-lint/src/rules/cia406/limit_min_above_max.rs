use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia406/limit-min-above-max", Warning, Applied(check);
    summary: "the lower limit of an encoder is above the upper limit",
    checks: "Whether 6401h (work area low limit) is not above 6402h (high limit), channel by channel, and sub-index 2 of 650Ah (minimum position) not above sub-index 3 (maximum position), configured or default.",
    why: "The encoder is outside its work area at every position.",
    example: "`[6401sub1]` with `DefaultValue=2000`, `[6402sub1]` with `DefaultValue=1000`",
    remedy: "Exchange the limits.",
    source: "CiA 406 (6401h, 6402h, 650Ah)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
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
            let finding = Diagnostic::new(rule, device.value_place(low.0, low.1), message);
            let finding = finding.label(device.value_place(high.0, high.1), "the upper limit");
            findings.push(finding.help("exchange the limits"));
        }
    }
}
