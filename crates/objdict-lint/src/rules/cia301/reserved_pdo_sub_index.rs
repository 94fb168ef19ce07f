use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, say};
use crate::model::{DataType, Field, Place};
use crate::{Facts, rule, stated, with_others};

rule! {
    "cia301/reserved-pdo-sub-index", Warning, Facts(check), fix Unsafe;
    summary: "a PDO communication parameter has the reserved sub-index 4",
    checks: "Whether an object from 1400h to 15FFh or from 1800h to 19FFh describes sub-index 4. The rule reports one finding for the device, with every such PDO. An UNSIGNED8, a compatibility entry of older devices, is a note: a quarter of the examined files have it, and it is harmless. Another data type is a warning, because the entry is probably meant for another sub-index.",
    why: "CiA 301 reserves the sub-index; a device answers with an abort. An event timer that is written there instead of to sub-index 5 has no effect.",
    example: "`[1800sub4]`",
    remedy: "Remove the section. The gap between 3 and 5 is correct, and sub-index 0 remains the highest sub-index.",
    source: "CiA 301 §7.4.8.1, §7.5.2.35, §7.5.2.37",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let pdos = facts.pdos.iter().map(|facts| &facts.pdo);
    let with = pdos.filter_map(|pdo| Some((pdo, pdo.communication?.subs.get(4)?)));
    let Some((first, _)) = with.clone().next() else { return };
    let place = |index| Place::entry(index, 4);
    let message = say!("{} has the reserved sub-index 4 in {:04X}h", first, first.communication_index());
    let finding = Diagnostic::new(&RULE.info, place(first.communication_index()), message);
    let finding = finding.help(say!("remove the {section}; the event timer is sub-index 5"));
    let is_compatible = with.clone().all(|(_, entry)| entry.data_type == Some(DataType::UNSIGNED8));
    let finding = if is_compatible { finding.severity(Severity::Note) } else { finding };
    let fix = with.clone().fold(Fix::risky(say!("remove the {section}")), |fix, (pdo, _)| {
        let described = pdo.communication.map_or(0, stated::described_subs).saturating_sub(1);
        let number = Place::object(pdo.communication_index()).field(Field::SubNumber);
        let fix = fix.remove(place(pdo.communication_index())).set(number, described.to_string());
        let Some(object) = pdo.communication.filter(|object| object.highest_sub() == Some(4)) else {
            return fix;
        };
        let highest = object.subs.iter().map(|(sub, _)| sub).filter(|&sub| sub < 4).max().unwrap_or_default();
        let count = Place::entry(pdo.communication_index(), 0).field(Field::DefaultValue);
        fix.set(count, highest.to_string())
    });
    let finding = finding.fix(fix);
    let others = with.skip(1).map(|(pdo, _)| (place(pdo.communication_index()), say!("{} too", pdo)));
    findings.push(with_others(finding, others));
}
