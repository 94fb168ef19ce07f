use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Part, Place};
use crate::rule;

rule! {
    "portability/tool-list", Error, Device(check);
    summary: "a tool does not know `[Tools]`",
    checks: "Whether the file has a section `[Tools]`.",
    why: "dcf-tools refuses a file with unknown sections; python-canopen and CANopenEditor write files without the sections.",
    example: "`[Tools]` and `[Tool1]`",
    remedy: "Use a copy without the sections for the tool. No device needs them.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    if !device.tools.is_empty() {
        let finding =
            Diagnostic::new(&RULE.info, Place::of(Part::Tools), say!("some tools do not know `{[Tools]}`"));
        findings.push(finding.help(say!("use a copy without the {sections} for the tool")));
    }
}
