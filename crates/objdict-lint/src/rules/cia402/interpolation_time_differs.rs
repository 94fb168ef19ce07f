use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/interpolation-time-differs", Warning, Applied(check);
    summary: "the interpolation time is not the period of SYNC",
    checks: "Whether the time that 60C2h gives, value times ten to the power of its index in seconds, is a multiple or a whole part of 1006h (communication cycle period), where both have values other than 0.",
    why: "The drive interpolates towards the next target for 60C2h, and the next target comes with SYNC: with another time the axis stutters.",
    example: "`DefaultValue=3` in `[60C2sub1]` and `-3` in `[60C2sub2]`, which is 3 ms, and `DefaultValue=2000` in `[1006]`",
    remedy: "Give both the same time.",
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
        "the interpolation time of {} is {} µs, SYNC comes every `{}` µs",
        drive.name(0x60C2),
        time,
        period
    );
    let finding = Diagnostic::new(rule, drive.value_place(0x60C2, 1), message);
    findings.push(finding.label(drive.value_place(0x1006, 0), "the period of SYNC"));
}

/// A time in seconds as value and power of ten; `None` for less than a microsecond, and beyond all periods.
fn microseconds(value: i128, index: i128) -> Option<i128> {
    let power = u32::try_from(index + 6).ok().filter(|&power| power <= 12)?;
    Some(value * 10i128.pow(power))
}
