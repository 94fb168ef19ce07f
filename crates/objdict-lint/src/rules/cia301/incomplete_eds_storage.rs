use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/incomplete-eds-storage", Error, Device(check);
    summary: "one of the two objects that store the EDS is missing",
    checks: "Whether a device that stores its EDS has both 1021h, the file, and 1022h, its format.",
    why: "A tool cannot unpack a file of unknown format, and a format without the file is useless.",
    example: "`[1021]` without `[1022]`",
    remedy: "Add the missing object: 1021h is a DOMAIN, 1022h an UNSIGNED8 or UNSIGNED16 with 0 for an uncompressed file.",
    source: "CiA 301 §7.5.2.24, §7.5.2.25",
}

fn check(device: &Device, findings: &mut Findings) {
    for (there, other, lacks) in [(0x1021, 0x1022, "format of the EDS"), (0x1022, 0x1021, "stored EDS")] {
        if device.objects.contains_key(&there) && !stated::is_there(device, other) {
            let message = say!("{:04X}h is described without {:04X}h ({})", there, other, lacks);
            let finding = Diagnostic::new(&RULE.info, Place::object(there), message);
            findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", other, there)));
        }
    }
}
