use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/no-error-control", Error, Device(check);
    summary: "the device has neither a heartbeat nor node guarding",
    checks: "Whether the device has 1017h (producer heartbeat time), or one of 100Ch and 100Dh (node guarding).",
    why: "CiA 301 requires one of the two. Without it, the loss of the device is not detected.",
    example: "a device with only 1000h, 1001h and 1018h",
    remedy: "Add 1017h, a writable UNSIGNED16; CiA recommends the heartbeat.",
    source: "CiA 301 §7.5.2.11, §7.5.2.12, §7.5.2.20",
}

fn check(device: &Device, findings: &mut Findings) {
    // another rule reports a fragment, a file without any communication object
    if [0x1017, 0x100C, 0x100D].into_iter().any(|index| stated::is_there(device, index))
        || device.objects.range(0x1000..0x2000).next().is_none()
    {
        return;
    }
    let message =
        "the device has no error control: neither a heartbeat (1017h) nor node guarding (100Ch, 100Dh)";
    findings.push(
        Diagnostic::new(&RULE.info, Place::device(), message).help("add 1017h (producer heartbeat time)"),
    );
}
