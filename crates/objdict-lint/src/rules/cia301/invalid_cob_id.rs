use crate::diagnostic::{Diagnostic, Findings, Fix, Text, joined, say};
use crate::{Facts, rule};

rule! {
    "cia301/invalid-cob-id", Error, Facts(check), fix Unsafe;
    summary: "reserved bits of a COB-ID are set",
    checks: "Whether bits 11 to 28 are clear in each COB-ID with an 11-bit CAN-ID (bit 29 clear), and bit 30 in those of EMCY, where it is reserved. The rule checks SYNC, TIME, EMCY, SDO and PDO and evaluates a formula for the highest node-ID.",
    why: "Some devices reject such a value, others truncate it, so the service uses another CAN-ID. Often a digit is missing: `0x8000000` was meant to be `0x80000000`.",
    example: "`[1804sub1]` with `DefaultValue=0x8000000`",
    remedy: "Check the number of digits: bit 31 is `0x80000000`, and the CAN-ID is in the three lowest digits.",
    source: "CiA 301 §7.5.2.5, §7.5.2.17, §7.5.2.33, §7.5.2.35",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in &facts.cob_ids {
        let bits = cob_id.wrong_bits();
        if bits == 0 {
            continue;
        }
        let message = say!(
            "the COB-ID `{}` of {} has {} set, which {} reserved",
            cob_id.cob_id,
            cob_id.service,
            bit_names(bits),
            if bits.count_ones() == 1 { "is" } else { "are" }
        );
        let place = facts.device.value_place(cob_id.index, cob_id.sub);
        let number = cob_id.cob_id.number();
        let finding = Diagnostic::new(&RULE.info, place.clone(), message).help(help(number));
        let meant = meant(number).filter(|_| !cob_id.cob_id.depends_on_node_id());
        findings.push(match meant {
            Some(meant) => {
                finding.fix(Fix::risky(say!("write `0x{:08X}`", meant)).set(place, format!("0x{meant:08X}")))
            }
            None => finding,
        });
    }
}

fn bit_names(bits: u32) -> Text {
    let word = if bits.count_ones() == 1 { "bit" } else { "bits" };
    say!("{} {}", word, joined((0..32).filter(|bit| bits >> bit & 1 == 1), ", "))
}

fn help(number: u32) -> Text {
    match meant(number) {
        Some(meant) => say!("did you mean `0x{:08X}`?", meant),
        None => "write a CAN-ID up to 7FFh, with flags in the first digit only".into(),
    }
}

/// The probable number if the flag digit is one place too far to the right.
fn meant(number: u32) -> Option<u32> {
    matches!(number >> 24, 0x04 | 0x08 | 0x0C).then_some((number >> 24 << 28) | (number & 0x7FF))
}
