use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::Object;
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia401/digital-events-off", Warning, Applied(check);
    summary: "the events of digital inputs are switched off",
    checks: "Whether a configuration (DCF or XDC) does not set 6005h to false, or all masks of 6006h, 6007h and 6008h to 0, when a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries digital inputs. `cia401/wrong-default` checks the defaults.",
    why: "The TPDO waits for an event that the inputs never raise: the master sees no change of the inputs.",
    example: "`[6005]` with `ParameterValue=0` and `[1800sub2]` with `ParameterValue=255`",
    remedy: "Write `ParameterValue=1` to 6005h, set the bits of the inputs in a mask, or set the event timer of the TPDO.",
    source: "CiA 401 (6005h to 6008h)",
}

/// The masks of the inputs with 8 bits: any change, to 1, to 0.
const MASKS: [u16; 3] = [0x6006, 0x6007, 0x6008];

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let inputs = |last: u16| at(0x6000)..=at(last);
    let is_set = |index: u16| {
        let mut entries = device.object(index).into_iter().flat_map(Object::described);
        entries.any(|(_, entry)| entry.configured_value().is_some())
    };
    let masks: Vec<u16> = MASKS.map(at).into_iter().filter(|&mask| device.object(mask).is_some()).collect();
    let is_masked = masks.iter().all(|&mask| facts.is_configured_off(mask));
    let first = masks.iter().copied().find(|&mask| is_set(mask)).filter(|_| is_masked);
    let (index, pdo, help) = if facts.is_configured_off(at(0x6005)) && is_set(at(0x6005)) {
        let help = say!("write `{ParameterValue=1}` or set the event timer of the TPDO");
        (at(0x6005), facts.waiting_tpdo(&inputs(0x6128)), help)
    } else if let Some(first) = first {
        let help = say!("set the bits of the inputs in {:04X}h or the event timer of the TPDO", first);
        (first, facts.waiting_tpdo(&inputs(0x6000)), help)
    } else {
        return;
    };
    let Some(pdo) = pdo else { return };
    let sub = u8::from(index != at(0x6005));
    let message = say!("{} is never sent: {:04X}h switches the events of digital inputs off", pdo, index);
    let finding = Diagnostic::new(rule, device.value_place(index, sub), message);
    let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
    findings.push(finding.help(help));
}
