use crate::diagnostic::{Diagnostic, Findings, say, series};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia305/unconfigured-without-address", Warning, Device(check);
    summary: "a node gets its node-ID by LSS, but its LSS address is incomplete",
    checks: "Whether a DCF with `NodeID=255` states the four numbers of the LSS address: vendor-ID, product code, revision number and serial number, the last one in 1018h sub-index 4 or as `LSS_SerialNumber`. A 0 counts as not stated, except for product code and revision number.",
    why: "A manager without the numbers must search for the node and may find another device of the same type.",
    example: "`NodeID=255` and `LSS_SerialNumber=0`, without a value in `[1018sub4]`",
    remedy: "Write the serial number from the label of the device as `LSS_SerialNumber`.",
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
    let message = say!("`255` requires LSS, but the LSS address is missing the {}", series(missing));
    let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(finding.help("write the numbers from the label of the device"));
}
