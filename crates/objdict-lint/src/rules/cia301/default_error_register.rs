use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, DeviceKind};
use crate::rule;

rule! {
    "cia301/default-error-register", Warning, Device(check);
    summary: "the description states an error as default",
    checks: "Whether the defaults of 1001h, the error register, and of 1003h sub-index 0, the number of errors in the history, are 0 in an EDS.",
    why: "The default is the value after power-on without a fault. A tool that compares the device with its description reports a difference on a healthy device.",
    example: "`[1001]` with `DefaultValue=1`",
    remedy: "Write 0.",
    source: "CiA 301 §7.5.2.2, §7.5.2.4",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.kind != DeviceKind::Type {
        return;
    }
    for (index, what) in [(0x1001, "the error register"), (0x1003, "the number of errors")] {
        let is_compact = device.object(index).is_some_and(|object| object.compact.is_some());
        let value = device.value(index, 0).and_then(|value| value.as_integer());
        // sub-index 0 of a compactly stored history is the number of its entries
        let Some(value) = value.filter(|&value| value != 0 && !is_compact) else { continue };
        let message = say!("the default of {} is `{}` instead of 0", what, value);
        let finding = Diagnostic::new(&RULE.info, device.value_place(index, 0), message);
        findings.push(finding.help("write 0"));
    }
}
