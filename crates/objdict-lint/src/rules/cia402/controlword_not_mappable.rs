use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{Field, PdoKind};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/controlword-not-mappable", Warning, Applied(check);
    summary: "the controlword or the statusword is not mappable",
    checks: "Whether 6040h and 6041h are marked as mappable in a drive with RPDOs and TPDOs.",
    why: "Masters control the state machine by PDO. If the objects cannot be mapped, each transition needs an SDO transfer, which most masters do not support.",
    example: "`PDOMapping=0` in `[6040]`",
    remedy: "Write `PDOMapping=1` if the drive supports it.",
    source: "CiA 402-2, controlword and statusword; CiA 402-3, default PDOs",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (index, name, kind) in [(0x6040, "controlword", PdoKind::Rpdo), (0x6041, "statusword", PdoKind::Tpdo)]
    {
        let has_pdos = facts.pdos.iter().any(|facts| facts.pdo.kind == kind);
        let Some(entry) = drive.variable(index).filter(|_| has_pdos) else { continue };
        if entry.is_mappable() || entry.invalid_values.get(&Field::PdoMapping).is_some() {
            continue;
        }
        let message = say!("{} ({}) is not mappable, so no {} can carry it", drive.name(index), name, kind);
        let place = drive.place(index).field(Field::PdoMapping);
        findings.push(Diagnostic::new(rule, place, message).help(say!("write `{PDOMapping=1}`")));
    }
}
