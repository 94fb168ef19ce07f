use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::Field;
use crate::{Drive, Facts, rule};

rule! {
    "cia402/cyclic-target-not-mappable", Warning, Applied(check);
    summary: "the target of a cyclic mode is not mappable",
    checks: "Whether 607Ah (target position), 60FFh (target velocity) and 6071h (target torque) are marked as mappable if 6502h states the corresponding cyclic synchronous mode.",
    why: "A cyclic mode needs a new target with every SYNC; SDO transfers are too slow.",
    example: "`DefaultValue=0x00000080` in `[6502]`, and `PDOMapping=0` in `[607A]`",
    remedy: "Write `PDOMapping=1`, or clear the bit of the mode in 6502h.",
    source: "CiA 402-2, cyclic synchronous modes",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for (bit, index, mode) in [(7, 0x607A, "position"), (8, 0x60FF, "velocity"), (9, 0x6071, "torque")] {
        let Some(entry) = drive.variable(index) else { continue };
        let is_readable = entry.invalid_values.get(&Field::PdoMapping).is_none();
        if drive.supports(bit) == Some(true) && is_readable && !entry.is_mappable() {
            let name = drive.name(index);
            let message =
                say!("{} is not mappable, but cyclic synchronous {} mode needs it in a PDO", name, mode);
            let finding = Diagnostic::new(rule, drive.place(index).field(Field::PdoMapping), message);
            let finding = finding.label(drive.value_place(0x6502, 0), say!("bit {} states the mode", bit));
            findings.push(finding.help(say!("write `{PDOMapping=1}`")));
        }
    }
}
