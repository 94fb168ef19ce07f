use crate::diagnostic::{Diagnostic, Findings, say, series_or};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/lss-without-identity", Warning, Device(check);
    summary: "the device supports LSS, but its identity is incomplete",
    checks: "Whether 1018h of a device with `LSS_Supported=1` has vendor-ID, product code, revision number and serial number.",
    why: "LSS addresses a device by these four numbers. A device without one of them cannot be selected.",
    example: "`LSS_Supported=1` and a 1018h that ends with sub-index 1",
    remedy: "Describe sub-indexes 1 to 4 of 1018h, or write `LSS_Supported=0`.",
    source: "CiA 305, CiA 301 §7.5.2.21",
}

const NAMES: [&str; 4] = ["vendor-ID", "product code", "revision number", "serial number"];

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    // another rule reports a missing 1018h
    let Some(identity) = device.object(0x1018).filter(|_| info.lss_supported == Some(true)) else { return };
    let missing: Vec<&str> =
        (1..).zip(NAMES).filter(|&(sub, _)| identity.entry(sub).is_none()).map(|(_, name)| name).collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("`{LSS_Supported}` is {LSS_Supported:1}, but 1018h has no {}", series_or(&missing));
    let finding = Diagnostic::new(&RULE.info, Place::object(0x1018), message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS is supported");
    findings.push(finding.help(say!("describe sub-indexes 1 to 4 of 1018h, or write `{LSS_Supported=0}`")));
}
