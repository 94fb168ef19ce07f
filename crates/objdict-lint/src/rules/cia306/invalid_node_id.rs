use crate::diagnostic::{Diagnostic, Findings, Severity, say};
use crate::model::{Commissioning, Device, Field, Part, Place};
use crate::{rule, stated};

rule! {
    "cia306/invalid-node-id", Error, Device(check);
    summary: "the node-ID of a DCF is not valid",
    checks: "Whether `NodeID` is 1 to 127, or 255 for a node that gets its node-ID by LSS. With 255, formulas with `$NODEID` are not allowed. An XDD without configured values has no node: there, 0 is a note.",
    why: "Other nodes cannot address the node, and its COB-IDs are unknown.",
    example: "`NodeID=0`",
    remedy: "Write the node-ID of the node.",
    source: "CiA 306-1 §5.4, CiA 301 §7.2.5.2",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(node) = &device.commissioning else { return };
    let place = Place::of(Part::Commissioning).field(Field::NodeId);
    let is_note = node.node_id == Some(0) && is_type(device);
    let message = match node.node_id {
        Some(1..=127) => return,
        Some(255) => match stated::first_formula(device) {
            Some(formula) => return report_unknown(place, formula, findings),
            None => return,
        },
        Some(number) => say!("`{NodeID}` is {}, but node-IDs are 1 to 127", number),
        None if is_invalid(node) => return,
        None => say!("`{NodeID}` is missing").to_owned(),
    };
    let finding = Diagnostic::new(&RULE.info, place, message)
        .help(say!("write `{NodeID=}` and a number from 1 to 127"));
    findings.push(if is_note { finding.severity(Severity::Note) } else { finding });
}

/// Whether an XML file describes a type of device, not a node: nothing in it is configured.
fn is_type(device: &Device) -> bool {
    let mut entries = device.objects.values().flat_map(crate::model::Object::described);
    device.headers.network.is_some() && !entries.any(|(_, entry)| entry.configured_value().is_some())
}

fn is_invalid(node: &Commissioning) -> bool {
    node.invalid_values.get(&Field::NodeId).is_some()
}

fn report_unknown(place: Place, formula: Place, findings: &mut Findings) {
    let message = say!("`{NodeID}` is 255, so formulas with `$NODEID` have no value");
    let finding = Diagnostic::new(&RULE.info, place, message).label(formula, "a formula");
    findings.push(finding.help("write the future node-ID of the node"));
}
