use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    /// `[Tools]` is unknown to a tool
    ///
    /// ## What it checks
    /// Whether the file has a section `[Tools]`.
    ///
    /// ## Why it matters
    /// dcf-tools refuses a file with a section that it does not know; python-canopen and CANopenEditor write files without it.
    ///
    /// ## Example
    /// `[Tools]` and `[Tool1]`
    ///
    /// ## How to mend
    /// Give the tool a copy without the sections, for no device needs them.
    ///
    /// ## Source
    /// dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026
    "portability/tool-list", Warning, Device(check)
}

fn check(device: &Device, findings: &mut Findings) {
    if !device.tools.is_empty() {
        let finding = Diagnostic::new(
            &RULE.info,
            Place::of(Part::Tools),
            say!("`{[Tools]}` lists programs for the device"),
        );
        findings.push(finding.help(say!("give the tool a copy without the {sections}")));
    }
}
