use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{Field, Place};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia406/contradictory-copy", Warning, Applied(check);
    summary: "two objects of an encoder that have one value differ",
    checks: "Whether 6500h (operating status) has the value of 6000h (operating parameters), and 650Bh the serial number of 1018h sub-index 4, by their defaults. A serial number of 0 is not compared.",
    why: "The status is what the parameters switch on, so one of the values is not that of the device: a master that compares them rejects the configuration.",
    example: "`[6000]` with `DefaultValue=0x0004`, `[6500]` with `DefaultValue=0x0000`",
    remedy: "Write the same value to both, in the description and in the device.",
    source: "CiA 406 (6000h, 6500h, 650Bh)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    // a configuration changes only one of them
    let value = |(index, sub): (u16, u8)| device.object(index)?.entry(sub)?.default.as_ref()?.as_integer();
    let pairs = [((at(0x6500), 0), (at(0x6000), 0), true), ((at(0x650B), 0), (0x1018, 4), false)];
    for (copy, original, may_be_0) in pairs {
        let (Some(shown), Some(right)) = (value(copy), value(original)) else { continue };
        if shown == right || (!may_be_0 && (shown == 0 || right == 0)) {
            continue;
        }
        let name = |(index, sub): (u16, u8)| match sub {
            0 => say!("{:04X}h", index),
            _ => say!("{:04X}h sub-index {}", index, sub),
        };
        let message = say!("{} is `0x{:X}`, but {} is `0x{:X}`", name(copy), shown, name(original), right);
        let place = |(index, sub): (u16, u8)| match sub {
            0 => Place::object(index).field(Field::DefaultValue),
            _ => Place::entry(index, sub).field(Field::DefaultValue),
        };
        let finding = Diagnostic::new(rule, place(copy), message).label(place(original), "the same value");
        findings.push(finding.help("write the same value to both"));
    }
}
