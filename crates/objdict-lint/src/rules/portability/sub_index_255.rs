use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::rule;

rule! {
    "portability/sub-index-255", Error, Device(check);
    summary: "an object has sub-index FFh",
    checks: "Whether an object has sub-index FFh, the structure of the object in CiA 301.",
    why: "The highest sub-index that dcf-tools allows is 254; it refuses the file.",
    example: "`[2000subFF]`",
    remedy: "Remove the sub-index if the device does not need it; otherwise use a copy without it for the tool.",
    source: "dcf-tools 2.4.2",
}

fn check(device: &Device, findings: &mut Findings) {
    for (&index, object) in &device.objects {
        if object.subs.get(0xFF).is_some() && !object.orphan {
            let message = say!("{:04X}h has sub-index FFh", index);
            let finding = Diagnostic::new(&RULE.info, Place::entry(index, 0xFF), message);
            findings.push(finding.help("use a copy without this sub-index for the tool"));
        }
    }
}
