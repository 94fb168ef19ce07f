use crate::diagnostic::{Diagnostic, Findings, say, series};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia305/unconfigured-without-address", Warning, Device(check);
    summary: "a node waits for LSS, and nobody knows its address",
    checks: "Whether a DCF with `NodeID=255` states the four numbers by which LSS selects a node: vendor-ID, product code, revision number and serial number, the last one in 1018h sub-index 4 or as `LSS_SerialNumber`. Numbers that are 0 count as not stated, but for product code and revision number.",
    why: "A manager that does not know the numbers has to search for the node, which finds any one of its kind.",
    example: "`NodeID=255`, `LSS_SerialNumber=0`, and no value in `[1018sub4]`",
    remedy: "Write the serial number of the device's label as `LSS_SerialNumber`.",
    source: "CiA 305, CiA 306-1 §5.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(node) = device.commissioning.as_ref().filter(|node| node.node_id == Some(255)) else { return };
    let Some(info) = device.device_info.as_ref().filter(|info| info.lss_supported != Some(false)) else {
        return;
    };
    let identity = device.identity();
    let known = |number: Option<u32>| number.is_some_and(|number| number != 0);
    let numbers = [
        ("vendor-ID", known(identity.vendor_id) || known(info.vendor_number)),
        ("product code", identity.product_code.or(info.product_number).is_some()),
        ("revision number", identity.revision_number.or(info.revision_number).is_some()),
        ("serial number", known(identity.serial_number) || known(node.lss_serial_number)),
    ];
    let missing: Vec<&str> =
        numbers.into_iter().filter(|(_, is_known)| !is_known).map(|(name, _)| name).collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("LSS shall find the node, and nobody knows its {}", series(missing));
    let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(finding.help("write the numbers of the device's label"));
}
