use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    "portability/modules", Warning, Device(check);
    summary: "modules are unknown to a tool",
    checks: "Whether the file describes modules: `[SupportedModules]` and the sections `[Mx…]`.",
    why: "dcf-tools refuses a file with such sections. python-canopen reads the device alone and does not see what its modules add.",
    example: "`[SupportedModules]`",
    remedy: "Write one file of the device with the modules that are plugged in.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.modules.is_some() {
        let finding = Diagnostic::new(
            &RULE.info,
            Place::of(Part::SupportedModules),
            "the device is described with its modules",
        );
        findings
            .push(finding.help("give the tool the description of the device with the modules that it has"));
    }
}
