use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Place;
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/pdo-without-mapping", Error, Pdo(check);
    summary: "a PDO has only one of its two objects",
    checks: "Whether each PDO communication parameter (1400h to 15FFh, 1800h to 19FFh) has the mapping parameter 200h above it, and the reverse. A module may provide the other object.",
    why: "Without the mapping, the contents of the PDO are unknown; without the communication parameter, its CAN-ID and trigger. `CompactPDO` allows both objects to be omitted, not only one.",
    example: "`[1802]` without `[1A02]`",
    remedy: "Describe the other object, or remove this one.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38; CiA 306-1 §4.6.3.4.1",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let (communication, mapping) = (pdo.communication_index(), pdo.mapping_index());
    let (there, what, missing, other) = match (pdo.communication, pdo.mapping) {
        (Some(_), None) => (communication, "a communication parameter", mapping, "mapping parameter"),
        (None, Some(_)) => (mapping, "a mapping parameter", communication, "communication parameter"),
        _ => return,
    };
    let device = facts.device;
    let mut modules = device.modules.iter().flat_map(|modules| modules.supported.values());
    if device.lists.contains(missing) || modules.any(|module| module.fixed.contains_key(&missing)) {
        return;
    }
    let message = say!("{} has {}, {:04X}h, but no {}, {:04X}h", pdo, what, there, other, missing);
    let finding = Diagnostic::new(&RULE.info, Place::object(there), message);
    findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", missing, there)));
}
