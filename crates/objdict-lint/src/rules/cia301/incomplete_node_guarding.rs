use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Place};
use crate::{rule, stated};

rule! {
    "cia301/incomplete-node-guarding", Error, Device(check);
    summary: "one of the two objects of node guarding is missing",
    checks: "Whether 100Ch (guard time) and 100Dh (life time factor) are there together or not at all.",
    why: "The life time is the product of the two; a device with one of them cannot notice that its master has gone.",
    example: "`[100C]` without `[100D]`",
    remedy: "Add the other one, or remove both and use the heartbeat.",
    source: "CiA 301 §7.5.2.11, §7.5.2.12",
}

fn check(device: &Device, findings: &mut Findings) {
    let names = [(0x100C, "guard time"), (0x100D, "life time factor")];
    for ((index, name), (other, other_name)) in [(names[0], names[1]), (names[1], names[0])] {
        if device.objects.contains_key(&index) && !stated::is_there(device, other) {
            let message = say!("{:04X}h ({}) is there without {:04X}h ({})", index, name, other, other_name);
            let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
            findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", other, index)));
        }
    }
}
