use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/set-point-above-limit", Warning, Applied(check);
    summary: "a set-point of a drive is above its limit",
    checks: "Whether 6081h and 60FFh (profile and target velocity) are not above 607Fh (max profile velocity), 6083h and 609Ah (profile and homing acceleration) not above 60C5h, 6084h and 6085h (profile and quick stop deceleration) not above 60C6h, 6071h, 60E0h and 60E1h (target torque and torque limits) not above 6072h (max torque), and 6042h (vl target velocity) not above sub-index 2 of 6046h, configured or default. A limit of 0 or without a value is ignored.",
    why: "The drive moves more slowly than configured, or rejects the set-point.",
    example: "`DefaultValue=5000` in `[6081]`, `DefaultValue=3000` in `[607F]`",
    remedy: "Lower the set-point, or raise the limit.",
    source: "CiA 402-2, IEC 61800-7-201",
}

/// A set-point, its limit with the sub-index, and the name of the set-point.
const PAIRS: [(u16, (u16, u8), &str); 10] = [
    (0x6042, (0x6046, 2), "vl target velocity"),
    (0x6081, (0x607F, 0), "profile velocity"),
    (0x60FF, (0x607F, 0), "target velocity"),
    (0x6083, (0x60C5, 0), "profile acceleration"),
    (0x609A, (0x60C5, 0), "homing acceleration"),
    (0x6084, (0x60C6, 0), "profile deceleration"),
    (0x6085, (0x60C6, 0), "quick stop deceleration"),
    (0x6071, (0x6072, 0), "target torque"),
    (0x60E0, (0x6072, 0), "positive torque limit"),
    (0x60E1, (0x6072, 0), "negative torque limit"),
];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (index, (limit_index, sub), name) in PAIRS {
        let (Some(value), Some(limit)) = (drive.value(index, 0), drive.value(limit_index, sub)) else {
            continue;
        };
        if limit <= 0 || value.abs() <= limit {
            continue;
        }
        let message = say!("the {} `{}` is above its limit `{}`", name, value, limit);
        let finding = Diagnostic::new(rule, drive.value_place(index, 0), message);
        let finding = finding.label(drive.value_place(limit_index, sub), "the limit");
        findings.push(finding.help("lower the set-point or raise the limit"));
    }
}
