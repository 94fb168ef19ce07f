use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Device;
use crate::rule;

rule! {
    "cia301/storage-without-function", Warning, Device(check);
    summary: "1010h or 1011h states that the device cannot store or restore anything",
    checks: "Whether a value of 1010h has bit 0 (stores on command) or bit 1 (stores by itself), and one of 1011h bit 0 (restores on command), if all of them are stated.",
    why: "A tool reads the entries before it writes the signatures. With 0 it does not store the configuration, which is lost when the power is switched off.",
    example: "`[1010sub1]` with `DefaultValue=0` and no other sub-index",
    remedy: "Write the value that the device returns, 1 if it stores or restores on command; or remove the object.",
    source: "CiA 301 §7.5.2.13, §7.5.2.14",
}

fn check(device: &Device, findings: &mut Findings) {
    for (index, verb) in [(0x1010, "store"), (0x1011, "restore")] {
        let Some(object) = device.object(index) else { continue };
        let subs: Vec<u8> =
            object.entries().map(|(sub, _)| sub).filter(|sub| (1..=0x7F).contains(sub)).collect();
        let is_zero = |&sub: &u8| object.value(sub).is_some_and(|value| value.as_integer() == Some(0));
        let Some(&first) = subs.first().filter(|_| subs.iter().all(is_zero)) else { continue };
        let message = say!("{:04X}h is `0`: the device can {} nothing", index, verb);
        let finding = Diagnostic::new(&RULE.info, device.value_place(index, first), message);
        findings
            .push(finding.help(say!("write 1 if the device can {} on command, or remove the object", verb)));
    }
}
