use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/notation-without-dimension", Warning, Applied(check);
    summary: "only one of notation index and dimension index is described",
    checks: "Whether both unit objects of version 2 are described: 6089h and 608Ah for positions, 608Bh and 608Ch for velocities, 608Dh and 608Eh for accelerations.",
    why: "The notation index is a power of ten, the dimension index a unit: neither has a meaning alone.",
    example: "`[6089]` without `[608A]`",
    remedy: "Describe the other, or use 60A8h to 60ABh of version 4.",
    source: "CiA 402 version 2, factor group",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for notation in [0x6089, 0x608B, 0x608D] {
        let (there, missing, name) = match (drive.has(notation), drive.has(notation + 1)) {
            (true, false) => (notation, notation + 1, "dimension index"),
            (false, true) => (notation + 1, notation, "notation index"),
            _ => continue,
        };
        if drive.lacks(missing) {
            let (there_name, missing) = (drive.name(there), drive.name(missing));
            let message = say!("{} is described without its {} {}", there_name, name, missing);
            let finding = Diagnostic::new(rule, drive.place(there), message);
            findings.push(finding.help(say!("describe {}", missing)));
        }
    }
}
