use super::other_device::difference;
use crate::configured::Configured;
use crate::diagnostic::{At, Diagnostic, Findings, say};
use crate::model::Field;
use crate::rule;

rule! {
    "configuration/other-revision", Warning, Configured(check);
    summary: "a configuration is for another revision than its EDS",
    checks: "Whether `RevisionNumber` of a DCF is that of its EDS, and the revision number in 1018h too.",
    why: "A manager that compares the revision does not boot the node, and objects of the other revision can differ.",
    example: "`RevisionNumber=0x00010000` in the DCF, and `RevisionNumber=0x00020000` in the EDS",
    remedy: "Make the DCF anew from the EDS of the device, or name the EDS that it was made from.",
    source: "CiA 306-1 §4.4, §5.3; CiA 301 §7.5.2.21",
}

fn check(configured: &Configured<'_>, findings: &mut Findings) {
    let (device, origin) = (configured.device, configured.written);
    let found = difference(device, origin, &Field::RevisionNumber, |info| info.revision_number, 3);
    let Some((place, is, other, wanted)) = found else { return };
    let message = say!("the revision number is `0x{:08X}`, but that of the {EDS} is `0x{:08X}`", is, wanted);
    let finding = Diagnostic::new(&RULE.info, place, message).label(At::Node(0, other), say!("in the {EDS}"));
    findings.push(finding.help(say!("make the configuration anew from this {EDS}")));
}
