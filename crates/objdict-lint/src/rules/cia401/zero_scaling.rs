use crate::demands::Expected;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::rule;

rule! {
    "cia401/zero-scaling", Error, Expected(check);
    summary: "an analogue channel is configured with a scaling of 0",
    checks: "Whether a configuration (DCF or XDC) sets no element of 642Fh, 6432h, 6442h or 6447h to 0. `cia401/wrong-default` checks the defaults.",
    why: "The value of the channel is multiplied by 0, so an input always reads its offset and an output never changes.",
    example: "`[6432sub1]` with `ParameterValue=0`",
    remedy: "Write 1 for no scaling.",
    source: "CiA 401 (642Fh, 6432h, 6442h, 6447h)",
}

fn check(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let is_scaling = matches!(at.against.facts.first, 0x642F | 0x6432 | 0x6442 | 0x6447);
    let value = at.entry.configured_value().filter(|_| is_scaling && !at.counts());
    if value.and_then(crate::model::Value::as_real) == Some(0.0) {
        let message = say!("the scaling of {} is `0`", at);
        let finding = Diagnostic::new(rule, at.place().field(at.value_field()), message);
        findings.push(finding.help("write 1 for no scaling"));
    }
}
