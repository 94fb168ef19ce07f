use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia406/preset-outside-range", Warning, Applied(check);
    summary: "the preset of an encoder is outside the measuring range",
    checks: "Whether 6003h (preset value) is from 0 to one less than 6002h (measuring range), configured or default. A measuring range of 0 has its own rule.",
    why: "Positions are smaller than the measuring range, so the encoder rejects the preset or shows another position.",
    example: "`[6002]` with `DefaultValue=4096`, `[6003]` with `DefaultValue=5000`",
    remedy: "Write a preset inside the measuring range.",
    source: "CiA 406 (6002h, 6003h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let [range, preset] = [0x6002, 0x6003].map(|index| index_in(applied.block, index));
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let (Some(units), Some(position)) = (value(range), value(preset)) else { return };
    if units > 0 && !(0..units).contains(&position) {
        let message = say!("the preset `{}` is outside the measuring range of `{}` units", position, units);
        let finding = Diagnostic::new(rule, device.value_place(preset, 0), message);
        let finding = finding.label(device.value_place(range, 0), "the measuring range");
        findings.push(finding.help(say!("write a preset from 0 to {}", units - 1)));
    }
}
