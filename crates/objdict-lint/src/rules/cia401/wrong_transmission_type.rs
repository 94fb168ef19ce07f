use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::{Facts, channels, rule};

rule! {
    "cia401/wrong-transmission-type", Warning, Applied(check), fix Unsafe;
    summary: "a default PDO of an I/O module has a transmission type other than 255",
    checks: "Whether the default transmission type of PDO 1 to 4 of an EDS, as far as there are channels for them, is 255: sent when an input changes, applied immediately. The rule does not apply to PDOs that are not valid by default, when bit 23 of 1000h declares a manufacturer-specific mapping, and to devices with several logical devices.",
    why: "Without configuration, a master gets no inputs from a module that waits for a SYNC. With 254 the vendor, not the profile, defines when the PDO is sent.",
    example: "`[1800sub2]` with `DefaultValue=254`",
    remedy: "Write `DefaultValue=255`, in the description and in the device.",
    source: "CiA 401, default PDOs",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    for (pdo, _) in channels::default_pdos(facts, applied) {
        let pdo = &pdo.pdo;
        // another rule reports reserved transmission types
        let wrong = pdo.transmission_type.filter(|found| !matches!(found, 241..=251 | 255));
        let Some(found) = wrong.filter(|_| pdo.is_valid() != Some(false)) else { continue };
        let message = say!("transmission type `{}` of {} differs from CiA 401 (255)", found, pdo);
        let place = facts.device.value_place(pdo.communication_index(), 2);
        let finding = Diagnostic::new(rule, place.clone(), message).help("write 255");
        findings.push(finding.fix(Fix::risky("write `255`").set(place, "255")));
    }
}
