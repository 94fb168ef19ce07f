use crate::demands::{self, Against};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{Part, Place};
use crate::profile::index_in;
use crate::rule;

rule! {
    "cia401/error-mode-without-value", Warning, Against(check);
    summary: "an error mode has no error value",
    checks: "Whether outputs with an error mode also have the error value: 6207h for 6206h, 6307h for 6306h, 6327h for 6326h, 6260h to 6267h for 6250h to 6257h, 6444h or 6445h for 6443h. Objects that a module of a modular device may add are not reported.",
    why: "The error mode makes an output take its error value when the master fails. Without an error value the state of the output is undefined.",
    example: "`[6206]` without `[6207]`",
    remedy: "Describe the error value or remove the error mode.",
    source: "CiA 401 (6206h, 6207h, 6443h to 6445h)",
}

/// The error values that belong to an error mode, of the first logical device.
fn values(mode: u16) -> &'static [u16] {
    match mode {
        0x6206 => &[0x6207],
        0x6306 => &[0x6307],
        0x6326 => &[0x6327],
        0x6443 => &[0x6444, 0x6445],
        _ => &[],
    }
}

fn check(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let block = at.applied.block;
    let mode = at.index - (index_in(block, at.facts.first) - at.facts.first);
    let of_bits = [mode.saturating_add(0x10)];
    let values = if matches!(mode, 0x6250..=0x6257) { &of_bits } else { values(mode) };
    let mut indexes = values.iter().map(|&index| index_in(block, index));
    let Some(first) = indexes.clone().next().filter(|_| !at.object.orphan) else { return };
    if !indexes.any(|index| demands::is_there(at.device, index)) {
        let message = say!("{} has no error value ({:04X}h)", at, first);
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help(say!("describe the error value: `{}`", Part::Object(first))));
    }
}
