use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::{Facts, channels, rule};

rule! {
    "cia401/wrong-transmission-type", Warning, Applied(check), fix Unsafe;
    summary: "a default PDO of an I/O module has another transmission type than 255",
    checks: "Whether PDO 1 to 4 of an EDS, as far as there are channels for them, have 255 as default of the transmission type: sent when an input changes, taken over at once. It is silent about PDOs that are not valid by default, when bit 23 of 1000h says that the manufacturer maps the channels, and for modules of several logical devices.",
    why: "A master that configures nothing gets no inputs from a module that waits for a SYNC. With 254 the maker says when the PDO is sent, not the profile.",
    example: "`[1800sub2]` with `DefaultValue=254`",
    remedy: "Write `DefaultValue=255`, in the description and in the device.",
    source: "CiA 401, default PDOs",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    for (pdo, _) in channels::default_pdos(facts, applied) {
        let pdo = &pdo.pdo;
        // types that no PDO has are reported as that
        let wrong = pdo.transmission_type.filter(|found| !matches!(found, 241..=251 | 255));
        let Some(found) = wrong.filter(|_| pdo.is_valid() != Some(false)) else { continue };
        let message = say!("`{}` as transmission type of {}, CiA 401 has 255", found, pdo);
        let place = facts.device.value_place(pdo.communication_index(), 2);
        let finding = Diagnostic::new(rule, place.clone(), message).help("write 255");
        findings.push(finding.fix(Fix::risky("write `255`").set(place, "255")));
    }
}
