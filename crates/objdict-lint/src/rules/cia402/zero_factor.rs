use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule, with_others};

rule! {
    "cia402/zero-factor", Error, Applied(check);
    summary: "a factor or resolution of a drive is 0",
    checks: "Whether sub-indexes 1 and 2 of the factors are not 0, configured or default: 604Bh, 604Ch, 608Fh to 6097h, 60A2h.",
    why: "The drive divides by one and multiplies by the other: with 0 it cannot compute positions.",
    example: "`DefaultValue=0` in `[6091sub2]`",
    remedy: "Write 1 for no scaling, or remove the default if the value depends on the motor.",
    source: "CiA 402-2, factor group",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for index in [0x604B, 0x604C].into_iter().chain(0x608F..=0x6097).chain([0x60A2]) {
        let zero: Vec<u8> = [1, 2].into_iter().filter(|&sub| drive.value(index, sub) == Some(0)).collect();
        let Some(&first) = zero.first() else { continue };
        let name = applied.profile.object(index).map_or("", |facts| facts.name);
        let message = say!("{} ({}) is a ratio, but has the value `0`", drive.name(index), name);
        let finding = Diagnostic::new(rule, drive.value_place(index, first), message);
        let others = zero.iter().skip(1).map(|&sub| (drive.value_place(index, sub), "also here"));
        findings.push(with_others(finding, others).help("write 1 for no scaling"));
    }
}
