use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say, series};
use crate::profile::{device_type_index, number_of};
use crate::{Facts, channels, rule};

rule! {
    "cia401/device-type-without-channels", Error, Applied(check), fix Unsafe;
    summary: "the device type names channels that the module does not have",
    checks: "Whether there is an object for each kind of channel that 1000h names, in any width: bit 16 for digital inputs (6000h, 6100h, 6120h or 6020h to 6027h), bit 17 for digital outputs (6200h, 6300h, 6320h, 6220h to 6227h), bit 18 for analogue inputs (6400h to 6404h), bit 19 for analogue outputs (6410h to 6414h). In a module of several logical devices the types are those of 67FFh and each 800h behind it. What a module may bring is not missed.",
    why: "A master goes by the device type: it looks for the channels, and for the PDOs that carry them. In real files it is nearly always that of a sibling that has more, so nothing works by it.",
    example: "`[1000]` with `DefaultValue=0x000F0191`, and no analogue channels",
    remedy: "Clear the bit, or describe the channels.",
    source: "CiA 401 (1000h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let index = device_type_index(device, block);
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer());
    let Some(value) = value.filter(|_| number_of(device, block) == applied.profile.number) else { return };
    let missing = channels::KINDS.iter().filter(|kind| value >> kind.bit & 1 == 1);
    let missing: Vec<_> = missing.filter(|kind| !kind.may_be_in(device, block)).collect();
    if missing.is_empty() {
        return;
    }
    let names = series(missing.iter().map(|kind| kind.name));
    let message = say!("the device type says {}, and there are no objects for them", names);
    let cleared = missing.iter().fold(value, |value, kind| value & !(1 << kind.bit));
    let place = device.value_place(index, 0);
    let finding = Diagnostic::new(rule, place.clone(), message);
    let text = format!("0x{cleared:08X}");
    let finding = finding.help(say!("write `{}`, or describe the channels", text));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", text)).set(place, text)));
}
