use crate::diagnostic::{Diagnostic, Findings, Fix, listing, say};
use crate::model::{DataType, Field, Part, Place};
use crate::{Facts, rule};

rule! {
    "cia306/dummy-below-granularity", Warning, Facts(check), fix Unsafe;
    summary: "a dummy type is smaller than the granularity",
    checks: "Whether the length of each type that `[DummyUsage]` enables is a multiple of `Granularity`. With 0 the mapping is fixed and not checked, and neither is a device whose default mapping contradicts the granularity, which `cia301/mapping-granularity` reports.",
    why: "A device with a granularity of 8 maps whole bytes: it rejects a dummy entry of one bit, although tools offer it.",
    example: "`Granularity=8` and `Dummy0001=1`, which is BOOLEAN",
    remedy: "Write 0 for the type, or the granularity of the device.",
    source: "CiA 306-1 §4.5, §4.6.2",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let granularity = device.device_info.as_ref().and_then(|info| info.granularity);
    let Some(granularity) = granularity.filter(|granularity| (2..=64).contains(granularity)) else { return };
    let is_odd = |bits: u8| !bits.is_multiple_of(granularity);
    // another rule reports a mapping that contradicts the granularity
    if facts.pdos.iter().flat_map(|pdo| &pdo.mapped).any(|mapped| is_odd(mapped.object.bits)) {
        return;
    }
    let Some(usage) = &device.dummy_usage else { return };
    let enabled = usage.types.iter().filter(|(_, enabled)| **enabled).map(|(data_type, _)| *data_type);
    let smaller: Vec<DataType> = enabled
        .filter(|data_type| data_type.is_dummy() && data_type.bit_length().is_some_and(is_odd))
        .collect();
    let Some(first) = smaller.first() else { return };
    let key = |data_type: &DataType| format!("Dummy{:04X}", data_type.0);
    let message = match smaller[..] {
        [one] => say!(
            "`{}` enables {}, which is not a multiple of the granularity of `{}` bits",
            key(&one),
            one,
            granularity
        ),
        _ => say!(
            "{} enable types that are not multiples of the granularity of `{}` bits",
            listing(smaller.iter().map(key)),
            granularity
        ),
    };
    let place = |data_type| Place::of(Part::DummyUsage).field(Field::Named(key(data_type).into()));
    let title = say!("write `{}=0`", key(first));
    let fix = smaller.iter().fold(Fix::risky(title.clone()), |fix, data_type| fix.set(place(data_type), "0"));
    let finding = Diagnostic::new(&RULE.info, place(first), message)
        .label(Place::of(Part::DeviceInfo).field(Field::Granularity), "the granularity");
    findings.push(finding.help(title).fix(fix));
}
