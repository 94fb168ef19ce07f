use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    "portability/dynamic-channels", Warning, Device(check);
    summary: "`[DynamicChannels]` is unknown to a tool",
    checks: "Whether the file has a section `[DynamicChannels]`.",
    why: "dcf-tools refuses a file with a section that it does not know; python-canopen and CANopenEditor write files without it.",
    example: "`[DynamicChannels]`",
    remedy: "Give the tool a copy without the section; then the network variables have no place to go.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
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
