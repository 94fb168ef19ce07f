use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/target-without-actual-value", Warning, Applied(check);
    summary: "a target is there without its actual value",
    checks: "Whether the actual value belongs to each target: 6044h to 6042h, 6064h to 607Ah, 606Ch to 60FFh, 6077h to 6071h. Where 6502h names a mode that cannot do without the actual value, its lack is the matter of `cia402/missing-object`.",
    why: "A master that cannot read what the axis does knows neither when it has arrived nor that it follows.",
    example: "`[607A]`, and no `[6064]`",
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
        let message = say!("{} is there, and {} ({}) is not", target_name, actual_name, name);
        let finding = Diagnostic::new(rule, drive.place(target), message);
        findings.push(finding.help(say!("describe {}", actual_name)));
    }
}

/// Whether the document demands an object, which is a rule of its own.
fn is_demanded(facts: &Facts<'_>, applied: &Applied<'_>, index: u16) -> bool {
    let wanted = applied.profile.object(index);
    wanted.is_some_and(|wanted| wanted.is_demanded(facts.device, applied.block))
}
