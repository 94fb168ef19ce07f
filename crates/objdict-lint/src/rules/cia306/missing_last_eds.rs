use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, DeviceKind, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-last-eds", Note, Device(check);
    summary: "a DCF does not name the EDS that it was made from",
    checks: "Whether a DCF with a `[FileInfo]` that says more than its name has `LastEDS`.",
    why: "Nobody can find out whether the configuration is up to date with the device, or take over another EDS of it.",
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
    let finding = Diagnostic::new(&RULE.info, place, "the file does not name the EDS that it was made from");
    findings.push(finding.help(say!("write the file name of the EDS as `{LastEDS}`")));
}
