//! `[DeviceComissioning]` of a DCF.

use crate::diagnostic::{Findings, Fix, Severity, say, series};
use crate::model::{BaudRates, Commissioning, Device, DeviceKind, Field, Part, Place};
use crate::rule::rules;
use crate::stated;

rules! {
    source: "CiA 306-1 §5.4";

    "cia306/invalid-baud-rate" = INVALID_BAUD_RATE, Error, Device(invalid_baud_rate);
    summary: "the bit rate of a DCF is not valid",
    checks: "Whether `Baudrate` is a CiA 301 bit rate (10, 20, 50, 125, 250, 500, 800, 1000 kbit/s) and the device supports it according to `BaudRate_x`. 0, which tools write when no bit rate is selected, is a warning.",
    why: "A node with a wrong bit rate disturbs the network or cannot communicate.",
    example: "`Baudrate=500000`",
    remedy: "Write the bit rate in kbit/s.",
    source: "CiA 306-1 §5.4, CiA 301 §6.2",

    "cia306/invalid-node-id" = INVALID_NODE_ID, Error, Device(invalid_node_id);
    summary: "the node-ID of a DCF is not valid",
    checks: "Whether `NodeID` is 1 to 127, or 255 for a node that gets its node-ID by LSS. With 255, formulas with `$NODEID` are not allowed. An XDD without configured values has no node: there, 0 is a note.",
    why: "Other nodes cannot address the node, and its COB-IDs are unknown.",
    example: "`NodeID=0`",
    remedy: "Write the node-ID of the node.",
    source: "CiA 306-1 §5.4, CiA 301 §7.2.5.2",

    "cia306/missing-commissioning" = MISSING_COMMISSIONING, Error, Device(missing_commissioning);
    summary: "a DCF has no node-ID and bit rate",
    checks: "Whether a DCF has a section `[DeviceComissioning]` (the standard spells the name with one m). The finding is a warning if no value is a formula with `$NODEID`: some masters get their node-ID from the application program.",
    why: "Without node-ID and bit rate, the node cannot be addressed, and formulas with `$NODEID` have no value.",
    example: "An EDS that was renamed to .dcf",
    remedy: "Add the section with `NodeID` and `Baudrate`.",

    "cia306/missing-node-name" = MISSING_NODE_NAME, Note, Device(missing_node_name), fix Unsafe;
    summary: "a configured node has no name",
    checks: "Whether `[DeviceComissioning]` has `NodeName`.",
    why: "Network tools show nodes by their names. A tool that expects the key may refuse the file.",
    example: "`[DeviceComissioning]` without `NodeName`",
    remedy: "Add `NodeName`.",
}

fn invalid_baud_rate(device: &Device, findings: &mut Findings) {
    let Some(rate) = device.commissioning.as_ref().and_then(|node| node.baud_rate) else { return };
    let place = Place::of(Part::Commissioning).field(Field::Baudrate);
    if !BaudRates::DEFINED.contains(&rate) {
        let message = match rate {
            0 => say!("`{Baudrate}` is 0: no bit rate is selected").to_owned(),
            _ => say!("`{Baudrate}` is {}, but CANopen does not define this bit rate", rate),
        };
        let finding = INVALID_BAUD_RATE.at(place, message).severity(if rate == 0 {
            Severity::Warning
        } else {
            Severity::Error
        });
        findings
            .push(finding.help(say!("write one of the bit rates in kbit/s: {}", series(BaudRates::DEFINED))));
        return;
    }
    let Some(info) = &device.device_info else { return };
    let supported: Vec<u16> = info.baud_rates.supported().collect();
    // another rule reports a device without bit rates
    if supported.is_empty() || supported.contains(&rate) {
        return;
    }
    let field = info.baud_rates.iter().find(|(other, ..)| *other == rate).map(|(_, field, _)| field);
    if field.as_ref().is_some_and(|field| info.invalid_values.get(field).is_some()) {
        return;
    }
    let message = say!("`{Baudrate}` is {}, which the device does not support", rate);
    let label = Place { field, ..Place::of(Part::DeviceInfo) };
    let finding = INVALID_BAUD_RATE.at(place, message).label(label, "not supported");
    findings
        .push(finding.help(say!("write a bit rate that the device supports: {} kbit/s", series(supported))));
}

fn invalid_node_id(device: &Device, findings: &mut Findings) {
    let Some(node) = &device.commissioning else { return };
    let place = Place::of(Part::Commissioning).field(Field::NodeId);
    let is_note = node.node_id == Some(0) && is_type_description(device);
    let message = match node.node_id {
        Some(1..=127) => return,
        Some(255) => match stated::first_formula(device) {
            Some(formula) => return report_unknown_node_id(place, formula, findings),
            None => return,
        },
        Some(number) => say!("`{NodeID}` is {}, but node-IDs are 1 to 127", number),
        None if has_invalid_node_id(node) => return,
        None => say!("`{NodeID}` is missing").to_owned(),
    };
    let finding =
        INVALID_NODE_ID.at(place, message).help(say!("write `{NodeID=}` and a number from 1 to 127"));
    findings.push(if is_note { finding.severity(Severity::Note) } else { finding });
}

/// Whether an XML file describes a type of device, not a node: nothing in it is configured.
fn is_type_description(device: &Device) -> bool {
    let mut entries = device.objects.values().flat_map(crate::model::Object::described);
    device.headers.network.is_some() && !entries.any(|(_, entry)| entry.configured_value().is_some())
}

fn has_invalid_node_id(node: &Commissioning) -> bool {
    node.invalid_values.get(&Field::NodeId).is_some()
}

fn report_unknown_node_id(place: Place, formula: Place, findings: &mut Findings) {
    let message = say!("`{NodeID}` is 255, so formulas with `$NODEID` have no value");
    let finding = INVALID_NODE_ID.at(place, message).label(formula, "a formula");
    findings.push(finding.help("write the future node-ID of the node"));
}

fn missing_commissioning(device: &Device, findings: &mut Findings) {
    let says_something = !device.objects.is_empty() || device.device_info.is_some();
    if device.kind == DeviceKind::Node && device.commissioning.is_none() && says_something {
        let message = say!("{section} `{[DeviceComissioning]}` is missing");
        let finding = MISSING_COMMISSIONING.at(Place::device(), message);
        let finding = match stated::first_formula(device) {
            Some(formula) => finding.label(formula, "a formula without a value"),
            None => finding.severity(Severity::Warning),
        };
        findings.push(finding.help(say!("add the {section} with `{NodeID}` and `{Baudrate}`")));
    }
}

fn missing_node_name(device: &Device, findings: &mut Findings) {
    if device.commissioning.as_ref().is_none_or(|node| node.node_name.is_some()) {
        return;
    }
    let place = Place::of(Part::Commissioning).field(Field::NodeName);
    let message = say!("`{[DeviceComissioning]}` has no `{NodeName}`");
    let finding = MISSING_NODE_NAME.at(place.clone(), message).help(say!("add `{NodeName}`"));
    let name = device.device_info.as_ref().and_then(|info| info.product_name.clone());
    findings.push(match name.filter(|name| !name.is_empty()) {
        Some(name) => finding.fix(Fix::risky(say!("use the name of the product")).set(place, name)),
        None => finding,
    });
}
