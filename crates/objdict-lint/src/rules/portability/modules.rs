use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    "portability/modules", Error, Device(check);
    summary: "a tool does not know modules",
    checks: "Whether the file describes modules: `[SupportedModules]` and the sections `[Mx…]`.",
    why: "dcf-tools refuses a file with such sections. python-canopen reads only the device without the objects of the modules.",
    example: "`[SupportedModules]`",
    remedy: "Use a file of the device with its connected modules for the tool.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.modules.is_some() {
        let finding =
            Diagnostic::new(&RULE.info, Place::of(Part::SupportedModules), "the file describes modules");
        findings.push(finding.help("use a file of the device with its connected modules for the tool"));
    }
}
