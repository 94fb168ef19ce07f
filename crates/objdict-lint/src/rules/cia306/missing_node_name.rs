use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-node-name", Note, Device(check), fix Unsafe;
    summary: "a configured node has no name",
    checks: "Whether `[DeviceComissioning]` has `NodeName`.",
    why: "Network tools show nodes by their names. A tool that expects the key may refuse the file.",
    example: "`[DeviceComissioning]` without `NodeName`",
    remedy: "Add `NodeName`.",
    source: "CiA 306-1 §5.4",
}

fn check(device: &Device, findings: &mut Findings) {
    if device.commissioning.as_ref().is_none_or(|node| node.node_name.is_some()) {
        return;
    }
    let place = Place::of(Part::Commissioning).field(Field::NodeName);
    let message = say!("`{[DeviceComissioning]}` has no `{NodeName}`");
    let finding = Diagnostic::new(&RULE.info, place.clone(), message).help(say!("add `{NodeName}`"));
    let name = device.device_info.as_ref().and_then(|info| info.product_name.clone());
    findings.push(match name.filter(|name| !name.is_empty()) {
        Some(name) => finding.fix(Fix::risky(say!("use the name of the product")).set(place, name)),
        None => finding,
    });
}
