use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/multiplexed-pdo-transmission-type", Warning, Pdo(check);
    summary: "a multiplexed PDO has a synchronous transmission type",
    checks: "Whether the transmission type of each multiplexed PDO (sub-index 0 of the mapping is 254 or 255) is 254 or 255.",
    why: "A multiplexed PDO transmits one entry per frame when that entry changes. SYNC cannot trigger it.",
    example: "`[1A00sub0]` with `DefaultValue=255` and `[1800sub2]` with `DefaultValue=1`",
    remedy: "Write 254 or 255.",
    source: "CiA 301 §7.2.2.6, §7.5.2.36",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(transmission_type @ 0..=240) = pdo.transmission_type.filter(|_| pdo.is_multiplexed()) else {
        return;
    };
    let place = facts.device.value_place(pdo.communication_index(), 2);
    let message =
        say!("{} is a multiplexed PDO, but transmission type `{}` is synchronous", pdo, transmission_type);
    let finding = Diagnostic::new(&RULE.info, place, message)
        .label(facts.device.value_place(pdo.mapping_index(), 0), "this makes it a multiplexed PDO");
    findings.push(finding.help("write 254 or 255"));
}
