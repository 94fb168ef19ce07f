use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Srdo, rule};

rule! {
    "cia304/wrong-checksum", Warning, Facts(check);
    summary: "a configuration is called valid, and its checksum is wrong",
    checks: "Whether the checksum in 13FFh of each SRDO with a direction is that of its parameters, where 13FEh says that the configuration is valid (A5h): a CRC of 16 bits with the polynomial 1021h, from 0, over direction, refresh time, validation time, both COB-IDs, the number of mapped objects, and sub-index and value of each entry of the mapping. SRDOs of which not all of that is stated are left alone.",
    why: "At power-up the device works the checksum out, finds that it differs, and sends no safety data.",
    example: "`[13FE]` with `DefaultValue=0xA5`, and `[13FFsub1]` with `DefaultValue=0`",
    remedy: "Write the checksum that the finding names, after somebody has made sure that the configuration is the right one; or 0 into 13FEh.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.number(0x13FE, 0) != Some(0xA5) {
        return;
    }
    for srdo in facts.srdos.iter().filter(|srdo| srdo.is_on()) {
        let Ok(sub) = u8::try_from(srdo.number) else { continue };
        let (Some(stated), Some(right)) = (facts.number(0x13FF, sub), checksum(facts, srdo)) else {
            continue;
        };
        if stated != i128::from(right) {
            let message = say!("`0x{:04X}` as checksum of {}, which is 0x{:04X}", stated, srdo, right);
            let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x13FF, sub), message)
                .label(facts.device.value_place(0x13FE, 0), "the configuration is called valid");
            findings.push(finding.help("make sure that the configuration is right, and write its checksum"));
        }
    }
}

/// The checksum over all parameters of an SRDO; `None` where one is not known.
fn checksum(facts: &Facts<'_>, srdo: &Srdo<'_>) -> Option<u16> {
    let count = srdo.mapped_count.filter(|&count| count <= 16)?;
    let mut bytes = Vec::with_capacity(100);
    bytes.push(u8::try_from(srdo.number(1)?).ok()?);
    bytes.extend(u16::try_from(srdo.number(2)?).ok()?.to_le_bytes());
    bytes.push(u8::try_from(srdo.number(3)?).ok()?);
    for sub in [5, 6] {
        // below 101h stand the defaults that the device adds its node-ID to
        let cob_id = srdo.cob_id(facts, sub).filter(|&cob_id| cob_id > 0x100)?;
        bytes.extend(u32::try_from(cob_id).ok()?.to_le_bytes());
    }
    bytes.push(count);
    for sub in 1..=count {
        let slot = srdo.slots.iter().find(|slot| slot.sub == sub)?;
        bytes.push(sub);
        bytes.extend(slot.object?.to_number().to_le_bytes());
    }
    Some(crc(&bytes))
}

/// CRC of 16 bits, polynomial 1021h, from 0, most significant bit first.
fn crc(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |crc, &byte| {
        (0..8).fold(
            crc ^ u16::from(byte) << 8,
            |crc, _| if crc & 0x8000 == 0 { crc << 1 } else { crc << 1 ^ 0x1021 },
        )
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_checksum_of_the_digits() {
        // the check value that catalogues of CRCs give for this polynomial and start
        assert_eq!(super::crc(b"123456789"), 0x31C3);
    }
}
