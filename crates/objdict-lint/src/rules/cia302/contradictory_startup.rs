use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Text, say};
use crate::rule;

rule! {
    "cia302/contradictory-startup", Warning, Against(check);
    summary: "bits of 1F80h contradict each other",
    checks: "Whether 1F80h has bits 4 and 6 set, of which the second decides, or bits 1 and 3, of which the first means nothing because of the second.",
    why: "The device does one of the two, and whoever set the other counts on it.",
    example: "`[1F80]` with `DefaultValue=0x00000051`: on an error of a mandatory slave all nodes are reset (bit 4) and all are stopped (bit 6)",
    remedy: "Clear bit 4 to stop all nodes or bit 6 to reset them; clear bit 1 when slaves are not started (bit 3).",
    source: "CiA 302-2 (1F80h)",
}

/// Two bits, and what they say together.
const CONTRADICTIONS: [(u8, u8, &str); 2] = [
    (
        4,
        6,
        "all nodes are reset and all are stopped on an error of a mandatory slave, and the second decides",
    ),
    (1, 3, "slaves are started all at once and are not started, so the first means nothing"),
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
}
