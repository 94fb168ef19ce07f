use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, DeviceKind, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-last-eds", Note, Device(check);
    summary: "a DCF does not name its EDS",
    checks: "Whether a DCF with more than a file name in `[FileInfo]` has `LastEDS`.",
    why: "Tools cannot check whether the configuration matches the device, or update it to a newer EDS.",
    example: "A DCF without `LastEDS`",
    remedy: "Write the file name of the EDS.",
    source: "CiA 306-1 §5.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = device.file_info.as_ref().filter(|_| device.kind == DeviceKind::Node) else { return };
    let is_named = info.last_eds.as_ref().is_some_and(|name| !name.is_empty());
    if is_named || info.eds_version.is_none() {
        return;
    }
    let place = Place::of(Part::FileInfo).field(Field::LastEds);
    let finding = Diagnostic::new(&RULE.info, place, "the file does not name its EDS");
    findings.push(finding.help(say!("write the file name of the EDS as `{LastEDS}`")));
}
