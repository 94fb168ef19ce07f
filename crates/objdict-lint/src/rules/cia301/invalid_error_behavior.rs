use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::Device;
use crate::rule;

rule! {
    "cia301/invalid-error-behavior", Error, Device(check);
    summary: "an error behavior has a reserved value",
    checks: "Whether each value of 1029h is 0 (change to pre-operational), 1 (no change), 2 (change to stopped), or manufacturer-specific from 128 on.",
    why: "A device rejects the value, and a manager does not know how the device reacts to a communication error.",
    example: "`[1029sub1]` with `DefaultValue=3`",
    remedy: "Write the behavior of the device.",
    source: "CiA 301 §7.5.2.32",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1029) else { return };
    for sub in 1..=254 {
        let value = object.value(sub).and_then(|value| value.as_integer());
        let Some(value) = value.filter(|value| (3..128).contains(value)) else { continue };
        let message = say!("error behavior `{}` in sub-index {} of 1029h is reserved", value, sub_index(sub));
        let finding = Diagnostic::new(&RULE.info, device.value_place(0x1029, sub), message);
        findings.push(finding.help("write 0 for pre-operational, 1 for no change or 2 for stopped"));
        if object.compact.is_some() {
            return; // all sub-indexes share one value
        }
    }
}
