use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Service, rule};

rule! {
    "cia301/time-producer-and-consumer", Warning, Facts(check);
    summary: "the device is both producer and consumer of TIME",
    checks: "Whether 1012h has both bit 31 (TIME consumer) and bit 30 (TIME producer) set.",
    why: "One device of a network produces the time, and the others consume it. A device that does both sets its clock from its own message.",
    example: "`[1012]` with `DefaultValue=0xC0000100`",
    remedy: "Clear one of the bits.",
    source: "CiA 301 §7.5.2.15",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let time = facts.cob_ids.iter().find(|cob_id| cob_id.service == Service::Time);
    let Some(time) = time.filter(|time| !time.cob_id.is_valid() && time.cob_id.bit_30()) else { return };
    let message = say!("`{}` makes the device both producer and consumer of TIME", time.cob_id);
    let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x1012, 0), message);
    findings.push(finding.help("clear bit 30 for a consumer, or bit 31 for a producer"));
}
