//! The node that a DCF or XDC is for.

use super::ending::{Failure, note};
use objdict_model::model::{Commissioning, Device};

/// The node of the output, a `kind` of file: that of the device, with what the arguments change.
pub(super) fn commissioning(
    device: &Device,
    wanted: &Commissioning,
    kind: &str,
) -> Result<Commissioning, Failure> {
    let node = restated(device, wanted);
    valid_node_id(node.node_id)?;
    if node.baud_rate.is_none() {
        note(&format!("note: the {kind} has no bit rate; set it with `--bit-rate`\n"));
    }
    Ok(node)
}

/// Refuses a node-ID that is missing or that no node has.
pub(super) fn valid_node_id(node_id: Option<u8>) -> Result<(), Failure> {
    let problem = match node_id {
        Some(1..=127) => return Ok(()),
        Some(node_id) => format!("node-ID {node_id} is out of range (1 to 127)"),
        None => "missing node-ID: a DCF or XDC is for one node".to_owned(),
    };
    Err(Failure::new(problem).help("set it with `--node-id`"))
}

/// The node of a device, with what is stated of it anew.
pub(super) fn restated(device: &Device, wanted: &Commissioning) -> Commissioning {
    let own = device.commissioning.clone().unwrap_or_default();
    Commissioning {
        node_id: wanted.node_id.or(own.node_id),
        node_name: wanted.node_name.clone().or(own.node_name),
        baud_rate: wanted.baud_rate.or(own.baud_rate),
        net_number: wanted.net_number.or(own.net_number),
        network_name: wanted.network_name.clone().or(own.network_name),
        manager: wanted.manager.or(own.manager),
        lss_serial_number: wanted.lss_serial_number.or(own.lss_serial_number),
        ..own
    }
}

/// The node-ID of a DCF that gets another one.
pub(super) fn former_node_id(device: &Device, node: &Commissioning) -> Option<u8> {
    let former = device.node_id().filter(|former| (1..=127).contains(former))?;
    (Some(former) != node.node_id).then_some(former)
}
