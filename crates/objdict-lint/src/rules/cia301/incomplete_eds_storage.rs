use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/incomplete-eds-storage", Error, Device(check);
    summary: "one of the two objects that hold the EDS is missing",
    checks: "Whether a device that stores its EDS has both 1021h, the file, and 1022h, its format.",
    why: "A tool cannot unpack a file whose format it does not know, and a format alone is of no use.",
    example: "`[1021]`, and no `[1022]`",
    remedy: "Add the other object: 1021h is a DOMAIN, 1022h an UNSIGNED8 or UNSIGNED16 with 0 for a file that is not compressed.",
    source: "CiA 301 §7.5.2.24, §7.5.2.25",
}

fn check(device: &Device, findings: &mut Findings) {
    for (there, other, lacks) in [(0x1021, 0x1022, "the format"), (0x1022, 0x1021, "the file")] {
        if device.objects.contains_key(&there) && !stated::is_there(device, other) {
            let message = say!("{:04X}h is there, and {:04X}h with {} is not", there, other, lacks);
            let finding = Diagnostic::new(&RULE.info, Place::object(there), message);
            findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", other, there)));
        }
    }
}
