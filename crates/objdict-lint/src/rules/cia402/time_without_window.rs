use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/time-without-window", Note, Applied(check);
    summary: "a time is described without its window",
    checks: "Whether 6065h (following error window) is described with 6066h (its time out), 6067h (position window) with 6068h, 606Dh (velocity window) with 606Eh, 606Fh (velocity threshold) with 6070h.",
    why: "The time states how long the value may be outside, or must be inside, a window that cannot be set.",
    example: "`[6068]` without `[6067]`",
    remedy: "Describe the window, or remove the time.",
    source: "CiA 402-2, IEC 61800-7-201",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (window, time, name) in [
        (0x6065, 0x6066, "following error window"),
        (0x6067, 0x6068, "position window"),
        (0x606D, 0x606E, "velocity window"),
        (0x606F, 0x6070, "velocity threshold"),
    ] {
        if drive.has(time) && drive.lacks(window) {
            let (time_name, window) = (drive.name(time), drive.name(window));
            let message = say!("{} is described without its {} {}", time_name, name, window);
            let finding = Diagnostic::new(rule, drive.place(time), message);
            findings.push(finding.help(say!("describe {}", window)));
        }
    }
}
