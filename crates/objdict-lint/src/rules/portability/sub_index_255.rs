use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::rule;

rule! {
    "portability/sub-index-255", Warning, Device(check);
    summary: "an object describes its structure in sub-index FFh",
    checks: "Whether an object has sub-index FFh, which CiA 301 gives to the object type and data type of the object.",
    why: "dcf-tools takes 254 for the last sub-index and refuses the file.",
    example: "`[2000subFF]`",
    remedy: "Remove the sub-index where the device need not have it; else give the tool a copy without it.",
    source: "dcf-tools 2.4.2",
}

fn check(device: &Device, findings: &mut Findings) {
    for (&index, object) in &device.objects {
        if object.subs.get(0xFF).is_some() && !object.orphan {
            let message = say!("{:04X}h has sub-index FFh", index);
            let finding = Diagnostic::new(&RULE.info, Place::entry(index, 0xFF), message);
            findings.push(finding.help("give the tool a copy without it"));
        }
    }
}
