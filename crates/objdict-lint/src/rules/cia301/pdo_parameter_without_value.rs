use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, is_unstated, rule};

rule! {
    "cia301/pdo-parameter-without-value", Note, Pdo(check);
    summary: "the COB-ID or transmission type of a PDO has no value",
    checks: "Whether sub-indexes 1 and 2 of each PDO communication parameter have a value.",
    why: "The CAN-ID and the trigger of the PDO in a new device are unknown. A tool that restores the defaults omits this entry.",
    example: "`[1800sub2]` without `DefaultValue`",
    remedy: "Write the value that the device has after its defaults are restored.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(object) = pdo.communication_record() else { return };
    let pdo = &pdo.pdo;
    let index = pdo.communication_index();
    for (sub, name) in [(1, "COB-ID"), (2, "transmission type")] {
        let has_type = object.subs.get(sub).is_none_or(|entry| entry.data_type.is_some());
        if has_type && is_unstated(object, sub) {
            let message = say!("the {} of {} has no value", name, pdo);
            let finding = Diagnostic::new(&RULE.info, facts.device.value_place(index, sub), message);
            findings
                .push(finding.help("write the value that the device has after its defaults are restored"));
            return;
        }
    }
}
