use crate::diagnostic::{At, Diagnostic, Findings, counted, say};
use crate::model::{Device, Place};
use crate::{canopennode, rule};

rule! {
    "cia306/disabled-object", Note, Device(check);
    summary: "objects are marked as disabled, and are not checked",
    checks: "Whether objects are marked as disabled, by the property `CO_disabled` of an XDD or the comment `;CO_disabled=true` of an EDS, as CANopenEditor writes them.",
    why: "The generators of CANopenNode omit these objects, so the device does not have them. Other tools read them as objects of the device.",
    example: "`;CO_disabled=true` in `[1F80]`",
    remedy: "Remove objects that the device does not have before you publish the description, or remove the mark.",
    source: "CANopenEditor",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut disabled = device.objects.iter().filter(|(_, object)| canopennode::is_disabled(object));
    let Some((&first, _)) = disabled.next() else { return };
    let number = 1 + disabled.count();
    let objects =
        counted(number, "object is marked as disabled and is", "objects are marked as disabled and are");
    let finding = Diagnostic::new(&RULE.info, Place::object(first), say!("{} not checked", objects));
    findings.push(finding.help("remove the objects before you publish the description"));
}

/// Findings without those about disabled objects: what a device does not have is not judged.
pub fn without_disabled(device: &Device, findings: Findings) -> Findings {
    if !device.objects.values().any(canopennode::is_disabled) {
        return findings;
    }
    findings.filter_map(|finding| {
        let index = match finding.labels.first().map(|label| &label.at) {
            Some(At::Place(place)) => place.part.object(),
            _ => None,
        };
        let is_disabled = index.and_then(|index| device.object(index)).is_some_and(canopennode::is_disabled);
        (!is_disabled || finding.rule.id == RULE.info.id).then_some(finding)
    })
}
