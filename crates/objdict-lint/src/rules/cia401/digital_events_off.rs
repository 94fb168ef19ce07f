use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::model::{DeviceKind, PdoKind, Value};
use crate::profile::index_in;
use crate::{Facts, rule};

rule! {
    "cia401/digital-events-off", Warning, Applied(check);
    summary: "the events of digital inputs are switched off",
    checks: "Whether a configuration (DCF or XDC) does not set 6005h to false when a valid, event-driven TPDO (transmission type 254 or 255) without an event timer carries digital inputs. `cia401/wrong-default` checks the default.",
    why: "The TPDO waits for an event that the inputs never raise: the master sees no change of the inputs.",
    example: "`[6005]` with `ParameterValue=0` and `[1800sub2]` with `ParameterValue=255`",
    remedy: "Write `ParameterValue=1`, or set the event timer of the TPDO.",
    source: "CiA 401 (6005h)",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let enable = index_in(applied.block, 0x6005);
    let value = device.object(enable).and_then(|object| object.main.configured_value());
    let is_off = value.is_some_and(|value| *value == Value::Boolean(false) || value.as_integer() == Some(0));
    if device.kind == DeviceKind::Type || !is_off {
        return;
    }
    let inputs = index_in(applied.block, 0x6000)..=index_in(applied.block, 0x6128);
    let waits = facts.pdos.iter().map(|pdo| &pdo.pdo).find(|pdo| {
        let is_sent = pdo.kind == PdoKind::Tpdo && pdo.is_valid() == Some(true);
        let on_event_only = pdo.is_event_driven() && pdo.event_timer.unwrap_or(0) == 0;
        is_sent && on_event_only && pdo.mapped().any(|mapped| inputs.contains(&mapped.index))
    });
    if let Some(pdo) = waits {
        let message =
            say!("{} is never sent: {:04X}h switches the events of digital inputs off", pdo, enable);
        let finding = Diagnostic::new(rule, device.value_place(enable, 0), message);
        let finding = finding.label(device.value_place(pdo.communication_index(), 2), "event-driven");
        findings.push(finding.help(say!("write `{ParameterValue=1}` or set the event timer of the TPDO")));
    }
}
