use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::DeviceKind;
use crate::{Facts, rule};

rule! {
    "cia304/invalid-cob-id-pair", Error, Facts(check);
    summary: "the two COB-IDs of an SRDO are not a valid pair",
    checks: "Whether COB-ID 1 of each active SRDO is an odd CAN-ID from 101h to 17Fh, and COB-ID 2 the next one. A formula is evaluated for the node of a DCF. The defaults FFh and 100h, to which stacks add twice the node-ID, are accepted in an EDS.",
    why: "The data are sent twice, plain and inverted, with identifiers that differ in at least two bits, so that a corrupted frame is never accepted as its counterpart. A device rejects any other pair.",
    example: "`[1301sub5]` with `DefaultValue=0x101` and `[1301sub6]` with `DefaultValue=0x103`",
    remedy: "Write an odd CAN-ID and the next one; the default of the standard is FFh and 100h plus twice the node-ID.",
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
            let message =
                say!("COB-ID 1 of {} is `{:X}h`, which is not an odd CAN-ID from 101h to 17Fh", srdo, plain);
            Diagnostic::new(&RULE.info, place(5), message)
        } else if inverted != plain + 1 {
            let message = say!(
                "COB-ID 2 of {} is `{:X}h`, which does not follow COB-ID 1 `{:X}h`",
                srdo,
                inverted,
                plain
            );
            Diagnostic::new(&RULE.info, place(6), message).label(place(5), "COB-ID 1")
        } else {
            continue;
        };
        findings.push(
            finding.help("write an odd CAN-ID from 101h to 17Fh as COB-ID 1 and the next one as COB-ID 2"),
        );
    }
}
