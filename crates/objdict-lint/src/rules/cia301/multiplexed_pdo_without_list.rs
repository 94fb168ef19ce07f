use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::PdoKind;
use crate::{Facts, rule};

rule! {
    "cia301/multiplexed-pdo-without-list", Error, Facts(check);
    summary: "a multiplexed PDO in source address mode has no list",
    checks: "Whether a device with a TPDO whose mapping has 254 in sub-index 0 has an object scanner list (1FA0h to 1FCFh), and one with such an RPDO an object dispatching list (1FD0h to 1FFFh).",
    why: "In source address mode, the lists define which entries are sent and where received entries are written. Without them nothing is sent, and received data are discarded.",
    example: "`[1600sub0]` with `DefaultValue=254`, without `[1FD0]`",
    remedy: "Add the list, or write 255 to sub-index 0 for destination address mode, which needs no list.",
    source: "CiA 301 §7.2.2.6, §7.5.2.39, §7.5.2.40",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    for kind in PdoKind::ALL {
        let (first, last, name) = match kind {
            PdoKind::Tpdo => (0x1FA0, 0x1FCF, "object scanner list"),
            PdoKind::Rpdo => (0x1FD0, 0x1FFF, "object dispatching list"),
        };
        let mut pdos = facts.pdos.iter().map(|facts| &facts.pdo).filter(|pdo| pdo.kind == kind);
        let Some(pdo) = pdos.find(|pdo| pdo.mapped_count == Some(0xFE)) else { continue };
        let is_listed = device.lists.iter().any(|(_, index)| (first..=last).contains(&index));
        if is_listed || device.objects.range(first..=last).next().is_some() {
            continue;
        }
        let message = say!("{} is a multiplexed PDO in source address mode, but there is no {}", pdo, name);
        let finding = Diagnostic::new(&RULE.info, device.value_place(pdo.mapping_index(), 0), message);
        findings.push(finding.help(say!(
            "add {:04X}h ({}), or write 255 for destination address mode",
            first,
            name
        )));
    }
}
