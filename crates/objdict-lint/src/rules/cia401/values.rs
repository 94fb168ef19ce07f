//! Events, interrupt limits, error values and scaling of an I/O module.

use crate::Facts;
use crate::demands::{self, Against, Applied, Expected};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{Object, Part, Place};
use crate::profile::index_in;
use crate::rule::rules;

rules! {
    "cia401/analogue-events-off" = ANALOGUE_EVENTS_OFF, Note, Applied(analogue_events_off);
    summary: "a configuration maps analogue inputs into an event-driven TPDO but leaves their events disabled",
    checks: "Whether a configuration (DCF or XDC) sets 6423h, and selects an event in 6421h, when a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries analogue inputs. In a device description this is not a finding: the profile disables the events by default.",
    why: "The device never sends the TPDO: while 6423h is false or 6421h is 0, a change of an analogue input is not an event. This is the most common reason for missing analogue values.",
    example: "`[1801sub2]` with 255, `[1801sub5]` with 0, and `[6423]` with `DefaultValue=0` and no `ParameterValue`",
    remedy: "Set `ParameterValue=1` at 6423h, select an event in 6421h, set an event timer, or send the TPDO on SYNC.",
    source: "CiA 401 (6421h, 6423h)",

    "cia401/digital-events-off" = DIGITAL_EVENTS_OFF, Warning, Applied(digital_events_off);
    summary: "the events of digital inputs are switched off",
    checks: "Whether a configuration (DCF or XDC) does not set 6005h to false, or all masks of 6006h, 6007h and 6008h to 0, when a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries digital inputs. `cia401/wrong-default` checks the defaults.",
    why: "The TPDO waits for an event that the inputs never raise: the master sees no change of the inputs.",
    example: "`[6005]` with `ParameterValue=0` and `[1800sub2]` with `ParameterValue=255`",
    remedy: "Write `ParameterValue=1` to 6005h, set the bits of the inputs in a mask, or set the event timer of the TPDO.",
    source: "CiA 401 (6005h to 6008h)",

    "cia401/error-mode-without-value" = ERROR_MODE_WITHOUT_VALUE, Warning, Against(error_mode_without_value);
    summary: "an error mode has no error value",
    checks: "Whether outputs with an error mode also have the error value: 6207h for 6206h, 6307h for 6306h, 6327h for 6326h, 6260h to 6267h for 6250h to 6257h, 6444h or 6445h for 6443h. Objects that a module of a modular device may add are not reported.",
    why: "The error mode makes an output take its error value when the master fails. Without an error value the state of the output is undefined.",
    example: "`[6206]` without `[6207]`",
    remedy: "Describe the error value or remove the error mode.",
    source: "CiA 401 (6206h, 6207h, 6443h to 6445h)",

    "cia401/interrupt-limits-crossed" = INTERRUPT_LIMITS_CROSSED, Warning, Applied(interrupt_limits_crossed);
    summary: "the lower interrupt limit of an analogue input is above the upper one",
    checks: "Whether 6425h and 642Bh (lower limits) are not above 6424h and 642Ah (upper limits), channel by channel.",
    why: "An input raises an event above the upper limit and below the lower one. If the limits are crossed, each value raises an event and the TPDO floods the network.",
    example: "`[6424sub1]` with `DefaultValue=100`, `[6425sub1]` with `DefaultValue=200`",
    remedy: "Exchange the limits.",
    source: "CiA 401 (6424h, 6425h, 642Ah, 642Bh)",

    "cia401/zero-scaling" = ZERO_SCALING, Error, Expected(zero_scaling);
    summary: "an analogue channel is configured with a scaling of 0",
    checks: "Whether a configuration (DCF or XDC) sets no element of 642Fh, 6432h, 6442h or 6447h to 0. `cia401/wrong-default` checks the defaults.",
    why: "The value of the channel is multiplied by 0, so an input always reads its offset and an output never changes.",
    example: "`[6432sub1]` with `ParameterValue=0`",
    remedy: "Write 1 for no scaling.",
    source: "CiA 401 (642Fh, 6432h, 6442h, 6447h)",
}

fn analogue_events_off(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let switches = [(0x6423, 0, "is true"), (0x6421, 1, "selects one")];
    let off = switches.into_iter().find(|&(index, ..)| facts.is_configured_off(at(index)));
    let Some((index, sub, condition)) = off else { return };
    let Some(pdo) = facts.waiting_tpdo(&(at(0x6400)..=at(0x6404))) else { return };
    let message =
        say!("{} is never sent: analogue inputs raise no events until {:04X}h {}", pdo, at(index), condition);
    let finding = ANALOGUE_EVENTS_OFF.at(device.value_place(at(index), sub), message);
    let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
    let help =
        if sub == 0 { say!("write `{ParameterValue=1}`") } else { say!("select an event, such as 7,") };
    findings.push(finding.help(say!("{} or set the event timer of the TPDO", help)));
}

/// The masks of the inputs with 8 bits: any change, to 1, to 0.
const EVENT_MASKS: [u16; 3] = [0x6006, 0x6007, 0x6008];

fn digital_events_off(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let inputs = |last: u16| at(0x6000)..=at(last);
    let is_set = |index: u16| {
        let mut entries = device.object(index).into_iter().flat_map(Object::described);
        entries.any(|(_, entry)| entry.configured_value().is_some())
    };
    let masks: Vec<u16> =
        EVENT_MASKS.map(at).into_iter().filter(|&mask| device.object(mask).is_some()).collect();
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
    let finding = DIGITAL_EVENTS_OFF.at(device.value_place(index, sub), message);
    let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
    findings.push(finding.help(help));
}

/// The error values that belong to an error mode, of the first logical device.
fn error_values(mode: u16) -> &'static [u16] {
    match mode {
        0x6206 => &[0x6207],
        0x6306 => &[0x6307],
        0x6326 => &[0x6327],
        0x6443 => &[0x6444, 0x6445],
        _ => &[],
    }
}

fn error_mode_without_value(rule: &'static RuleInfo, at: &Against<'_>, findings: &mut Findings) {
    let block = at.applied.block;
    let mode = at.index - (index_in(block, at.facts.first) - at.facts.first);
    let of_bits = [mode.saturating_add(0x10)];
    let values = if matches!(mode, 0x6250..=0x6257) { &of_bits } else { error_values(mode) };
    let mut indexes = values.iter().map(|&index| index_in(block, index));
    let Some(first) = indexes.clone().next().filter(|_| !at.object.orphan) else { return };
    if !indexes.any(|index| demands::is_there(at.device, index)) {
        let message = say!("{} has no error value ({:04X}h)", at, first);
        let finding = Diagnostic::new(rule, Place::object(at.index), message);
        findings.push(finding.help(say!("describe the error value: `{}`", Part::Object(first))));
    }
}

fn interrupt_limits_crossed(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for [upper, lower] in [[0x6424, 0x6425], [0x642A, 0x642B]] {
        let [upper, lower] = [upper, lower].map(|index| index_in(applied.block, index));
        let Some(object) = device.object(lower).filter(|_| device.objects.contains_key(&upper)) else {
            continue;
        };
        for (sub, _) in object.stated().filter(|&(sub, _)| sub > 0) {
            let value = |index: u16| device.value(index, sub)?.as_real();
            let (Some(high), Some(low)) = (value(upper), value(lower)) else { continue };
            if low > high {
                let message = say!(
                    "the lower limit `{}` of input {} is above the upper limit `{}`",
                    low.to_string(),
                    sub,
                    high.to_string()
                );
                let finding = INTERRUPT_LIMITS_CROSSED.at(device.value_place(lower, sub), message);
                let finding = finding.label(device.value_place(upper, sub), "the upper limit");
                findings.push(finding.help("exchange the limits"));
            }
        }
    }
}

fn zero_scaling(rule: &'static RuleInfo, at: &Expected<'_>, findings: &mut Findings) {
    let is_scaling = matches!(at.against.facts.first, 0x642F | 0x6432 | 0x6442 | 0x6447);
    let value = at.entry.configured_value().filter(|_| is_scaling && !at.counts());
    if value.and_then(crate::model::Value::as_real) == Some(0.0) {
        let message = say!("the scaling of {} is `0`", at);
        let finding = Diagnostic::new(rule, at.place().field(at.value_field()), message);
        findings.push(finding.help("write 1 for no scaling"));
    }
}
