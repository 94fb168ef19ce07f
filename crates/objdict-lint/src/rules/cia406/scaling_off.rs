use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::index_in;
use crate::{Facts, rule, with_others};

rule! {
    "cia406/scaling-off", Warning, Applied(check);
    summary: "a configuration scales the position of an encoder, but scaling is switched off",
    checks: "Whether bit 2 of 6000h is set when a configuration (DCF or XDC) sets 6001h (measuring units per revolution) or 6002h (measuring range) to another value than the default.",
    why: "Without the bit, the encoder ignores the values and sends its physical position: the master computes with another resolution.",
    example: "`[6001]` with `ParameterValue=3600` and `DefaultValue=8192`, `[6000]` with `ParameterValue=0`",
    remedy: "Set bit 2 of 6000h, or remove the values.",
    source: "CiA 406 (6000h to 6002h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let control = facts.number(at(0x6000), 0);
    let mut scaled = [0x6001, 0x6002].map(at).into_iter().filter(|&index| {
        let entry = device.object(index).map(|object| &object.main);
        entry.is_some_and(|entry| {
            entry.configured_value().is_some_and(|value| entry.default.as_ref() != Some(value))
        })
    });
    let Some(first) = scaled.next().filter(|_| control.is_some_and(|control| control & 4 == 0)) else {
        return;
    };
    let message = say!("{:04X}h is configured, but bit 2 of {:04X}h switches scaling off", first, at(0x6000));
    let finding = Diagnostic::new(rule, device.value_place(first, 0), message);
    let finding = finding.label(device.value_place(at(0x6000), 0), "bit 2 is not set");
    let others = scaled.map(|index| (device.value_place(index, 0), "also here"));
    findings.push(with_others(finding, others).help("set bit 2, or remove the values"));
}
