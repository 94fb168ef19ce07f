use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Object};
use crate::{rule, stated};

rule! {
    "cia301/listed-entry-missing", Error, Object(check);
    summary: "a list of multiplexed PDOs names an entry that does not exist",
    checks: "Whether each value of an object scanner list (1FA0h to 1FCFh) and the local entry of each value of an object dispatching list (1FD0h to 1FFFh) is described, with all sub-indexes of its block. Modular devices are not checked.",
    why: "The device cannot send the entry, and discards what it receives for it.",
    example: "`[1FA0sub1]` with `DefaultValue=0x01200001`, without `[2000sub1]`",
    remedy: "Describe the entry, or write 0 for an unused place of the list.",
    source: "CiA 301 §7.5.2.39, §7.5.2.40",
}

fn check(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    // the local index of a dispatching list begins 32 bits further up
    let shift = match index {
        0x1FA0..=0x1FCF => 0,
        0x1FD0..=0x1FFF => 32,
        _ => return,
    };
    if device.is_modular() {
        return;
    }
    for (sub, _) in object.entries().filter(|(sub, _)| (1..0xFF).contains(sub)) {
        let value = object.value(sub).and_then(|value| value.as_integer());
        let Some(value) = value.and_then(|value| u64::try_from(value).ok()).filter(|&value| value != 0)
        else {
            continue;
        };
        let [.., block, high, low, first] = (value >> shift).to_be_bytes();
        let target = u16::from_be_bytes([high, low]);
        let last = first.saturating_add(block.saturating_sub(1));
        let lacks = |sub: &u8| device.object(target).and_then(|target| target.entry(*sub)).is_none();
        let Some(missing) = (first..=last).find(lacks) else { continue };
        // an object without a section of its own
        if stated::is_there(device, target) && device.object(target).is_none_or(|target| target.orphan) {
            continue;
        }
        let message =
            say!("{:04X}h names {:04X}h:{:02X}, but there is no such entry", index, target, missing);
        let finding = Diagnostic::new(&RULE.info, device.value_place(index, sub), message);
        findings.push(finding.help("describe the entry, or write 0"));
    }
}
