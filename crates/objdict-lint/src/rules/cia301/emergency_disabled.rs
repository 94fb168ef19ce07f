use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::Place;
use crate::{Facts, Service, rule};

rule! {
    "cia301/emergency-disabled", Warning, Facts(check), fix Unsafe;
    summary: "the EMCY object is not valid by default although the device supports it",
    checks: "Whether bit 31 of 1014h is clear in an EDS with 1015h, the inhibit time of EMCY.",
    why: "Bit 31 marks EMCY as not valid. It has another meaning for SYNC and TIME, so it is easily set by mistake; no error of the device then reaches the network.",
    example: "`[1014]` with `DefaultValue=$NODEID+0x80000080`",
    remedy: "Clear bit 31: `$NODEID+0x80`.",
    source: "CiA 301 §7.5.2.17",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let emcy = facts.cob_ids.iter().find(|cob_id| cob_id.service == Service::Emcy);
    let Some(emcy) = emcy.filter(|emcy| !emcy.cob_id.is_valid() && device.objects.contains_key(&0x1015))
    else {
        return;
    };
    // a configuration may disable EMCY on purpose
    if device.object(0x1014).is_some_and(|object| object.main.configured_value().is_some()) {
        return;
    }
    let message = say!("bit 31 of `{}` marks EMCY as not valid", emcy.cob_id);
    let place = device.value_place(0x1014, 0);
    let fix = Fix::risky("write `$NODEID+0x80`").set(place.clone(), "$NODEID+0x80");
    let finding = Diagnostic::new(&RULE.info, place, message);
    // a node without a valid node-ID has no value for the formula
    let commissioning = device.commissioning.as_ref();
    let has_value = commissioning.is_none_or(|node| matches!(node.node_id, Some(1..=127)));
    let finding = if has_value { finding.fix(fix) } else { finding };
    let finding = finding.label(Place::object(0x1015), "the inhibit time of EMCY");
    findings.push(finding.help("clear bit 31: `$NODEID+0x80`"));
}
