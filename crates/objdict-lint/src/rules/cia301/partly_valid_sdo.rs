use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Service, rule};

rule! {
    "cia301/partly-valid-sdo", Error, Facts(check);
    summary: "only one direction of an SDO channel is valid",
    checks: "Whether the two COB-IDs of an SDO server or client (1201h to 12FFh) are both valid or both not valid. A COB-ID is not valid if bit 31 is set or if it is 0, which many stacks write to an unconfigured channel.",
    why: "A channel works only if both COB-IDs are valid. One valid COB-ID occupies a CAN-ID without providing an SDO.",
    example: "`[1280sub1]` with `DefaultValue=0x605` and `[1280sub2]` with `DefaultValue=0x80000585`",
    remedy: "Set bit 31 in both, or clear it in both.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let channels = facts.sdo_channels().filter(|(request, _)| request.service != Service::ServerRequest(1));
    for (request, response) in channels.filter(|(one, other)| one.is_in_use() != other.is_in_use()) {
        let (valid, invalid) = if request.is_in_use() { (request, response) } else { (response, request) };
        let message = say!(
            "{} has a valid COB-ID `{}` in sub-index {}, but the one in sub-index {} is not valid",
            request.service,
            valid.cob_id,
            valid.sub,
            invalid.sub
        );
        let device = facts.device;
        let finding = Diagnostic::new(&RULE.info, device.value_place(valid.index, valid.sub), message)
            .label(device.value_place(invalid.index, invalid.sub), "not valid");
        findings.push(finding.help("set bit 31 in both, or clear it in both"));
    }
}
