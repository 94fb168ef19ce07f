use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::model::{Device, DeviceKind, Place};
use crate::{rule, stated};

rule! {
    "cia306/missing-commissioning", Error, Device(check);
    summary: "a DCF has no node-ID and bit rate",
    checks: "Whether a DCF has a section `[DeviceComissioning]` (the standard spells the name with one m). The finding is a warning if no value is a formula with `$NODEID`: some masters get their node-ID from the application program.",
    why: "Without node-ID and bit rate, the node cannot be addressed, and formulas with `$NODEID` have no value.",
    example: "An EDS that was renamed to .dcf",
    remedy: "Add the section with `NodeID` and `Baudrate`.",
    source: "CiA 306-1 §5.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let says_something = !device.objects.is_empty() || device.device_info.is_some();
    if device.kind == DeviceKind::Node && device.commissioning.is_none() && says_something {
        let message = say!("{section} `{[DeviceComissioning]}` is missing");
        let finding = Diagnostic::new(&RULE.info, Place::device(), message);
        let finding = match stated::first_formula(device) {
            Some(formula) => finding.label(formula, "a formula without a value"),
            None => finding.severity(Severity::Warning),
        };
        findings.push(finding.help(say!("add the {section} with `{NodeID}` and `{Baudrate}`")));
    }
}
