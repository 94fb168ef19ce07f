use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::{device_type_index, index_in};
use crate::{Facts, rule};

rule! {
    "cia406/position-too-long", Warning, Applied(check);
    summary: "the positions of an encoder do not fit into 32 bits",
    checks: "Whether resolution (6501h) times revolutions (6502h) of a rotary encoder is at most 2^32, unless it has a position of high precision (6008h).",
    why: "The position wraps to 0 before the encoder reaches its number of revolutions.",
    example: "`[6501]` with `DefaultValue=0x01000000`, `[6502]` with `DefaultValue=4096`: 36 bits",
    remedy: "Correct resolution or revolutions, or offer 6008h.",
    source: "CiA 406 (6004h, 6008h, 6501h, 6502h)",
}

/// The number of positions that 32 bits can distinguish.
const POSITIONS: i128 = 1 << 32;

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let [resolution, revolutions] = [0x6501, 0x6502].map(|index| index_in(block, index));
    let turns = value(device_type_index(device, block)).is_some_and(|kind| (1..=5).contains(&(kind >> 16)));
    let is_longer = device.objects.contains_key(&index_in(block, 0x6008));
    let (Some(steps), Some(turned)) = (value(resolution), value(revolutions)) else { return };
    if turns && !is_longer && steps * turned > POSITIONS {
        let message =
            say!("{} steps times {} revolutions do not fit into a position of 32 bits", steps, turned);
        let finding = Diagnostic::new(rule, device.value_place(revolutions, 0), message);
        let finding = finding.label(device.value_place(resolution, 0), "steps per revolution");
        findings
            .push(finding.help("correct resolution or revolutions, or add 6008h (high precision position)"));
    }
}
