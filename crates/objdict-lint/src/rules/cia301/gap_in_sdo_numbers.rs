use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/gap-in-sdo-numbers", Warning, Device(check);
    summary: "the SDO channels are not numbered without gaps",
    checks: "Whether each additional SDO server (1201h to 127Fh) and SDO client (1280h to 12FFh) follows the one before it.",
    why: "CiA 301 has the channels counted from the first. Managers that assign channels stop at the first index that is not there.",
    example: "`[1281]`, and no `[1280]`",
    remedy: "Use the next free index, or describe the channels in between.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34",
}

fn check(device: &Device, findings: &mut Findings) {
    for (first, last, what) in [(0x1201_u16, 0x127F, "SDO server"), (0x1280, 0x12FF, "SDO client")] {
        for (&index, _) in device.objects.range(first + 1..=last) {
            if !stated::is_there(device, index - 1) {
                let message =
                    say!("{:04X}h is there, and the {} before it, {:04X}h, is not", index, what, index - 1);
                let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
                findings.push(finding.help("use the next free index, or describe those in between"));
                break;
            }
        }
    }
}
