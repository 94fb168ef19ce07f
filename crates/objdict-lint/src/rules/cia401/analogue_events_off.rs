use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{DeviceKind, PdoKind, Value};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia401/analogue-events-off", Note, Applied(check);
    summary: "a configuration maps analogue inputs into an event-driven TPDO but leaves their events disabled",
    checks: "Whether a configuration (DCF or XDC) sets 6423h when a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries analogue inputs. In a device description this is not a finding: the profile disables the events by default.",
    why: "The device never sends the TPDO: while 6423h is false, a change of an analogue input is not an event. This is the most common reason for missing analogue values.",
    example: "`[1801sub2]` with 255, `[1801sub5]` with 0, and `[6423]` with `DefaultValue=0` and no `ParameterValue`",
    remedy: "Set `ParameterValue=1` at 6423h, set an event timer, or send the TPDO on SYNC.",
    source: "CiA 401 (6423h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let enable = index_in(applied.block, 0x6423);
    let value = device.object(enable).and_then(|object| object.value(0));
    let is_off =
        value.is_some_and(|value| matches!(*value, Value::Boolean(false)) || value.as_integer() == Some(0));
    if device.kind == DeviceKind::Type || !is_off {
        return;
    }
    let inputs = index_in(applied.block, 0x6400)..=index_in(applied.block, 0x6404);
    let waits = facts.pdos.iter().map(|pdo| &pdo.pdo).find(|pdo| {
        let is_sent = pdo.kind == PdoKind::Tpdo && pdo.is_valid() == Some(true);
        let on_event_only = pdo.is_event_driven() && pdo.event_timer.unwrap_or(0) == 0;
        is_sent && on_event_only && pdo.mapped().any(|mapped| inputs.contains(&mapped.index))
    });
    if let Some(pdo) = waits {
        let message =
            say!("{} is never sent: analogue inputs raise no events until {:04X}h is true", pdo, enable);
        let finding = Diagnostic::new(rule, device.value_place(enable, 0), message);
        let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
        findings.push(finding.help(say!("write `{ParameterValue=1}` or set the event timer of the TPDO")));
    }
}
