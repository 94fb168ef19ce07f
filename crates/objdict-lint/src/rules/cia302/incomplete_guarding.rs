use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::rule;

rule! {
    "cia302/incomplete-guarding", Warning, Against(check);
    summary: "the guarding of a slave has only one of guard time and retry factor",
    checks: "Whether each entry of 1F81h for a slave of this master (bit 0) has both a guard time (bits 16 to 31) and a retry factor (bits 8 to 15), or neither.",
    why: "With only one of the two, guarding is off and the loss of a node is not detected.",
    example: "`[1F81sub5]` with `DefaultValue=0x01F40001`: 500 ms and no retries",
    remedy: "Set both, or clear both and use heartbeat.",
    source: "CiA 302-2 (1F81h)",
}

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if at.index != 0x1F81 || !at.has_its_shape() {
        return;
    }
    for node in 1..=127 {
        let Some(value) = at.object.value(node).and_then(|value| value.as_integer()) else { continue };
        let (retries, time) = (value >> 8 & 0xFF, value >> 16 & 0xFFFF);
        let message = match (value & 1 == 1, time > 0, retries > 0) {
            (true, true, false) => {
                say!("1F81h sub-index {} has a guard time of {} ms but a retry factor of 0", node, time)
            }
            (true, false, true) => {
                say!("1F81h sub-index {} has a retry factor of {} but a guard time of 0", node, retries)
            }
            _ => continue,
        };
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, node), message);
        findings.push(finding.help("set both, or clear both and use the heartbeat"));
    }
}
