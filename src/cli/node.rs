//! The node that a DCF or XDC is for.

use super::{Failure, note};
use crate::model::{Commissioning, Device};

/// The node of the output, a `kind` of file: that of the device, with what the arguments change.
pub(super) fn commissioning(
    device: &Device,
    wanted: &Commissioning,
    kind: &str,
) -> Result<Commissioning, Failure> {
    let node = restated(device, wanted);
    if !node.node_id.is_some_and(|node_id| (1..=127).contains(&node_id)) {
        return Err(
            Failure::new("missing node-ID: a DCF or XDC is for one node").help("set it with `--node-id`")
        );
    }
    if node.baud_rate.is_none() {
        note(&format!("note: the {kind} states no bit rate; set it with `--bit-rate`\n"));
    }
    Ok(node)
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
