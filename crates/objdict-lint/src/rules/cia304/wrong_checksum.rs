use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, Srdo, rule};

rule! {
    "cia304/wrong-checksum", Warning, Facts(check);
    summary: "the checksum of a valid configuration is wrong",
    checks: "Whether the checksum in 13FFh of each active SRDO matches its parameters if 13FEh marks the configuration as valid (A5h): a 16-bit CRC with the polynomial 1021h and start value 0 over direction, refresh time, validation time, both COB-IDs, the number of mapped objects, and sub-index and value of each mapping entry. SRDOs with missing values are not checked.",
    why: "At power-up the device calculates the checksum, detects the difference and sends no safety data.",
    example: "`[13FE]` with `DefaultValue=0xA5` and `[13FFsub1]` with `DefaultValue=0`",
    remedy: "Verify the configuration and write the reported checksum; or write 0 to 13FEh.",
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
            let message = say!(
                "the checksum of {} is `0x{:04X}`, but its parameters yield 0x{:04X}",
                srdo,
                stated,
                right
            );
            let finding = Diagnostic::new(&RULE.info, facts.device.value_place(0x13FF, sub), message)
                .label(facts.device.value_place(0x13FE, 0), "the configuration is marked valid");
            findings.push(finding.help("verify the configuration and write its checksum"));
        }
    }
}

/// The checksum over all parameters of an SRDO; `None` if one of them is unknown.
fn checksum(facts: &Facts<'_>, srdo: &Srdo<'_>) -> Option<u16> {
    let count = srdo.mapped_count.filter(|&count| count <= 16)?;
    let mut bytes = Vec::with_capacity(100);
    bytes.push(u8::try_from(srdo.number(1)?).ok()?);
    bytes.extend(u16::try_from(srdo.number(2)?).ok()?.to_le_bytes());
    bytes.push(u8::try_from(srdo.number(3)?).ok()?);
    for sub in [5, 6] {
        // the device adds its node-ID to default values below 101h
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

/// CRC-16: polynomial 1021h, initial value 0, most significant bit first.
fn crc(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |crc, &byte| {
        (0..8).fold(
            crc ^ u16::from(byte) << 8,
            |crc, _| if crc & 0x8000 == 0 { crc << 1 } else { crc << 1 ^ 0x1021 },
        )
    })
}
