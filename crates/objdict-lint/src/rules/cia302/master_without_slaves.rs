use crate::demands::{self, Against};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo};
use crate::rule;

rule! {
    "cia302/master-without-slaves", Warning, Against(check);
    summary: "an NMT master has no list of slaves",
    checks: "Whether a device whose 1F80h makes it NMT master (bit 0) has the slave assignment, 1F81h. Modular devices are not checked, because a module may provide the object.",
    why: "The master does not know which nodes to expect: it boots none of them and detects no missing node.",
    example: "`[1F80]` with `DefaultValue=0x00000001`, without `[1F81]`",
    remedy: "Describe 1F81h, or clear bit 0 of 1F80h if the device is not a master.",
    source: "CiA 302-2 (1F80h, 1F81h)",
}

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let value = at.object.value(0).filter(|_| at.index == 0x1F80 && at.has_its_shape());
    let is_master = value.and_then(|value| value.as_integer()).is_some_and(|value| value & 1 == 1);
    if is_master && !demands::is_there(at.device, 0x1F81) {
        let message = "1F80h makes the device NMT master, but it has no slave assignment (1F81h)";
        let finding = Diagnostic::new(rule, at.device.value_place(at.index, 0), message);
        findings.push(finding.help("describe 1F81h, or clear bit 0"));
    }
}
