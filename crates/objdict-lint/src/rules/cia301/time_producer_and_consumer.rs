use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Service, rule};

rule! {
    "cia301/time-producer-and-consumer", Warning, Facts(check);
    summary: "the device sends TIME and listens to it",
    checks: "Whether not both bit 31 (the device takes the time from TIME) and bit 30 (the device sends TIME) of 1012h are set.",
    why: "One device on a network gives the time, and the others take it. A device that does both sets its clock by itself.",
    example: "`[1012]` with `DefaultValue=0xC0000100`",
    remedy: "Clear one of the bits.",
    source: "CiA 301 §7.5.2.15",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let time = facts.cob_ids.iter().find(|cob_id| cob_id.service == Service::Time);
    let Some(time) = time.filter(|time| !time.cob_id.is_valid() && time.cob_id.bit_30()) else { return };
    let message = say!("`{}` makes the device send TIME and listen to it", time.cob_id);
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1012, 0), message);
    findings.push(finding.help("clear bit 30 of one that takes the time, bit 31 of one that gives it"));
}
