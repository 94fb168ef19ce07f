use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia406/value-beyond-resolution", Warning, Applied(check);
    summary: "a setting of an encoder exceeds its resolution",
    checks: "Whether 6001h (measuring units per revolution) is not above 6501h (resolution), and 6003h (preset value), if there is no 6002h (measuring range), below 6501h times 6502h (revolutions), configured or default. Values of 0 have other rules.",
    why: "The encoder cannot resolve the units: it rejects the value, or positions are left out.",
    example: "`[6501]` with `DefaultValue=8192`, `[6001]` with `ParameterValue=10000`",
    remedy: "Write a value that the encoder can resolve.",
    source: "CiA 406 (6001h, 6003h, 6501h, 6502h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let value = |index: u16| device.object(at(index))?.value(0)?.as_integer().filter(|&value| value > 0);
    let Some(resolution) = value(0x6501) else { return };
    let mut report = |index: u16, message| {
        let finding = Diagnostic::new(rule, device.value_place(at(index), 0), message);
        let finding = finding.label(device.value_place(at(0x6501), 0), "the resolution");
        findings.push(finding.help("write a value that the encoder can resolve"));
    };
    if let Some(units) = value(0x6001).filter(|&units| units > resolution) {
        report(0x6001, say!("`{}` units per revolution are more than the {} steps", units, resolution));
    }
    let steps = resolution * value(0x6502).unwrap_or(1);
    if let Some(preset) = value(0x6003).filter(|&preset| preset >= steps && value(0x6002).is_none()) {
        report(0x6003, say!("the preset `{}` is beyond the {} steps of the encoder", preset, steps));
    }
}
