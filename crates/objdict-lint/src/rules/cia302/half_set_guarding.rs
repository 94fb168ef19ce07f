use crate::demands::Expected;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::rule;

rule! {
    "cia302/half-set-guarding", Warning, Expected(check);
    summary: "the guarding of a slave has a time and no retries, or retries and no time",
    checks: "Whether each entry of 1F81h that is for a slave of this master (bit 0) has a guard time (bits 16 to 31) and a retry factor (bits 8 to 15), or neither.",
    why: "Guarding with one of the two is off, and a node that is gone is not missed.",
    example: "`[1F81sub5]` with `DefaultValue=0x01F40001`: 500 ms and no retries",
    remedy: "Set both, or clear both and use heartbeat.",
    source: "CiA 302-2 (1F81h)",
}

fn check(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    if at.against.index != 0x1F81 || at.counts() {
        return;
    }
    let Some(value) = at.entry.value().and_then(crate::model::Value::as_integer) else { return };
    let (retries, time) = (value >> 8 & 0xFF, value >> 16 & 0xFFFF);
    let message = match (value & 1 == 1, time > 0, retries > 0) {
        (true, true, false) => say!("{} has a guard time of {} ms and no retries", at, time),
        (true, false, true) => say!("{} has a retry factor of {} and no guard time", at, retries),
        _ => return,
    };
    let finding = Diagnostic::new(rule, at.place().field(at.value_field()), message);
    findings.push(finding.help("set both, or neither to guard by heartbeat"));
}
