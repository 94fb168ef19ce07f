use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/gap-in-sdo-numbers", Warning, Device(check);
    summary: "the numbers of the SDO channels have a gap",
    checks: "Whether each additional SDO server (1201h to 127Fh) and SDO client (1280h to 12FFh) follows the previous one.",
    why: "CiA 301 numbers the channels consecutively. Managers that assign channels stop at the first missing index.",
    example: "`[1281]` without `[1280]`",
    remedy: "Use the next free index, or describe the missing channels.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34",
}

fn check(device: &Device, findings: &mut Findings) {
    for (first, last, what) in [(0x1201_u16, 0x127F, "SDO server"), (0x1280, 0x12FF, "SDO client")] {
        for (&index, _) in device.objects.range(first + 1..=last) {
            if !stated::is_there(device, index - 1) {
                let message = say!(
                    "{:04X}h is described, but the previous {}, {:04X}h, is missing",
                    index,
                    what,
                    index - 1
                );
                let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
                findings.push(finding.help("use the next free index, or describe the missing channels"));
                break;
            }
        }
    }
}
