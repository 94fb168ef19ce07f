use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::DeviceKind;
use crate::{Facts, rule};

rule! {
    "cia304/invalid-cob-id-pair", Error, Facts(check);
    summary: "the two COB-IDs of an SRDO are no pair",
    checks: "Whether COB-ID 1 of each SRDO that has a direction is an odd CAN-ID from 101h to 17Fh, and COB-ID 2 the next one. A formula is evaluated for the node of a DCF. The defaults FFh and 100h, to which stacks add twice the node-ID, are accepted in an EDS.",
    why: "The data are sent twice, plain and inverted, under identifiers that differ in two bits at least, so that a damaged frame of one is never taken for the other. A device refuses any other pair.",
    example: "`[1301sub5]` with `DefaultValue=0x101` and `[1301sub6]` with `DefaultValue=0x103`",
    remedy: "Write an odd CAN-ID and the next one: the standard has FFh and 100h plus twice the node-ID.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let is_type = facts.device.kind == DeviceKind::Type;
    for srdo in facts.srdos.iter().filter(|srdo| srdo.is_on()) {
        let (Some(plain), Some(inverted)) = (srdo.cob_id(facts, 5), srdo.cob_id(facts, 6)) else { continue };
        if is_type && (plain, inverted) == (0xFF, 0x100) {
            continue;
        }
        let index = srdo.communication_index();
        let place = |sub| facts.device.value_place(index, sub);
        let is_plain = (0x101..=0x17F).contains(&plain) && plain % 2 == 1;
        let finding = if !is_plain {
            let message = say!("`{:X}h` as COB-ID 1 of {}, which is odd and from 101h to 17Fh", plain, srdo);
            Diagnostic::new(&RULE.info, place(5), message)
        } else if inverted != plain + 1 {
            let message =
                say!("`{:X}h` as COB-ID 2 of {} does not follow `{:X}h`, COB-ID 1", inverted, srdo, plain);
            Diagnostic::new(&RULE.info, place(6), message).label(place(5), "COB-ID 1")
        } else {
            continue;
        };
        findings.push(finding.help("write an odd CAN-ID from 101h to 17Fh, and the next one"));
    }
}
