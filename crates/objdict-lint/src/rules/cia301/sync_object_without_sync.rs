use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Object, Place};
use crate::{rule, stated};

rule! {
    "cia301/sync-object-without-sync", Warning, Object(check);
    summary: "the device has a SYNC object but no COB-ID for SYNC",
    checks: "Whether a device with 1006h (communication cycle period), 1007h (synchronous window length) or 1019h (synchronous counter overflow value) has 1005h, the COB-ID of SYNC.",
    why: "Period, window and counter belong to a SYNC message that the device does not support.",
    example: "`[1006]` without `[1005]`",
    remedy: "Add 1005h, or remove the object.",
    source: "CiA 301 §7.5.2.6, §7.5.2.7, §7.5.2.22",
}

fn check(device: &Device, index: u16, _: &Object, findings: &mut Findings) {
    let name = match index {
        0x1006 => "communication cycle period",
        0x1007 => "synchronous window length",
        0x1019 => "synchronous counter overflow value",
        _ => return,
    };
    if stated::is_there(device, 0x1005) {
        return;
    }
    let message = say!("{:04X}h ({}) is described without 1005h (COB-ID SYNC)", index, name);
    let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
    findings.push(finding.help(say!("add 1005h (COB-ID SYNC), or remove {:04X}h", index)));
}
