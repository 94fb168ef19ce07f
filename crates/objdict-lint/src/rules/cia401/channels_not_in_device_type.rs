use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, say, series};
use crate::model::Place;
use crate::profile::{device_type_index, number_of};
use crate::{Facts, channels, rule};

rule! {
    "cia401/channels-not-in-device-type", Warning, Applied(check), fix Unsafe;
    summary: "the module has channels that its device type does not state",
    checks: "Whether 1000h states each kind of channel that the description has objects for: bit 16 for digital inputs, bit 17 for digital outputs, bit 18 for analogue inputs, bit 19 for analogue outputs.",
    why: "A master that relies on the device type does not use these channels.",
    example: "`[6401]`, and `[1000]` with `DefaultValue=0x00030191`",
    remedy: "Set the bit, in the description and in the device.",
    source: "CiA 401 (1000h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let index = device_type_index(device, block);
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer());
    let Some(value) = value.filter(|_| number_of(device, block) == applied.profile.number) else { return };
    let unnamed = channels::KINDS.iter().filter(|kind| value >> kind.bit & 1 == 0);
    let unnamed: Vec<_> = unnamed.filter_map(|kind| Some((kind, kind.first_in(device, block)?))).collect();
    if unnamed.is_empty() {
        return;
    }
    let names = series(unnamed.iter().map(|(kind, _)| kind.name));
    let message = say!("the device has {}, but its device type does not state them", names);
    let right = unnamed.iter().fold(value, |value, (kind, _)| value | 1 << kind.bit);
    let place = device.value_place(index, 0);
    let mut finding = Diagnostic::new(rule, place.clone(), message);
    for (kind, index) in unnamed {
        finding = finding.label(Place::object(index), kind.name);
    }
    let text = format!("0x{right:08X}");
    let finding = finding.help(say!("write `{}`", text));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", text)).set(place, text)));
}
