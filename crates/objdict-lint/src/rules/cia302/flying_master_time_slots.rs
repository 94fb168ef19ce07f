use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::rule;

rule! {
    "cia302/flying-master-time-slots", Error, Against(check);
    summary: "the time slots of a flying master overlap",
    checks: "Whether the priority time slot of 1F90h (sub-index 4) is more than 127 times the time slot of a device (sub-index 5).",
    why: "A device waits its priority times the first and its node-ID times the second before it claims to be master. When they overlap, one of low priority comes before one of high priority.",
    example: "`[1F90sub4]` with `DefaultValue=1000` and `[1F90sub5]` with `DefaultValue=10`: 127 times 10 are 1270",
    remedy: "Raise the priority time slot or shorten that of a device. 1500 and 10 are the defaults of the document.",
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
            "`{}` ms as priority time slot, which must be more than 127 time slots of a device ({} ms)",
            priority,
            NODES * node
        );
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, 4), message);
        let finding = finding.label(at.device.value_place(at.index, 5), "time slot of a device");
        findings.push(finding.help(say!("write more than {}", NODES * node)));
    }
}
