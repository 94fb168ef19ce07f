use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule, stated, with_others};

rule! {
    "cia301/synchronous-pdo-without-sync", Error, Facts(check);
    summary: "a synchronous PDO on a device without SYNC",
    checks: "Whether a device with a valid PDO of a synchronous transmission type (0 to 240, for a TPDO also 252) has 1005h, the COB-ID of SYNC. The rule reports one finding for the device, with every such PDO.",
    why: "Without 1005h the device does not process SYNC, so the PDO is never sent or never applied.",
    example: "`[1801sub2]` with `DefaultValue=1`, without `[1005]`",
    remedy: "Add 1005h with the default 80h, or give the PDO transmission type 254 or 255.",
    source: "CiA 301 §7.5.2.5, §7.5.2.35, §7.5.2.37",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    if stated::is_there(device, 0x1005) {
        return;
    }
    let mut synchronous = facts
        .pdos
        .iter()
        .map(|facts| &facts.pdo)
        .filter(|pdo| pdo.is_synchronous() && pdo.is_valid() == Some(true));
    let Some(first) = synchronous.next() else { return };
    let transmission_type = first.transmission_type.unwrap_or_default();
    let message = say!(
        "{} has the synchronous transmission type `{}`, but 1005h (COB-ID SYNC) is missing",
        first,
        transmission_type
    );
    let finding = Diagnostic::new(&RULE.info, device.value_place(first.communication_index(), 2), message);
    let finding = finding.help("add 1005h (UNSIGNED32, default `0x80`), or use transmission type 254 or 255");
    let place = |index| device.value_place(index, 2);
    let others = synchronous.map(|pdo| (place(pdo.communication_index()), say!("{} too", pdo)));
    findings.push(with_others(finding, others));
}
