use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::{rule, stated};

rule! {
    "cia301/missing-module-list", Warning, Device(check);
    summary: "a modular device has no module list",
    checks: "Whether a device with modules in `[SupportedModules]` has 1027h, the module list.",
    why: "A master reads 1027h to identify the modules that are plugged in. Without it, the master cannot compare the station with its configuration.",
    example: "`[SupportedModules]` with `NrOfEntries=2`, without `[1027]`",
    remedy: "Add 1027h, an ARRAY of UNSIGNED16 with an element for each module, or describe it as a fixed object of the modules.",
    source: "CiA 301 §7.5.2.30, CiA 306-1 §6.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(modules) = device.modules.as_ref().filter(|modules| !modules.supported.is_empty()) else {
        return;
    };
    let by_module = modules
        .supported
        .values()
        .any(|module| module.fixed.contains_key(&0x1027) || module.extensions.contains_key(&0x1027));
    if by_module || stated::is_there(device, 0x1027) {
        return;
    }
    let message = "the device supports modules, but has no module list (1027h)";
    let finding = Diagnostic::new(&RULE.info, Place::of(Part::SupportedModules), message);
    findings.push(finding.help("add 1027h (module list, ARRAY of UNSIGNED16)"));
}
