use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    "portability/dynamic-channels", Error, Device(check);
    summary: "a tool does not know `[DynamicChannels]`",
    checks: "Whether the file has a section `[DynamicChannels]`.",
    why: "dcf-tools refuses a file with unknown sections; python-canopen and CANopenEditor write files without the section.",
    example: "`[DynamicChannels]`",
    remedy: "Use a copy without the section for the tool; network variables then have no segments.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.dynamic_channels.is_some() {
        let finding = Diagnostic::new(
            &RULE.info,
            Place::of(Part::DynamicChannels),
            say!("`{[DynamicChannels]}` is {a section} of CiA 302"),
        );
        findings.push(finding.help(say!("use a copy without the {section} for the tool")));
    }
}
