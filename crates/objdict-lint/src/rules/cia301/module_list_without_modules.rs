use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, DeviceKind, Object, Place};
use crate::{canopennode, rule};

rule! {
    "cia301/module-list-without-modules", Warning, Device(check);
    summary: "a device has a module list, but supports no modules",
    checks: "Whether a device with 1027h, the module list, describes the modules that it supports.",
    why: "The numbers in 1027h are those of the described modules. Without the descriptions, a configuration tool cannot offer the modules and cannot add their objects.",
    example: "`[1027]` without `[SupportedModules]`",
    remedy: "Describe the modules, or remove 1027h if the device is not modular.",
    source: "CiA 301 §7.5.2.30, CiA 306-1 §6.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let is_there = |object: &Object| !object.orphan && !canopennode::is_disabled(object);
    let has_modules = device.modules.as_ref().is_some_and(|modules| !modules.supported.is_empty());
    if device.kind == DeviceKind::Type && device.object(0x1027).is_some_and(is_there) && !has_modules {
        let message = say!("1027h is the module list, but no module is described");
        let finding = Diagnostic::new(&RULE.info, Place::object(0x1027), message);
        findings.push(finding.help("describe the supported modules, or remove 1027h"));
    }
}
