use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Field, Part, Place};
use crate::rule;

rule! {
    "cia305/unconfigured-without-lss", Error, Device(check);
    summary: "a node waits for a node-ID by LSS but does not support LSS",
    checks: "Whether a DCF with `NodeID=255` (node-ID assigned by LSS) has `LSS_Supported=0`.",
    why: "The node is never accessible: without a node-ID it has no SDO, and without LSS it gets no node-ID.",
    example: "`NodeID=255` with `LSS_Supported=0`",
    remedy: "Write the node-ID, or `LSS_Supported=1` if the device supports it.",
    source: "CiA 305, CiA 306-1 §5.4",
}

fn check(device: &Device, findings: &mut Findings) {
    let waits = device.commissioning.as_ref().is_some_and(|node| node.node_id == Some(255));
    let refuses = device.device_info.as_ref().is_some_and(|info| info.lss_supported == Some(false));
    if !waits || !refuses {
        return;
    }
    let message = "`255` makes the node wait for LSS, but the device does not support LSS";
    let place = Place::of(Part::Commissioning).field(Field::NodeId);
    let finding = Diagnostic::new(&RULE.info, place, message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS is not supported");
    findings.push(finding.help("write the node-ID"));
}
