use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::rule;

rule! {
    "cia302/flying-master-time-slots", Error, Against(check);
    summary: "the time slots of a flying master overlap",
    checks: "Whether the priority time slot of 1F90h (sub-index 4) is longer than 127 times the device time slot (sub-index 5).",
    why: "A device waits for the priority time slot times its priority plus the device time slot times its node-ID before it claims the master role. If the slots overlap, a device of low priority claims it before one of high priority.",
    example: "`[1F90sub4]` with `DefaultValue=1000` and `[1F90sub5]` with `DefaultValue=10`: 127 times 10 is 1270",
    remedy: "Increase the priority time slot or reduce the device time slot. The defaults of the document are 1500 and 10.",
    source: "CiA 302-2 (1F90h)",
}

/// The highest node-ID.
const NODES: i128 = 127;

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if at.index != 0x1F90 || !at.has_its_shape() {
        return;
    }
    let value = |sub: u8| at.object.value(sub)?.as_integer();
    let (Some(priority), Some(node)) = (value(4), value(5)) else { return };
    if priority <= NODES * node {
        let message = say!(
            "the priority time slot of `{}` ms is not longer than 127 device time slots ({} ms)",
            priority,
            NODES * node
        );
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, 4), message);
        let finding = finding.label(at.device.value_place(at.index, 5), "the device time slot");
        findings.push(finding.help(say!("write a value greater than {}", NODES * node)));
    }
}
