use crate::diagnostic::{Diagnostic, Findings, Severity};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/emergency-without-cob-id", Warning, Device(check);
    summary: "the device has an EMCY object but no COB-ID for EMCY",
    checks: "Whether a device with 1015h (inhibit time EMCY) has 1014h, the COB-ID of EMCY. With only 1003h (pre-defined error field) it is a note, because a device may record errors without sending EMCY.",
    why: "The description shows that the device sends EMCY, but not with which CAN-ID.",
    example: "`[1015]` without `[1014]`",
    remedy: "Add 1014h with the default `$NODEID+0x80`.",
    source: "CiA 301 §7.5.2.17, §7.5.2.18",
}

fn check(device: &Device, findings: &mut Findings) {
    if stated::is_there(device, 0x1014) {
        return;
    }
    let help = "add 1014h (UNSIGNED32) with the default `$NODEID+0x80`";
    if device.objects.contains_key(&0x1015) {
        let message = "1015h (inhibit time EMCY) is described without 1014h (COB-ID EMCY)";
        findings.push(Diagnostic::new(&RULE.info, Place::object(0x1015), message).help(help));
    } else if device.objects.contains_key(&0x1003) {
        let message = "1003h (pre-defined error field) is described without 1014h (COB-ID EMCY)";
        let finding = Diagnostic::new(&RULE.info, Place::object(0x1003), message).help(help);
        findings.push(finding.severity(Severity::Note));
    }
}
