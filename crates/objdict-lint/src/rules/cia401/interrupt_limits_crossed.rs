use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia401/interrupt-limits-crossed", Warning, Applied(check);
    summary: "the lower interrupt limit of an analogue input is above the upper one",
    checks: "Whether 6425h and 642Bh (lower limits) are not above 6424h and 642Ah (upper limits), channel by channel.",
    why: "An input raises an event above the upper limit and below the lower one. If the limits are crossed, each value raises an event and the TPDO floods the network.",
    example: "`[6424sub1]` with `DefaultValue=100`, `[6425sub1]` with `DefaultValue=200`",
    remedy: "Exchange the limits.",
    source: "CiA 401 (6424h, 6425h, 642Ah, 642Bh)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for [upper, lower] in [[0x6424, 0x6425], [0x642A, 0x642B]] {
        let [upper, lower] = [upper, lower].map(|index| index_in(applied.block, index));
        let Some(object) = device.object(lower).filter(|_| device.objects.contains_key(&upper)) else {
            continue;
        };
        for (sub, _) in object.stated().filter(|&(sub, _)| sub > 0) {
            let value = |index: u16| device.value(index, sub)?.as_real();
            let (Some(high), Some(low)) = (value(upper), value(lower)) else { continue };
            if low > high {
                let message = say!(
                    "the lower limit `{}` of input {} is above the upper limit `{}`",
                    low.to_string(),
                    sub,
                    high.to_string()
                );
                let finding = Diagnostic::new(rule, device.value_place(lower, sub), message);
                let finding = finding.label(device.value_place(upper, sub), "the upper limit");
                findings.push(finding.help("exchange the limits"));
            }
        }
    }
}
