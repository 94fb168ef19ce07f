use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, Part, Place};
use crate::{is_unstated, rule};

rule! {
    "cia305/incomplete-address", Warning, Device(check);
    summary: "the LSS address of the device is incomplete",
    checks: "Whether 1018h sub-indexes 2 and 3, product code and revision number, have a value on a device with `LSS_Supported=1`. The vendor-ID has its own rule; the serial number is specific to the single device.",
    why: "An LSS manager selects the device by vendor-ID, product code, revision number and serial number. The first three must come from the description.",
    example: "`LSS_Supported=1` without `DefaultValue` in `[1018sub2]`",
    remedy: "Write the values.",
    source: "CiA 305, CiA 301 §7.5.2.21",
}

fn check(device: &Device, findings: &mut Findings) {
    let supports_lss = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(true));
    let Some(object) = device.object(0x1018).filter(|object| supports_lss && object.compact.is_none()) else {
        return;
    };
    for (sub, name) in [(2, "product code"), (3, "revision number")] {
        let has_type = object.subs.get(sub).is_some_and(|entry| entry.data_type.is_some());
        if has_type && is_unstated(object, sub) {
            let message = say!("the {}, part of the LSS address, has no value", name);
            let finding = Diagnostic::new(&RULE.info, device.value_place(0x1018, sub), message)
                .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "the device supports LSS");
            findings.push(finding.help("add the value"));
        }
    }
}
