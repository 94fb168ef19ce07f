use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    /// `[DynamicChannels]` is unknown to a tool
    ///
    /// ## What it checks
    /// Whether the file has a section `[DynamicChannels]`.
    ///
    /// ## Why it matters
    /// dcf-tools refuses a file with a section that it does not know; python-canopen and CANopenEditor write files without it.
    ///
    /// ## Example
    /// `[DynamicChannels]`
    ///
    /// ## How to mend
    /// Give the tool a copy without the section; then the network variables have no place to go.
    ///
    /// ## Source
    /// dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026
    "portability/dynamic-channels", Warning, Device(check)
}

fn check(device: &Device, findings: &mut Findings) {
    if device.dynamic_channels.is_some() {
        let finding = Diagnostic::new(
            &RULE.info,
            Place::of(Part::DynamicChannels),
            say!("`{[DynamicChannels]}` is {a section} of CiA 302"),
        );
        findings.push(finding.help(say!("give the tool a copy without the {section}")));
    }
}
