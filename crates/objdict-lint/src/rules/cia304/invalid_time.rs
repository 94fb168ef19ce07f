use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::{Facts, rule};

rule! {
    "cia304/invalid-time", Error, Facts(check);
    summary: "the times of an SRDO cannot be met",
    checks: "Whether the refresh time (SCT for a received SRDO) and the validation time (SRVT) of each active SRDO are not 0, and whether the validation time is not longer than the refresh time.",
    why: "The two frames of an SRDO must arrive within the validation time, and the next pair within the cycle time. A time of 0 can never be met; with a validation time longer than the cycle, frames of two cycles are accepted as one pair.",
    example: "`[1301sub2]` with `DefaultValue=20` and `[1301sub3]` with `DefaultValue=50`",
    remedy: "Write times in milliseconds, with the validation time not longer than the refresh time.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in facts.srdos.iter().filter(|srdo| srdo.is_on()) {
        let (cycle, validation) = (srdo.number(2), srdo.number(3));
        let place = |sub| facts.device.value_place(srdo.communication_index(), sub);
        let name = if srdo.number(1) == Some(2) { "safeguard cycle time" } else { "refresh time" };
        let finding = match (cycle, validation) {
            (Some(0), _) => Diagnostic::new(&RULE.info, place(2), say!("the {} of {} is 0 ms", name, srdo)),
            (_, Some(0)) => {
                Diagnostic::new(&RULE.info, place(3), say!("the validation time of {} is 0 ms", srdo))
            }
            (Some(cycle), Some(validation)) if validation > cycle => {
                let message = say!(
                    "the validation time of {} is {} ms, longer than its {} of {} ms",
                    srdo,
                    validation,
                    name,
                    cycle
                );
                let finding = Diagnostic::new(&RULE.info, place(3), message).severity(Severity::Warning);
                finding.label(place(2), say!("the {}", name))
            }
            _ => continue,
        };
        findings.push(finding.help(
            "write times in milliseconds, with a validation time not longer than the refresh time or SCT",
        ));
    }
}
