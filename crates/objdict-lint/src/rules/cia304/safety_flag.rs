use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Field, Part, Place};
use crate::{Facts, rule};

rule! {
    "cia304/safety-flag", Warning, Facts(check);
    summary: "`CANopenSafetySupported` contradicts the objects",
    checks: "Whether a device with `CANopenSafetySupported=1` has SRDOs, and one with `CANopenSafetySupported=0` has none.",
    why: "A safety tool evaluates the flag: it finds nothing to configure, or ignores SRDOs that it must configure.",
    example: "`CANopenSafetySupported=1` without an object from 1301h to 1340h",
    remedy: "Correct the flag, or the objects.",
    source: "CiA 306-1 annex A, EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let info = facts.device.device_info.as_ref();
    let Some(supported) = info.and_then(|info| info.safety_supported) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::CanOpenSafetySupported);
    let finding = match (supported, facts.srdos.first()) {
        (true, None) => {
            Diagnostic::new(&RULE.info, place, "the device supports SRDOs but has no SRDO objects")
        }
        (false, Some(srdo)) => {
            let finding = Diagnostic::new(
                &RULE.info,
                place,
                say!("the device has {} but does not support SRDOs", srdo),
            );
            finding.label(Place::object(srdo.first_index()), "the SRDO")
        }
        _ => return,
    };
    findings.push(finding.help("correct the flag, or the SRDO objects"));
}
