use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Identity, Place};
use crate::rule;

rule! {
    "cia301/missing-vendor-id", Error, Device(check);
    summary: "the identity object has no vendor-ID",
    checks: "Whether 1018h has sub-index 1. The other entries are optional.",
    why: "The vendor-ID is the only mandatory entry of the identity object. Managers compare it with 1F85h, and product code and revision number have no meaning without it.",
    example: "`[1018]` with only `[1018sub0]` and `[1018sub2]`",
    remedy: "Describe `[1018sub1]`, a read-only UNSIGNED32 with the vendor-ID assigned by CiA as its default.",
    source: "CiA 301 §7.5.2.21",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(Identity::INDEX) else { return };
    if object.orphan || object.has(1) || !object.object_type().has_subs() {
        return;
    }
    let place = Place::object(Identity::INDEX);
    let finding =
        Diagnostic::new(&RULE.info, place, "the identity object 1018h has no sub-index 1, the vendor-ID");
    findings.push(finding.help(say!(
        "add `{[1018sub1]}` with `{DataType=0x0007}`, `{AccessType=ro}` and the vendor-ID as `{DefaultValue}`"
    )));
}
