use crate::diagnostic::{Diagnostic, Findings, Fix, listing, say};
use crate::model::{DataType, Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/dummy-type", Warning, Device(check), fix Safe;
    summary: "a data type is not allowed as a dummy",
    checks: "Whether the types allowed in `[DummyUsage]` are BOOLEAN, an INTEGER or an UNSIGNED of any width.",
    why: "A dummy fills unused bits of an RPDO. Only these types may be mapped as dummies; the device aborts the mapping of any other type.",
    example: "`Dummy0008=1`, which is REAL32",
    remedy: "Write 0 or remove the line. Use UNSIGNED32 for a gap of 32 bits.",
    source: "CiA 301 §7.4.7.1, CiA 306-1 §4.6.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(usage) = &device.dummy_usage else { return };
    let allowed = usage.types.iter().filter(|(_, allowed)| **allowed).map(|(data_type, _)| *data_type);
    let wrong: Vec<DataType> = allowed.filter(|data_type| !data_type.is_dummy()).collect();
    let Some(first) = wrong.first() else { return };
    let key = |data_type: &DataType| format!("Dummy{:04X}", data_type.0);
    let message = match wrong[..] {
        [one] => say!("`{}` is 1, but {} cannot be a dummy", key(&one), one),
        _ => say!("{} allow dummies that no PDO can map", listing(wrong.iter().map(key))),
    };
    let place = |data_type| Place::of(Part::DummyUsage).field(Field::Named(key(data_type).into()));
    let title = say!("write `{}=0`", key(first));
    let fix = wrong.iter().fold(Fix::safe(title.clone()), |fix, data_type| fix.set(place(data_type), "0"));
    findings.push(Diagnostic::new(&RULE.info, place(first), message).help(title).fix(fix));
}
