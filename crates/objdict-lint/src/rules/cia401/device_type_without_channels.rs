use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say, series};
use crate::profile::device_type_index;
use crate::{Facts, channels, rule};

rule! {
    "cia401/device-type-without-channels", Error, Applied(check), fix Unsafe;
    summary: "the device type states channels that the module does not have",
    checks: "Whether there is an object of any width for each kind of channel that 1000h states: bit 16 for digital inputs (6000h, 6100h, 6120h or 6020h to 6027h), bit 17 for digital outputs (6200h, 6300h, 6320h, 6220h to 6227h), bit 18 for analogue inputs (6400h to 6404h), bit 19 for analogue outputs (6410h to 6414h). In a device with several logical devices the types are in 67FFh and each object 800h further. Channels that a module of a modular device may add are not reported. The PDOs of channels that the module does not have are not demanded.",
    why: "A master relies on the device type: it uses the channels and the PDOs that carry them. In real files the device type is nearly always copied from a larger device of the same family.",
    example: "`[1000]` with `DefaultValue=0x000F0191`, and no analogue channels",
    remedy: "Clear the bit, or describe the channels.",
    source: "CiA 401 (1000h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let index = device_type_index(device, block);
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer());
    let missing: Vec<_> = channels::only_stated(device, block).collect();
    let Some(value) = value.filter(|_| !missing.is_empty()) else { return };
    let names = series(missing.iter().map(|kind| kind.name));
    let message = say!("the device type states {}, but there are no objects for them", names);
    let cleared = missing.iter().fold(value, |value, kind| value & !(1 << kind.bit));
    let place = device.value_place(index, 0);
    let finding = Diagnostic::new(rule, place.clone(), message);
    let text = format!("0x{cleared:08X}");
    let finding = finding.help(say!("write `{}` or describe the channels", text));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", text)).set(place, text)));
}
