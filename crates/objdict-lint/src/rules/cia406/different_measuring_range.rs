use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say};
use crate::model::DeviceKind;
use crate::profile::{device_type_index, index_in};
use crate::{Facts, rule};

rule! {
    "cia406/different-measuring-range", Warning, Applied(check), fix Unsafe;
    summary: "the measuring range is not the product of resolution and revolutions",
    checks: "Whether the default of 6002h in the EDS of a rotary encoder is the resolution (6501h) times the revolutions (6502h). Products above 32 bits are not compared.",
    why: "Scaling is off by default, so the measuring range must be the physical one.",
    example: "`[6501]` with `DefaultValue=8192`, `[6502]` with `DefaultValue=4096`, `[6002]` with `DefaultValue=4096`",
    remedy: "Write the product, in the description and in the device.",
    source: "CiA 406 (6002h, 6501h, 6502h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let value = |index: u16| device.object(index)?.value(0)?.as_integer();
    let turns = value(device_type_index(device, block)).is_some_and(|kind| (1..=5).contains(&(kind >> 16)));
    let [range, resolution, revolutions] = [0x6002, 0x6501, 0x6502].map(|index| index_in(block, index));
    let all = (value(range), value(resolution), value(revolutions));
    let (Some(stated), Some(steps), Some(turned)) = all else { return };
    let right = steps * turned;
    // another rule reports a value of 0
    let is_comparable =
        stated > 0 && right > 0 && turns && device.kind == DeviceKind::Type && u32::try_from(right).is_ok();
    if is_comparable && stated != right {
        let message = say!(
            "the measuring range is `{}`, but {} steps times {} revolutions are {}",
            stated,
            steps,
            turned,
            right
        );
        let place = device.value_place(range, 0);
        let finding = Diagnostic::new(rule, place.clone(), message);
        let finding = finding.label(device.value_place(resolution, 0), "steps per revolution");
        let finding = finding.label(device.value_place(revolutions, 0), "revolutions");
        let finding = finding.help(say!("write {}", right));
        findings.push(finding.fix(Fix::risky(say!("write `{}`", right)).set(place, right.to_string())));
    }
}
