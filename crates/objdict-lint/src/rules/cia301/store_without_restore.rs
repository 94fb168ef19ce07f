use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/store-without-restore", Note, Device(check);
    summary: "the device stores parameters and cannot restore them",
    checks: "Whether a device with 1010h, store parameters, has 1011h, restore default parameters, and the other way round.",
    why: "Whoever stored a wrong bit rate or COB-ID wants the delivered state back, and restoring means something only where something can be stored.",
    example: "`[1010]`, and no `[1011]`",
    remedy: "Add the other object.",
    source: "CiA 301 §7.5.2.13, §7.5.2.14",
}

fn check(device: &Device, findings: &mut Findings) {
    let pairs = [
        (0x1010, 0x1011, "the device stores parameters, and has no 1011h that restores the defaults"),
        (0x1011, 0x1010, "the device restores defaults, and has no 1010h that stores anything else"),
    ];
    for (there, other, message) in pairs {
        if device.objects.contains_key(&there) && !stated::is_there(device, other) {
            let finding = Diagnostic::new(&RULE.info, Place::object(there), message);
            findings.push(finding.help(say!("add {:04X}h", other)));
        }
    }
}
