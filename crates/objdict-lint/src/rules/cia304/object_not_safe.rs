use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Device;
use crate::{Facts, Target, rule};

rule! {
    "cia304/object-not-safe", Warning, Facts(check);
    summary: "an SRDO maps an entry that is not mappable to SRDOs",
    checks: "Whether each entry that an SRDO maps has `SRDOMapping=1`, in a description that uses `SRDOMapping` at all.",
    why: "A tool that configures the SRDO does not offer the entry, and rejects the existing mapping.",
    example: "`[1381sub1]` maps an entry with `SRDOMapping=0`",
    remedy: "Write `SRDOMapping=1`, or map another entry.",
    source: "CiA 306-1 annex A, EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.srdos.is_empty() || !uses_srdo_mapping(facts.device) {
        return;
    }
    for srdo in &facts.srdos {
        for (sub, mapped) in srdo.mapped() {
            let Target::Entry(entry) = Target::of(facts.device, mapped) else { continue };
            if entry.safety.as_ref().and_then(|safety| safety.srdo_mapping) == Some(true) {
                continue;
            }
            let message = say!(
                "{} maps {:04X}h:{:02X}, which is not mappable to SRDOs",
                srdo,
                mapped.index,
                mapped.sub
            );
            let place = facts.device.value_place(srdo.mapping_index(), sub);
            let finding = Diagnostic::new(&RULE.info, place, message);
            findings.push(finding.help(say!("write `{SRDOMapping=1}` for the entry, or map another one")));
        }
    }
}

fn uses_srdo_mapping(device: &Device) -> bool {
    let says = |entry: &crate::model::Entry| {
        entry.safety.as_ref().is_some_and(|safety| safety.srdo_mapping == Some(true))
    };
    device.objects.values().any(|object| object.described().any(|(_, entry)| says(entry)))
}
