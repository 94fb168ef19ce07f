use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::{Facts, rule};

rule! {
    "cia304/invalid-time", Error, Facts(check);
    summary: "the times of an SRDO cannot be kept",
    checks: "Whether the refresh time (SCT of one that is received) and the validation time (SRVT) of each SRDO that has a direction are not 0, and whether the validation time is not longer than the refresh time.",
    why: "The two frames of an SRDO have to come within the validation time, and the next pair within the cycle time. A time of 0 can never be kept; a validation time beyond the cycle lets the frames of two cycles pass as one pair.",
    example: "`[1301sub2]` with `DefaultValue=20` and `[1301sub3]` with `DefaultValue=50`",
    remedy: "Write times in milliseconds; the validation time is the shorter one.",
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
                let message =
                    say!("{} has {} ms to be validated, and its {} is {} ms", srdo, validation, name, cycle);
                let finding = Diagnostic::new(&RULE.info, place(3), message).severity(Severity::Warning);
                finding.label(place(2), say!("the {}", name))
            }
            _ => continue,
        };
        findings.push(finding.help("write times in milliseconds, the validation time the shorter one"));
    }
}
