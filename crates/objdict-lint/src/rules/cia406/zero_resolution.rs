use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::{device_type_index, index_in};
use crate::{Facts, rule, with_others};

rule! {
    "cia406/zero-resolution", Error, Applied(check);
    summary: "a resolution or a range of an encoder is 0",
    checks: "Whether 6501h (resolution), 6502h (revolutions) of a rotary encoder, 6001h and 6002h (units per revolution and measuring range), and the measuring steps of 6005h are not 0, configured or default.",
    why: "A master computes positions with these values and divides by some of them; an encoder without a step or a revolution measures nothing.",
    example: "`[6501]` with `DefaultValue=0`",
    remedy: "Write the value of the encoder; a single-turn encoder has one revolution.",
    source: "CiA 406 (6001h, 6002h, 6005h, 6501h, 6502h)",
}

/// The values that must not be 0, and whether only rotary encoders have them.
const VALUES: [(u16, u8, bool, &str); 6] = [
    (0x6501, 0, false, "the resolution"),
    (0x6502, 0, true, "the number of revolutions"),
    (0x6001, 0, true, "the number of measuring units per revolution"),
    (0x6002, 0, false, "the measuring range"),
    (0x6005, 1, false, "the position step"),
    (0x6005, 2, false, "the speed step"),
];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16, sub: u8| device.object(index)?.value(sub)?.as_integer();
    let is_rotary =
        value(device_type_index(device, block), 0).is_some_and(|kind| (1..=5).contains(&(kind >> 16)));
    let mut zeros = VALUES.iter().filter_map(|&(index, sub, of_rotary, name)| {
        let index = index_in(block, index);
        let is_zero = value(index, sub) == Some(0) && (is_rotary || !of_rotary);
        is_zero.then(|| (device.value_place(index, sub), name))
    });
    let Some((place, name)) = zeros.next() else { return };
    let finding = Diagnostic::new(rule, place, say!("{} is `0`", name));
    let others = zeros.map(|(place, name)| (place, say!("{} too", name)));
    findings.push(with_others(finding, others).help("write the value of the encoder"));
}
