use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::model::{DeviceKind, PdoKind};
use crate::{Facts, rule};

rule! {
    "cia406/wrong-transmission-type", Warning, Applied(check), fix Unsafe;
    summary: "a TPDO of an encoder has a transmission type other than that of CiA 406",
    checks: "Whether TPDO 1 of an EDS is sent by its timer (transmission type 254; 255 is accepted) and TPDO 2 on each SYNC (type 1). TPDO 2 is not checked if there is a TPDO 3, which was the synchronous one before edition 3.",
    why: "A master that knows the profile expects TPDO 1 asynchronously and TPDO 2 with each SYNC.",
    example: "`[1800sub2]` with `DefaultValue=1`",
    remedy: "Write 254 for TPDO 1 and 1 for TPDO 2.",
    source: "CiA 406 (1800h, 1801h)",
}

/// A TPDO with its default type and all types it may have.
const TYPES: [(u16, u8, &[u8]); 2] = [(1, 254, &[254, 255]), (2, 1, &[1])];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    if device.kind != DeviceKind::Type || applied.block > 0 || device.profile() == Some(0xFFFF) {
        return;
    }
    let has_third = device.objects.contains_key(&0x1802);
    for (number, right, allowed) in TYPES.into_iter().filter(|(number, ..)| *number == 1 || !has_third) {
        let Some(pdo) = device.pdo(PdoKind::Tpdo, number) else { continue };
        // another rule reports reserved transmission types
        let wrong =
            pdo.transmission_type.filter(|found| !allowed.contains(found) && !(241..=251).contains(found));
        let Some(found) = wrong else { continue };
        let message = say!("transmission type `{}` of {} differs from CiA 406 ({!})", found, pdo, right);
        let place = device.value_place(pdo.communication_index(), 2);
        let finding = Diagnostic::new(rule, place.clone(), message).help(say!("write {}", right));
        findings.push(finding.fix(Fix::risky(say!("write `{}`", right)).set(place, right.to_string())));
    }
}
