use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::{device_type_index, index_in};
use crate::{Facts, rule};

rule! {
    "cia406/revolutions-of-single-turn", Warning, Applied(check);
    summary: "a single-turn encoder has more than one revolution",
    checks: "Whether 6502h of an encoder of type 1 (absolute, single-turn) is 1. Type 3 is not checked because it counts revolutions.",
    why: "Either the type is wrong, or a master that multiplies resolution and revolutions computes a wrong measuring range.",
    example: "`[1000]` with `DefaultValue=0x00010196`, `[6502]` with `DefaultValue=4096`",
    remedy: "Write 1, or the type of a multi-turn encoder.",
    source: "CiA 406 (1000h, 6502h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let (device_type, index) = (device_type_index(device, block), index_in(block, 0x6502));
    let (Some(kind), Some(revolutions)) = (value(device_type), value(index)) else { return };
    if kind >> 16 == 1 && revolutions > 1 {
        let message = say!("a single-turn encoder has `{}` revolutions", revolutions);
        let finding = Diagnostic::new(rule, device.value_place(index, 0), message);
        let finding = finding.label(device.value_place(device_type, 0), "type 1, single-turn");
        findings.push(finding.help("write 1 or the type of a multi-turn encoder"));
    }
}
