use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{CobId, PdoKind};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/rtr-pdo-without-rtr", Warning, Pdo(check), fix Unsafe;
    summary: "a TPDO is sent only on request but forbids remote frames",
    checks: "Whether the COB-ID of each TPDO with transmission type 252 or 253 has bit 30 clear.",
    why: "Bit 30 forbids remote frames for the PDO, but these transmission types send it only on a remote frame: the PDO is never sent.",
    example: "`[1800sub1]` with `DefaultValue=$NODEID+0x40000180` and `[1800sub2]` with `DefaultValue=253`",
    remedy: "Use an event-driven or a synchronous type; CiA advises against remote frames.",
    source: "CiA 301 §7.5.2.37 tables 70 and 72",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let on_request = pdo.transmission_type.filter(|transmission_type| matches!(transmission_type, 252 | 253));
    let (Some(transmission_type), Some(cob_id)) = (on_request, pdo.cob_id) else { return };
    if pdo.kind == PdoKind::Tpdo && cob_id.is_valid() && cob_id.bit_30() {
        let index = pdo.communication_index();
        let message = say!(
            "{} is sent only on request (transmission type `{}`), but bit 30 of `{}` forbids remote frames",
            pdo,
            transmission_type,
            cob_id
        );
        let finding = Diagnostic::new(&RULE.info, facts.device.value_place(index, 2), message)
            .label(facts.device.value_place(index, 1), "bit 30: no RTR allowed");
        let flags = if cob_id.depends_on_node_id() { "$NODEID+" } else { "" };
        let number = cob_id.number() & !CobId::BIT_30;
        let fix = Fix::risky("clear bit 30")
            .set(facts.device.value_place(index, 1), format!("{flags}0x{number:X}"));
        let finding = finding.fix(fix);
        findings.push(finding.help(say!(
            "use another transmission type, or clear bit 30: `{}0x{:X}`",
            flags,
            number
        )));
    }
}
