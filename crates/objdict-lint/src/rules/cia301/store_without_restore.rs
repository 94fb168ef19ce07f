use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/store-without-restore", Note, Device(check);
    summary: "the device has only one of 1010h and 1011h",
    checks: "Whether a device with 1010h, store parameters, has 1011h, restore default parameters, and the reverse.",
    why: "After storing a wrong bit rate or COB-ID, users need the delivered state back; and a restore has no use on a device that stores nothing.",
    example: "`[1010]` without `[1011]`",
    remedy: "Add the other object.",
    source: "CiA 301 §7.5.2.13, §7.5.2.14",
}

fn check(device: &Device, findings: &mut Findings) {
    let pairs = [
        (0x1010, 0x1011, "the device can store parameters (1010h), but not restore the defaults (1011h)"),
        (0x1011, 0x1010, "the device can restore the defaults (1011h), but not store parameters (1010h)"),
    ];
    for (there, other, message) in pairs {
        if device.objects.contains_key(&there) && !stated::is_there(device, other) {
            let finding = Diagnostic::new(&RULE.info, Place::object(there), message);
            findings.push(finding.help(say!("add {:04X}h", other)));
        }
    }
}
