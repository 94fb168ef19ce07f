use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Facts, rule};

rule! {
    "cia406/cyclic-timer-mismatch", Error, Applied(check);
    summary: "the cyclic timer and the event timer of TPDO 1 differ",
    checks: "Whether 6200h and 1800h sub-index 5 have the same value if both are described.",
    why: "Both objects access one timer, so one of the values is wrong, and the start-up value of the encoder is ambiguous.",
    example: "`[6200]` with `DefaultValue=100`, `[1800sub5]` with `DefaultValue=0`",
    remedy: "Write the same time, in milliseconds.",
    source: "CiA 406 (6200h, 1800h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let value = |index: u16, sub: u8| device.object(index)?.value(sub)?.as_integer();
    let (Some(cyclic), Some(event)) = (value(0x6200, 0), value(0x1800, 5)) else { return };
    if cyclic != event && applied.block == 0 {
        let message =
            say!("the cyclic timer is `{}` ms, but the event timer of TPDO 1 is {} ms", cyclic, event);
        let finding = Diagnostic::new(rule, device.value_place(0x6200, 0), message);
        let finding = finding.label(device.value_place(0x1800, 5), "the same timer");
        findings.push(finding.help("write the same time to both"));
    }
}
