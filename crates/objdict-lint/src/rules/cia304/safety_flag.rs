use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Field, Part, Place};
use crate::{Facts, rule};

rule! {
    "cia304/safety-flag", Warning, Facts(check);
    summary: "`CANopenSafetySupported` and the objects disagree",
    checks: "Whether a device with `CANopenSafetySupported=1` has SRDOs, and one with SRDOs does not say `CANopenSafetySupported=0`.",
    why: "A safety tool looks at the flag, and either finds nothing to configure or leaves alone what it should configure.",
    example: "`CANopenSafetySupported=1`, and no object from 1301h to 1340h",
    remedy: "Write what the device supports.",
    source: "CiA 306-1 annex A, EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let info = facts.device.device_info.as_ref();
    let Some(supported) = info.and_then(|info| info.safety_supported) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::CanOpenSafetySupported);
    let finding = match (supported, facts.srdos.first()) {
        (true, None) => {
            Diagnostic::new(&RULE.info, place, "the device supports SRDOs, and has no object for one")
        }
        (false, Some(srdo)) => {
            let finding = Diagnostic::new(
                &RULE.info,
                place,
                say!("the device has {}, and does not support SRDOs", srdo),
            );
            finding.label(Place::object(srdo.first_index()), "the SRDO")
        }
        _ => return,
    };
    findings.push(finding.help("write what the device supports"));
}
