use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Text, say, series};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/interpolation-without-data", Warning, Applied(check);
    summary: "interpolation is supported without its data record or its time",
    checks: "Whether a drive whose 6502h states interpolated position mode has 60C1h (interpolation data record) and 60C2h (interpolation time period), and a drive with 60C0h (interpolation sub mode select) or 60C4h (interpolation data configuration) has 60C1h. A missing 60C0h is named beside the others.",
    why: "A master writes the set-points to the data record and the time between two of them to 60C2h; without them there is nothing to interpolate.",
    example: "`DefaultValue=0x00000041` in `[6502]`, without `[60C1]` and `[60C2]`",
    remedy: "Describe the objects, or clear bit 6 of 6502h.",
    source: "CiA 402-2, interpolated position mode",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let is_stated = drive.supports(6) == Some(true);
    let there = [0x60C0, 0x60C4].into_iter().find(|&index| drive.has(index));
    let lacks_data = drive.lacks(0x60C1) && (is_stated || there.is_some());
    let lacks_time = is_stated && drive.lacks(0x60C2) && !is_cyclic(drive);
    if !lacks_data && !lacks_time {
        return;
    }
    let missing = [(0x60C0, is_stated && drive.lacks(0x60C0)), (0x60C1, lacks_data), (0x60C2, lacks_time)];
    let missing: Vec<Text> = missing.iter().filter(|one| one.1).map(|one| drive.name(one.0)).collect();
    let verb = if missing.len() == 1 { "is" } else { "are" };
    let missing = series(missing);
    let finding = match there.filter(|_| !is_stated) {
        Some(there) => {
            let message =
                say!("{} is described without {} (interpolation data record)", drive.name(there), missing);
            Diagnostic::new(rule, drive.place(there), message)
        }
        None => {
            let message =
                say!("interpolated position mode is supported, but {} {} missing", missing.clone(), verb);
            Diagnostic::new(rule, drive.value_place(0x6502, 0), message)
        }
    };
    findings.push(finding.help("describe the missing objects, or clear bit 6 of 6502h"));
}

/// Whether a cyclic mode requires the time, which another rule checks.
fn is_cyclic(drive: Drive<'_>) -> bool {
    (7..=9).any(|bit| drive.supports(bit) == Some(true))
}
