use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/eds-version", Warning, Device(check), fix Unsafe;
    summary: "`EDSVersion` is not a valid version",
    checks: "Whether `EDSVersion` has the form digit, dot, digit. A missing version means 3.0; a missing version and versions before 4.0 are notes.",
    why: "Tools use the version to decide which keys to expect: files of version 3.0 have no `ObjFlags`, no compact storage and no modules. `404` and `4.04` are numbers of other documents.",
    example: "`EDSVersion=404`",
    remedy: "Write `EDSVersion=4.0`.",
    source: "CiA 306-1 §4.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.file_info else { return };
    let place = Place::of(Part::FileInfo).field(Field::EdsVersion);
    let text = info.eds_version.as_deref().unwrap_or_default();
    let (severity, message) = match text.as_bytes() {
        [b'4'..=b'9', b'.', b'0'..=b'9'] => return,
        [] => (Severity::Note, say!("`{EDSVersion}` is missing, which means 3.0").to_owned()),
        [b'0'..=b'3', b'.', b'0'..=b'9'] => (Severity::Note, say!("EDS version {} is outdated", text)),
        _ => (Severity::Warning, say!("`{}` is not a valid EDS version, which has the form `4.0`", text)),
    };
    let fix = Fix::risky(say!("write `{EDSVersion=4.0}`")).set(place.clone(), "4.0");
    let finding = Diagnostic::new(&RULE.info, place, message).severity(severity);
    findings.push(finding.help(say!("write `{EDSVersion=4.0}`")).fix(fix));
}
