use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{Entry, PdoKind};
use crate::{Drive, Facts, PdoFacts, rule};

rule! {
    "cia402/controlword-not-mapped", Note, Applied(check);
    summary: "no PDO carries the controlword or the statusword by default",
    checks: "Whether at least one RPDO maps 6040h and one TPDO maps 6041h by default, in drives whose PDOs have a default mapping. Only the first axis is checked. Drives with an incomplete default mapping, and objects that are not mappable, are skipped.",
    why: "The default PDOs of CiA 402-3 begin with these objects, and a master that keeps the default mapping relies on them.",
    example: "`DefaultValue=0x607A0020` in `[1600sub1]`, and no RPDO with 60400010h",
    remedy: "Map the objects by default, first in RPDO 1 and TPDO 1; or ignore the note if every master configures the mapping. It is a note because the drive works with a master that sets its own mapping.",
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
        let message = say!("no {} maps {} ({}) by default", kind, drive.name(index), name);
        let finding = Diagnostic::new(rule, drive.place(index), message);
        let place = facts.device.value_place(first.pdo.mapping_index(), 1);
        let help = say!("map it as the first object: `0x{:04X}0010`", drive.index(index));
        findings.push(finding.label(place, say!("{} maps this", first.pdo)).help(help));
    }
}
