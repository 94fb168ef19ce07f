use crate::diagnostic::{Diagnostic, Findings, Severity};
use crate::model::{Device, Identity};
use crate::{is_unstated, rule};

rule! {
    "cia301/vendor-id-zero", Warning, Device(check);
    summary: "the vendor-ID is 0 or not stated",
    checks: "Whether the value of 1018h sub-index 1 is not 0. A missing value is a note. In public files, 30 in 100 have 0 and 12 have no value: demonstrations, tests and software masters without a vendor-ID, where the finding is correct.",
    why: "CiA assigns vendor-IDs and never assigns 0: two devices with 0 cannot be distinguished, LSS cannot address them, and a conformance test fails.",
    example: "`[1018sub1]` with `DefaultValue=0x00000000`",
    remedy: "Write the vendor-ID that CiA assigned to the vendor. For a description that never leaves the laboratory, turn the rule off.",
    source: "CiA 301 §7.5.2.21",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(Identity::INDEX) else { return };
    let place = device.value_place(Identity::INDEX, 1);
    let help = "write the vendor-ID that CiA assigned to the vendor of the device";
    if device.identity().vendor_id == Some(0) {
        let message = "the vendor-ID is `0`, which CiA never assigns";
        findings.push(Diagnostic::new(&RULE.info, place, message).help(help));
    } else if is_unstated(object, 1) {
        let finding = Diagnostic::new(&RULE.info, place, "the vendor-ID has no value");
        findings.push(finding.severity(Severity::Note).help(help));
    }
}
