use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/interpolation-time-differs", Warning, Applied(check);
    summary: "the interpolation time does not match the SYNC period",
    checks: "Whether the time in 60C2h, value times ten to the power of the index in seconds, is a multiple or a divisor of 1006h (communication cycle period), if both are not 0.",
    why: "The drive interpolates towards the next target for the time in 60C2h, but the next target arrives with SYNC: if the times differ, the axis stutters.",
    example: "`DefaultValue=3` in `[60C2sub1]` and `-3` in `[60C2sub2]`, which is 3 ms, and `DefaultValue=2000` in `[1006]`",
    remedy: "Set both to the same time.",
    source: "CiA 402-2, interpolation time period; CiA 301 §7.5.2.6",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let (Some(value), Some(index)) = (drive.value(0x60C2, 1), drive.value(0x60C2, 2)) else { return };
    let Some(period) = drive.value(0x1006, 0).filter(|&period| period > 0) else { return };
    let Some(time) = microseconds(value, index).filter(|&time| time > 0) else { return };
    if period % time == 0 || time % period == 0 {
        return;
    }
    let message = say!(
        "the interpolation time of {} is {} µs, but the SYNC period is `{}` µs",
        drive.name(0x60C2),
        time,
        period
    );
    let finding = Diagnostic::new(rule, drive.value_place(0x60C2, 1), message);
    let finding = finding.label(drive.value_place(0x1006, 0), "the SYNC period");
    findings.push(finding.help("set both to the same time"));
}

/// The time in microseconds for a value in seconds and a power of ten; `None` below a microsecond and above
/// all periods.
fn microseconds(value: i128, index: i128) -> Option<i128> {
    let power = u32::try_from(index + 6).ok().filter(|&power| power <= 12)?;
    Some(value * 10i128.pow(power))
}
