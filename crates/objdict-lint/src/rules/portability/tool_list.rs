use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    "portability/tool-list", Warning, Device(check);
    summary: "`[Tools]` is unknown to a tool",
    checks: "Whether the file has a section `[Tools]`.",
    why: "dcf-tools refuses a file with a section that it does not know; python-canopen and CANopenEditor write files without it.",
    example: "`[Tools]` and `[Tool1]`",
    remedy: "Give the tool a copy without the sections, for no device needs them.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
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
