use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Target, rule};

rule! {
    "cia304/wrong-mapping-length", Error, Facts(check);
    summary: "the length in an SRDO mapping differs from the length of the object",
    checks: "Whether the length in each SRDO mapping entry matches the data type of the object.",
    why: "The device rejects the mapping, or reads the following objects from the wrong position of the frame.",
    example: "`[1381sub1]` with `DefaultValue=0x61000110`, where 6100h sub-index 1 is UNSIGNED8",
    remedy: "Write the length of the data type in bits as the last two digits.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        for (sub, mapped) in srdo.mapped() {
            let Target::Entry(entry) = Target::of(facts.device, mapped) else { continue };
            let Some(data_type) = entry.data_type else { continue };
            let Some(bits) = data_type.bit_length().filter(|&bits| bits != mapped.bits) else { continue };
            let message = say!("{} maps {}, but its data type {} has {} bits", srdo, mapped, data_type, bits);
            let place = facts.device.value_place(srdo.mapping_index(), sub);
            let finding = Diagnostic::new(&RULE.info, place, message);
            let right = u64::from(mapped.to_number() & !0xFF) | u64::from(bits);
            findings.push(finding.help(say!("write `0x{:08X}`", right)));
        }
    }
}
