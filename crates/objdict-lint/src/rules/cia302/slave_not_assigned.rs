use crate::demands::Against;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{rule, with_others};

rule! {
    "cia302/slave-not-assigned", Warning, Against(check);
    summary: "an entry of 1F81h configures a node that is not a slave",
    checks: "Whether bit 0 (slave of this master) is set in each entry of 1F81h that is not 0, and whether no entry makes the node of a DCF its own slave. One finding, with every such entry.",
    why: "Without bit 0 the manager ignores all other bits: it does not boot a node that is marked as mandatory, and does not guard it.",
    example: "`[1F81sub5]` with `DefaultValue=0x00000008`, a mandatory node that is not a slave",
    remedy: "Set bit 0, or write 0 if the node is not a slave of this master.",
    source: "CiA 302-2 (1F81h)",
}

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    if at.index != 0x1F81 || !at.has_its_shape() {
        return;
    }
    let slaves = (1..=127).filter_map(|node| Some((node, at.object.value(node)?.as_integer()?)));
    let mut wrong = slaves.filter_map(|(node, value)| {
        let is_own = at.device.node_id() == Some(node);
        let what = match (value & 1 == 1, is_own) {
            (true, true) => say!("node {} is its own slave", node),
            (false, false) if value != 0 => {
                say!("`0x{:08X}` of node {} does not set bit 0 (slave of this master)", value, node)
            }
            _ => return None,
        };
        Some((at.device.value_place(at.index, node), what))
    });
    let Some((place, what)) = wrong.next() else { return };
    let finding = with_others(Diagnostic::new(rule, place, what), wrong);
    findings.push(finding.help("set bit 0 of each slave, and write 0 for other nodes"));
}
