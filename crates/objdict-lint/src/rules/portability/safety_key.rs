use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Entry, Field, Part, Place};
use crate::{rule, stated, with_others};

rule! {
    "portability/safety-key", Error, Device(check);
    summary: "a tool does not know the keys of CANopen Safety",
    checks: "Whether an entry has `SRDOMapping` or `InvertedSRAD`, or `[DeviceInfo]` has `CANopenSafetySupported`. The first one is shown with the others.",
    why: "dcf-tools refuses a file with unknown keys; python-canopen and CANopenEditor write files without them.",
    example: "`SRDOMapping=1`",
    remedy: "Use a copy of the file without these keys for the tool.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let info = device.device_info.as_ref().filter(|info| info.safety_supported.is_some());
    let supported = info.map(|_| Place::of(Part::DeviceInfo).field(Field::CanOpenSafetySupported));
    let entries = stated::entries(device).filter_map(|(place, entry)| Some(place.field(field_of(entry)?)));
    let mut places = supported.into_iter().chain(entries);
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, say!("{the key} belongs to CANopen Safety"))
        .help(say!("use a copy without {the key} for the tool"));
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

fn field_of(entry: &Entry) -> Option<Field> {
    let safety = entry.safety.as_ref()?;
    let stated = [
        (Field::SrdoMapping, safety.srdo_mapping.is_some()),
        (Field::InvertedSrad, safety.inverted_srad.is_some()),
    ];
    stated.into_iter().find(|(_, stated)| *stated).map(|(field, _)| field)
}
