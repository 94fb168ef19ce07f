use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::model::PdoKind;
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/invalid-sync-start-value", Error, Pdo(check);
    summary: "a TPDO waits for a SYNC counter value that never occurs",
    checks: "Whether the SYNC start value of each TPDO is at most 240 and at most the overflow value of the SYNC counter, 1019h. A start value on a device without a counter has no effect and is a warning.",
    why: "The TPDO starts with the SYNC whose counter has the start value. The counter runs from 1 to the overflow value and never reaches a higher start value.",
    example: "`[1800sub6]` with `DefaultValue=12` and `[1019]` with `DefaultValue=10`",
    remedy: "Write 0 to start with any SYNC, or a value up to that of 1019h.",
    source: "CiA 301 §7.5.2.22, §7.5.2.37",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(start) = pdo.sync_start_value.filter(|&start| start > 0 && pdo.kind == PdoKind::Tpdo) else {
        return;
    };
    let device = facts.device;
    let finding =
        |message| Diagnostic::new(&RULE.info, device.value_place(pdo.communication_index(), 6), message);
    let counter = device.value(0x1019, 0).and_then(|value| value.as_integer());
    if start > 240 {
        let finding = finding(say!("the SYNC start value `{}` of {} is out of range (0 to 240)", start, pdo));
        findings.push(finding.help("write 0 to start with any SYNC"));
        return;
    }
    match counter {
        None if device.objects.contains_key(&0x1019) => {}
        None | Some(0) => {
            let finding = finding(say!(
                "the SYNC start value `{}` of {} has no effect without a SYNC counter",
                start,
                pdo
            ));
            let finding = match counter {
                Some(_) => finding.label(device.value_place(0x1019, 0), "the counter is disabled here"),
                None => finding,
            };
            findings.push(finding.severity(Severity::Warning).help("write 0, or set 1019h"));
        }
        Some(overflow) if i128::from(start) > overflow => {
            let finding = finding(say!(
                "{} waits for SYNC counter `{}`, but the counter overflows at {}",
                pdo,
                start,
                overflow
            ));
            let finding = finding.label(device.value_place(0x1019, 0), "the overflow value");
            findings.push(finding.help(say!("write at most {}", overflow)));
        }
        Some(_) => {}
    }
}
