use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say, series};
use crate::model::Value;
use crate::{Drive, Facts, rule};

rule! {
    "cia402/homing-method-not-supported", Error, Applied(check);
    summary: "the homing method of a drive is not in its list of supported methods",
    checks: "Whether the configured or default value of 6098h (homing method) is in 60E3h (supported homing methods), if all entries of that list have a value. 0 (no homing) is not checked.",
    why: "The drive rejects homing with its start-up method.",
    example: "`DefaultValue=17` in `[6098]`, and `[60E3]` with the methods 35 and 37",
    remedy: "Choose a supported method, or complete the list.",
    source: "CiA 402-2, homing method and supported homing methods (version 4)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let Some(method) = drive.value(0x6098, 0).filter(|&method| method != 0) else { return };
    let Some(list) = drive.object(0x60E3) else { return };
    let methods: Option<Vec<i128>> = list
        .entries()
        .filter(|&(sub, _)| sub != 0 && sub != 0xFF)
        .map(|(_, entry)| entry.value().and_then(Value::as_integer))
        .collect();
    let Some(methods) = methods.filter(|methods| !methods.is_empty() && !methods.contains(&method)) else {
        return;
    };
    let message = say!(
        "homing method `{}` is not supported: {} lists {}",
        method,
        drive.name(0x60E3),
        series(methods.iter().take(20))
    );
    let finding = Diagnostic::new(rule, drive.value_place(0x6098, 0), message);
    let finding = finding.label(drive.place(0x60E3), "the supported homing methods");
    findings.push(finding.help("choose a supported method or complete the list"));
}
