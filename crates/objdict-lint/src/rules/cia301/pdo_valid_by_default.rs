use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::DeviceKind;
use crate::{Facts, rule, with_others};

rule! {
    "cia301/pdo-valid-by-default", Warning, Facts(check);
    summary: "a PDO without a predefined CAN-ID is valid by default",
    checks: "Whether the default COB-ID of PDO 5 and above has bit 31 set. The rule reports one finding for the device, with every such PDO. A DCF is not checked: it holds the configuration of a node, and tools write that as default.",
    why: "The predefined connection set has no CAN-ID for these PDOs. A PDO that is valid after a reset may use the CAN-ID of another device before a manager can configure it.",
    example: "`[1804sub1]` with `DefaultValue=$NODEID+0x1C0`",
    remedy: "Set bit 31: `$NODEID+0x800001C0`, or `0x80000000`.",
    source: "CiA 301 §7.5.2.35 table 67, §7.5.2.37 table 71",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let is_type = device.kind == DeviceKind::Type;
    let mut on = facts.pdos.iter().filter_map(|of_pdo| {
        let pdo = &of_pdo.pdo;
        let entry = pdo.communication?.subs.get(1)?;
        let cob_id = of_pdo.cob_id().filter(|cob_id| cob_id.cob_id.is_valid() && cob_id.wrong_bits() == 0)?;
        // another rule reports a restricted CAN-ID
        let is_looked_at = pdo.number > 4 && is_type && !facts.is_restricted(&cob_id);
        (is_looked_at && entry.configured_value().is_none()).then_some((pdo, cob_id.cob_id))
    });
    let Some((first, cob_id)) = on.next() else { return };
    let message = say!("`{}` makes {} valid by default, although it has no predefined CAN-ID", cob_id, first);
    let finding = Diagnostic::new(&RULE.info, device.value_place(first.communication_index(), 1), message);
    let finding = finding.help(say!("set bit 31: `{}`", cob_id.disabled()));
    let place = |index| device.value_place(index, 1);
    findings.push(with_others(
        finding,
        on.map(|(pdo, _)| (place(pdo.communication_index()), say!("{} too", pdo))),
    ));
}
