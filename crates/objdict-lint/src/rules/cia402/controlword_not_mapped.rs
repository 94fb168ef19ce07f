use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{Entry, PdoKind};
use crate::{Drive, Facts, PdoFacts, rule};

rule! {
    "cia402/controlword-not-mapped", Note, Applied(check);
    summary: "no PDO carries the controlword or the statusword by default",
    checks: "Whether, on a drive whose RPDOs map something by default, one of them maps 6040h, and of its TPDOs one maps 6041h. Only the words of the first axis are looked at, and neither mappings that leave it open nor words that cannot be mapped.",
    why: "The default PDOs of CiA 402-3 begin with the words, and a master that changes no mapping counts on them.",
    example: "`DefaultValue=0x607A0020` in `[1600sub1]`, and no RPDO with 60400010h",
    remedy: "Map the words by default, first of all in RPDO 1 and TPDO 1; or leave it, when every master configures the mapping. It is a note because the drive works with a master that maps for itself.",
    source: "CiA 402-3, default PDOs",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    if applied.block > 0 {
        return;
    }
    let drive = Drive::new(facts, applied);
    for (index, name, kind) in [(0x6040, "controlword", PdoKind::Rpdo), (0x6041, "statusword", PdoKind::Tpdo)]
    {
        let pdos = facts.pdos.iter().filter(|facts| facts.pdo.kind == kind);
        let is_open = pdos.clone().any(|facts| facts.pdo.used_slots().any(|slot| slot.object.is_none()));
        let maps = |facts: &PdoFacts<'_>| {
            facts.mapped.iter().any(|mapped| mapped.object.index == drive.index(index))
        };
        let Some(first) = pdos.clone().find(|facts| !facts.mapped.is_empty()) else { continue };
        let is_mappable = drive.variable(index).is_some_and(Entry::is_mappable);
        if is_open || !is_mappable || pdos.clone().any(maps) {
            continue;
        }
        let message = say!("no {} carries {} ({}) by default", kind, drive.name(index), name);
        let finding = Diagnostic::new(rule, drive.place(index), message);
        let place = facts.device.value_place(first.pdo.mapping_index(), 1);
        let help = say!("map it first: `0x{:04X}0010`", drive.index(index));
        findings.push(finding.label(place, say!("{} carries this", first.pdo)).help(help));
    }
}
