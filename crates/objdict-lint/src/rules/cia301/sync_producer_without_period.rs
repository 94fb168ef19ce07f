use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Service, rule, stated};

rule! {
    "cia301/sync-producer-without-period", Warning, Facts(check);
    summary: "the device produces SYNC but has no communication cycle period",
    checks: "Whether a device whose 1005h has bit 30 set (SYNC producer) has 1006h, the communication cycle period, and whether its value is not 0.",
    why: "The period of SYNC is unknown, or SYNC is switched off by a period of 0: synchronous PDOs are never sent.",
    example: "`[1005]` with `DefaultValue=0x40000080`, without `[1006]`",
    remedy: "Add 1006h, an UNSIGNED32 in microseconds, and write the period; or clear bit 30.",
    source: "CiA 301 §7.5.2.5, §7.5.2.6",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let sync = facts.cob_ids.iter().find(|cob_id| cob_id.service == Service::Sync);
    let Some(sync) = sync.filter(|sync| sync.is_sent()) else { return };
    if !stated::is_there(device, 0x1006) {
        let message = say!(
            "`{}` makes the device a SYNC producer, but 1006h (communication cycle period) is missing",
            sync.cob_id
        );
        let finding = Diagnostic::new(&RULE.info, device.value_place(0x1005, 0), message);
        findings.push(finding.help("add 1006h (UNSIGNED32), or clear bit 30 of 1005h"));
    } else if facts.number(0x1006, 0) == Some(0) {
        let message =
            say!("`{}` makes the device a SYNC producer, but a period of `0` switches SYNC off", sync.cob_id);
        let finding = Diagnostic::new(&RULE.info, device.value_place(0x1006, 0), message)
            .label(device.value_place(0x1005, 0), "bit 30 is set");
        findings.push(finding.help("write the period in microseconds, or clear bit 30 of 1005h"));
    }
}
