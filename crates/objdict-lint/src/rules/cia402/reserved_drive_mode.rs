use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say, series};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/reserved-drive-mode", Warning, Applied(check);
    summary: "6502h has a reserved bit set",
    checks: "Whether bits 4 and 11 to 15 of 6502h (supported drive modes) are 0.",
    why: "Bit 4 was never assigned to a mode, and the others are reserved for a later version. Mostly the numbers of modes were used as bit numbers: the bit of homing, mode 6, is 5.",
    example: "`DefaultValue=0x00000010` in `[6502]`",
    remedy: "Set the bits of the modes; the bit number is the mode number minus 1. Manufacturer-specific modes use bits 16 to 31.",
    source: "CiA 402-2, supported drive modes",
}

const RESERVED: u32 = 1 << 4 | 0xF800;

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let Some(modes) = drive.modes().filter(|modes| modes & RESERVED != 0) else { return };
    let bits = (0..16u32).filter(|bit| modes & RESERVED & (1 << bit) != 0);
    let bits: Vec<u32> = bits.collect();
    let plural = if bits.len() == 1 { "bit" } else { "bits" };
    let message =
        say!("the supported drive modes `0x{:08X}` set the reserved {} {}", modes, plural, series(bits));
    let finding = Diagnostic::new(rule, drive.value_place(0x6502, 0), message);
    findings.push(finding.help("use bits 16 to 31 for manufacturer-specific modes"));
}
