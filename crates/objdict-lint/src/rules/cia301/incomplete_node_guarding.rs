use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/incomplete-node-guarding", Error, Device(check);
    summary: "one of the two node guarding objects is missing",
    checks: "Whether 100Ch (guard time) and 100Dh (life time factor) are both described or both absent.",
    why: "The node life time is the product of the two. A device with only one of them cannot detect the loss of its master.",
    example: "`[100C]` without `[100D]`",
    remedy: "Add the missing object, or remove both and use the heartbeat.",
    source: "CiA 301 §7.5.2.11, §7.5.2.12",
}

fn check(device: &Device, findings: &mut Findings) {
    let names = [(0x100C, "guard time"), (0x100D, "life time factor")];
    for ((index, name), (other, other_name)) in [(names[0], names[1]), (names[1], names[0])] {
        if device.objects.contains_key(&index) && !stated::is_there(device, other) {
            let message =
                say!("{:04X}h ({}) is described without {:04X}h ({})", index, name, other, other_name);
            let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
            findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", other, index)));
        }
    }
}
