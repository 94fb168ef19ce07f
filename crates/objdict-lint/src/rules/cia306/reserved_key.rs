use crate::diagnostic::{Diagnostic, Findings, Fix, listing, say};
use crate::model::{Device, DeviceInfo, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/reserved-key", Note, Device(check), fix Safe;
    summary: "`[DeviceInfo]` has a key of EDS version 3.0",
    checks: "Whether `ProductVersion`, `ProductRevision`, `LMT_ManufacturerName`, `LMT_ProductName`, `ExtendedBootUpMaster` or `ExtendedBootUpSlave` is used.",
    why: "Version 4.0 reserves these keys and readers ignore them, so their values have no effect.",
    example: "`ExtendedBootUpMaster=0`",
    remedy: "Remove the keys.",
    source: "CiA 306-1 §4.5",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let keys: Vec<&str> =
        info.extra.iter().map(|(key, _)| key).filter(|key| DeviceInfo::is_reserved(key)).collect();
    let Some(first) = keys.first() else { return };
    let message = say!("readers ignore {} of EDS version 3.0", listing(&keys));
    let place = |key: &str| Place::of(Part::DeviceInfo).field(Field::from_name(key));
    let fix = keys.iter().fold(Fix::safe(say!("remove {the keys}")), |fix, key| fix.remove(place(key)));
    findings
        .push(Diagnostic::new(&RULE.info, place(first), message).help(say!("remove {the keys}")).fix(fix));
}
