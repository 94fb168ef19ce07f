use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia406/unsupported-alarm", Warning, Applied(check);
    summary: "an alarm or a warning is set that the encoder does not support",
    checks: "Whether the bits of 6503h (alarms) and 6505h (warnings) that are set are also set in 6504h (supported alarms) and 6506h (supported warnings), configured or default.",
    why: "A master evaluates only the supported bits, so it overlooks the alarm or takes it for an error of the device.",
    example: "`[6503]` with `DefaultValue=0x0002`, `[6504]` with `DefaultValue=0x0001`",
    remedy: "Correct one of the two values. Alarms and warnings are 0 by default.",
    source: "CiA 406 (6503h to 6506h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for (set, supported, name) in [(0x6503, 0x6504, "alarm"), (0x6505, 0x6506, "warning")] {
        let [set, supported] = [set, supported].map(|index| index_in(applied.block, index));
        let value = |index: u16| device.object(index)?.value(0)?.as_integer();
        let (Some(bits), Some(known)) = (value(set), value(supported)) else { continue };
        if bits & !known != 0 {
            let message =
                say!("{:04X}h sets `0x{:04X}`, which is not a supported {}", set, bits & !known, name);
            let finding = Diagnostic::new(rule, device.value_place(set, 0), message);
            let finding = finding.label(device.value_place(supported, 0), "supported");
            findings.push(finding.help("write 0, or set the bit in the supported ones"));
        }
    }
}
