use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/set-point-above-limit", Warning, Applied(check);
    summary: "a set-point of a drive is above its limit",
    checks: "Whether 6081h (profile velocity) is not above 607Fh (max profile velocity), 6083h and 6084h (profile acceleration and deceleration) not above 60C5h and 60C6h, and 6071h (target torque) not above 6072h (max torque), configured or default. A limit of 0 or without a value is ignored.",
    why: "The drive moves more slowly than configured, or rejects the set-point.",
    example: "`DefaultValue=5000` in `[6081]`, `DefaultValue=3000` in `[607F]`",
    remedy: "Lower the set-point, or raise the limit.",
    source: "CiA 402-2, IEC 61800-7-201",
}

const PAIRS: [(u16, u16, &str); 4] = [
    (0x6081, 0x607F, "profile velocity"),
    (0x6083, 0x60C5, "profile acceleration"),
    (0x6084, 0x60C6, "profile deceleration"),
    (0x6071, 0x6072, "target torque"),
];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (index, limit_index, name) in PAIRS {
        let (Some(value), Some(limit)) = (drive.value(index, 0), drive.value(limit_index, 0)) else {
            continue;
        };
        if limit <= 0 || value.abs() <= limit {
            continue;
        }
        let message = say!("the {} `{}` is above its limit `{}`", name, value, limit);
        let finding = Diagnostic::new(rule, drive.value_place(index, 0), message);
        let finding = finding.label(drive.value_place(limit_index, 0), "the limit");
        findings.push(finding.help("lower the set-point or raise the limit"));
    }
}
