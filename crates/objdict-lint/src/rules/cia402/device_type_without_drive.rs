use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile;
use crate::{Facts, rule};

rule! {
    "cia402/device-type-without-drive", Note, Applied(check);
    summary: "the device type of a drive does not state the kind of drive",
    checks: "Whether 1000h, or 67FFh of an axis, has one of the bits 16 (frequency converter), 17 (servo drive) and 18 (stepper motor) set if it states profile 402. Bits 24 to 31 are manufacturer-specific, and FFFFh in the high word means several devices.",
    why: "Masters select the default PDOs by these bits.",
    example: "`DefaultValue=0x00000192` in `[1000]`",
    remedy: "Set the bit: `0x00020192` for a servo drive.",
    source: "CiA 402-3, device type",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let index = profile::device_type_index(facts.device, applied.block);
    // axes without their own device type have that of 1000h
    if applied.block > 0 && index == 0x1000 {
        return;
    }
    let value = facts.device.object(index).and_then(|object| object.value(0)?.as_integer());
    let Some(value) = value.filter(|value| value & 0xFFFF == 402 && value & 0x7_0000 == 0) else { return };
    let message = say!("the device type `0x{:08X}` does not state the kind of drive", value);
    let place = facts.device.value_place(index, 0);
    let servo = value | 0x2_0000;
    let help = say!("set bit 16, 17 or 18; for a servo drive write `0x{:08X}`", servo);
    findings.push(Diagnostic::new(rule, place, message).help(help));
}
