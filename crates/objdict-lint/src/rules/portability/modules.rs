use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    /// modules are unknown to a tool
    ///
    /// ## What it checks
    /// Whether the file describes modules: `[SupportedModules]` and the sections `[Mx…]`.
    ///
    /// ## Why it matters
    /// dcf-tools refuses a file with such sections. python-canopen reads the device alone and does not see what its modules add.
    ///
    /// ## Example
    /// `[SupportedModules]`
    ///
    /// ## How to mend
    /// Write one file of the device with the modules that are plugged in.
    ///
    /// ## Source
    /// dcf-tools 2.4.2, python-canopen 2.4.1
    "portability/modules", Warning, Device(check)
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
