use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/target-without-actual-value", Warning, Applied(check);
    summary: "a target is described without its actual value",
    checks: "Whether the actual value of each target is described: 6044h for 6042h, 6064h for 607Ah, 606Ch for 60FFh, 6077h for 6071h. If 6502h states a mode that requires the actual value, `cia402/missing-object` reports it instead.",
    why: "Without the actual value a master cannot monitor the axis or detect that it has reached the target.",
    example: "`[607A]` without `[6064]`",
    remedy: "Describe the actual value.",
    source: "CiA 402-2, IEC 61800-7-201",
}

const PAIRS: [(u16, u16, &str); 4] = [
    (0x6042, 0x6044, "vl velocity actual value"),
    (0x607A, 0x6064, "position actual value"),
    (0x60FF, 0x606C, "velocity actual value"),
    (0x6071, 0x6077, "torque actual value"),
];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (target, actual, name) in PAIRS {
        if !drive.has(target) || !drive.lacks(actual) || is_demanded(facts, applied, actual) {
            continue;
        }
        let (target_name, actual_name) = (drive.name(target), drive.name(actual));
        let message = say!("{} is described without {} ({})", target_name, actual_name, name);
        let finding = Diagnostic::new(rule, drive.place(target), message);
        findings.push(finding.help(say!("describe {}", actual_name)));
    }
}

/// Whether the document requires an object, which another rule checks.
fn is_demanded(facts: &Facts<'_>, applied: &Applied<'_>, index: u16) -> bool {
    let wanted = applied.profile.object(index);
    wanted.is_some_and(|wanted| wanted.is_demanded(facts.device, applied.block))
}
