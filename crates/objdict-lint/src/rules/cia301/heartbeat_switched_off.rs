use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Device, Value};
use crate::rule;

rule! {
    "cia301/heartbeat-switched-off", Warning, Device(check);
    summary: "no other node can detect the loss of the device",
    checks: "Whether a device without node guarding (100Ch and 100Dh not both greater than 0) has a heartbeat: 1017h must not be constantly 0, and a configuration must not set it from another default to 0.",
    why: "With a heartbeat time of 0 the device sends no heartbeat, and a master never notices that it has failed.",
    example: "`[1017]` with `AccessType=ro` and `DefaultValue=0`",
    remedy: "Write a heartbeat time, or make 1017h writable.",
    source: "CiA 301 §7.5.2.20",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(object) = device.object(0x1017).filter(|object| !object.object_type().has_subs()) else {
        return;
    };
    let entry = &object.main;
    let is = |value: Option<&Value>, zero: bool| {
        value.and_then(Value::as_integer).is_some_and(|number| (number == 0) == zero)
    };
    let is_constant = matches!(entry.access, Some(Access::Ro | Access::Const)) && is(entry.value(), true);
    let is_configured = is(entry.configured_value(), true) && is(entry.default.as_ref(), false);
    let is_guarded = [0x100C, 0x100D].into_iter().all(|index| is(device.value(index, 0).as_deref(), false));
    if is_guarded || !is_constant && !is_configured {
        return;
    }
    let message = if is_constant {
        say!("the heartbeat time is constantly `0`, so the device never sends a heartbeat")
    } else {
        say!("the configuration switches the heartbeat off, and the device has no node guarding")
    };
    let finding = Diagnostic::new(&RULE.info, device.value_place(0x1017, 0), message);
    findings.push(finding.help("write a heartbeat time in milliseconds"));
}
