use crate::demands::{self, Applied};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say, sub_index};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia406/cam-without-limits", Warning, Applied(check);
    summary: "an encoder enables a CAM that has no limits",
    checks: "Whether each CAM that 6301h (CAM enable register) enables has a low limit (6310h to 6317h) and a high limit (6320h to 6327h), configured or default.",
    why: "The CAM is active between its limits. Without them its state is not defined.",
    example: "`[6301sub1]` with `DefaultValue=0x02`, without `[6311]` and `[6321]`",
    remedy: "Describe the limits, or clear the bit of the CAM.",
    source: "CiA 406 (6301h, 6310h to 6327h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let Some(enabled) = device.object(at(0x6301)) else { return };
    for (sub, _) in enabled.entries().filter(|(sub, _)| (1..0xFF).contains(sub)) {
        let Some(bits) = enabled.value(sub).and_then(|value| value.as_integer()) else { continue };
        let limits = |cam: u16| [at(0x6310 + cam), at(0x6320 + cam)];
        let lacks = |index: &u16| match device.object(*index) {
            Some(object) => !object.has(sub),
            None => !demands::is_there(device, *index),
        };
        let cams = (0..8).filter(|cam| bits >> cam & 1 == 1);
        let Some((cam, limit)) =
            cams.flat_map(|cam| limits(cam).map(|limit| (cam, limit))).find(|(_, limit)| lacks(limit))
        else {
            continue;
        };
        let message = say!(
            "channel {} enables CAM {}, but {:04X}h has no limit for it",
            sub_index(sub),
            cam + 1,
            limit
        );
        let finding = Diagnostic::new(rule, device.value_place(at(0x6301), sub), message);
        findings.push(finding.help("describe the limits, or clear the bit of the CAM"));
    }
}
