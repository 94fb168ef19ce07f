use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Text, say};
use crate::model::DeviceKind;
use crate::rule;

rule! {
    "cia302/contradictory-startup", Warning, Against(check);
    summary: "bits of 1F80h contradict each other or the slave assignment",
    checks: "Whether 1F80h has both bits 4 and 6 set, where bit 6 takes precedence, or both bits 1 and 3, where bit 1 has no effect because of bit 3, and whether bit 0 (NMT master) is set in a configuration that assigns slaves (1F81h, bit 0).",
    why: "The device performs one of the two actions, and the user of the other bit expects the other one.",
    example: "`[1F80]` with `DefaultValue=0x00000051`: on an error of a mandatory slave all nodes are reset (bit 4) and all are stopped (bit 6)",
    remedy: "Clear bit 4 to stop all nodes or bit 6 to reset them; clear bit 1 when slaves are not started (bit 3).",
    source: "CiA 302-2 (1F80h)",
}

/// Two bits and the effect of setting both.
const CONTRADICTIONS: [(u8, u8, &str); 2] = [
    (
        4,
        6,
        "on an error of a mandatory slave all nodes are reset (bit 4) or stopped (bit 6); bit 6 takes precedence",
    ),
    (1, 3, "slaves are started simultaneously (bit 1) or not at all (bit 3); bit 1 has no effect"),
];

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let value = at.object.value(0).filter(|_| at.index == 0x1F80 && at.has_its_shape());
    let Some(value) = value.and_then(|value| value.as_integer()) else { return };
    let is_set = |bit: u8| value >> bit & 1 == 1;
    for (first, second, meaning) in CONTRADICTIONS {
        if is_set(first) && is_set(second) {
            let message = say!("bits {} and {} of 1F80h are set: {}", first, second, Text::from(meaning));
            let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
            findings.push(finding.help(say!("clear bit {} or bit {}", first, second)));
        }
    }
    let is_assigned = |&node: &u8| {
        at.device.value(0x1F81, node).and_then(|slave| slave.as_integer()).is_some_and(|slave| slave & 1 == 1)
    };
    let slave = (1..=127).find(is_assigned).filter(|_| at.device.kind == DeviceKind::Node && !is_set(0));
    if let Some(node) = slave {
        let message =
            say!("1F81h assigns node {}, but bit 0 of 1F80h is 0: the device is not NMT master", node);
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
        let finding = finding.label(at.device.value_place(0x1F81, node), "a slave");
        findings.push(finding.help("set bit 0, or remove the slaves"));
    }
}
