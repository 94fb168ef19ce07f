use crate::demands::{self, Applied};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say, series};
use crate::model::Place;
use crate::profile::{device_type_index, index_in};
use crate::{Facts, rule};

rule! {
    "cia406/incomplete-class-2", Warning, Applied(check);
    summary: "an encoder has some functions of class C2, but not all",
    checks: "Whether an encoder with scaling and preset (6002h and 6003h), which only class C2 requires, has the other objects of that class: 6001h if it is rotary or 6005h if it is linear, 6200h unless 1800h has an event timer, alarms and warnings (6503h to 6506h), 6507h, 6509h, 650Ah and 650Bh. Encoders with several sensors or with only one of 6002h and 6003h are not checked.",
    why: "An encoder of class C1 may have any of these objects, so nothing fails; but a master that expects class C2 gets SDO aborts.",
    example: "`[6002]` and `[6003]` without `[6503]`",
    remedy: "Describe the other objects too, or declare an encoder of class C1 with scaling.",
    source: "CiA 406, class C2; manuals of encoders",
}

/// The objects that class C2 adds to class C1, scaling and preset, for all encoder types.
const ALL: [u16; 8] = [0x6503, 0x6504, 0x6505, 0x6506, 0x6507, 0x6509, 0x650A, 0x650B];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let device_type = device.object(device_type_index(device, block));
    let device_type = device_type.and_then(|object| object.value(0)?.as_integer());
    let of_type = match device_type.map(|device_type| device_type >> 16) {
        Some(1..=5) => 0x6001,
        Some(6..=9) => 0x6005,
        _ => return,
    };
    let is_there = |index: u16| demands::is_there(device, index_in(block, index));
    if !is_there(0x6002) || !is_there(0x6003) {
        return;
    }
    let has_timer = block == 0 && device.object(0x1800).is_some_and(|object| object.has(5));
    let timer = (!has_timer).then_some(0x6200);
    let all = std::iter::once(of_type).chain(timer).chain(ALL);
    let missing: Vec<String> = all
        .filter(|&index| !is_there(index))
        .map(|index| format!("{:04X}h", index_in(block, index)))
        .collect();
    if !missing.is_empty() {
        let message = say!("the encoder has scaling and preset of class C2, but lacks {}", series(missing));
        let finding = Diagnostic::new(rule, Place::object(index_in(block, 0x6003)), message);
        findings.push(finding.help("describe the missing objects"));
    }
}
