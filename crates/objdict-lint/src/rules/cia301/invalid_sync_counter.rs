use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::model::PdoKind;
use crate::{Facts, rule, with_others};

rule! {
    "cia301/invalid-sync-counter", Error, Facts(check);
    summary: "the overflow value of the SYNC counter is reserved or does not match the PDOs",
    checks: "Whether 1019h is 0 or 2 to 240, and, as a warning, whether it is a multiple of the transmission type of each valid TPDO that is sent with every n-th SYNC.",
    why: "The device rejects 1 and values above 240. If the overflow value is not a multiple of n, the counter restarts within a cycle and the PDO is sent early once per counter period.",
    example: "`[1019]` with `DefaultValue=1`",
    remedy: "Write 0 to send SYNC without a counter, otherwise the least common multiple of the transmission types.",
    source: "CiA 301 §7.5.2.22",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let value = device.value(0x1019, 0).and_then(|value| value.as_integer());
    let Some(overflow) = value.and_then(|value| u8::try_from(value).ok()) else { return };
    let place = device.value_place(0x1019, 0);
    if overflow == 1 || overflow > 240 {
        let message = say!("the overflow value `{}` of the SYNC counter is reserved", overflow);
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("write 0 to disable the counter, or a value from 2 to 240"));
        return;
    }
    let cycles =
        |transmission_type: &u8| (2..=240).contains(transmission_type) && overflow % transmission_type != 0;
    let tpdos = facts.pdos.iter().map(|facts| &facts.pdo);
    let tpdos = tpdos.filter(|pdo| pdo.kind == PdoKind::Tpdo && pdo.is_valid() == Some(true));
    let mut broken = tpdos.filter_map(|pdo| Some((pdo, pdo.transmission_type.filter(cycles)?))).peekable();
    if overflow == 0 || broken.peek().is_none() {
        return;
    }
    let message = say!(
        "the SYNC counter overflows at `{}`, which is not a multiple of every transmission type",
        overflow
    );
    let finding = Diagnostic::new(&RULE.info, place, message).severity(Severity::Warning);
    let finding = finding.help("write the least common multiple of the transmission types");
    let others = broken.map(|(pdo, every)| {
        let at = device.value_place(pdo.communication_index(), 2);
        (at, say!("{} has transmission type {}", pdo, every))
    });
    findings.push(with_others(finding, others));
}
