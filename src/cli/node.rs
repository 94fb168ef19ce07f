//! The node that a DCF or XDC is for.

use super::{Failure, note};
use crate::model::{Commissioning, Device};

/// What the arguments say of the node.
pub(super) struct Wanted {
    pub node_id: Option<u8>,
    pub baud_rate: Option<u16>,
    pub name: Option<String>,
    /// What the file is that states it.
    pub kind: &'static str,
}

/// The node of the output: that of the device, with what the arguments change.
pub(super) fn commissioning(device: &Device, wanted: &Wanted) -> Result<Commissioning, Failure> {
    let mut node = device.commissioning.clone().unwrap_or_default();
    node.node_id = wanted.node_id.or(node.node_id);
    node.baud_rate = wanted.baud_rate.or(node.baud_rate);
    if let Some(name) = &wanted.name {
        node.node_name = Some(name.clone());
    }
    if node.node_id.is_none() {
        return Err(
            Failure::new("missing node-ID: a DCF or XDC is for one node").help("set it with `--node-id`")
        );
    }
    if node.baud_rate.is_none() {
        let rate = usual_bit_rate(device);
        node.baud_rate = Some(rate);
        note(&format!(
            "note: the {} has the bit rate {rate} kbit/s; change it with `--bit-rate`\n",
            wanted.kind
        ));
    }
    Ok(node)
}

/// A bit rate that the device has, the most usual one first.
fn usual_bit_rate(device: &Device) -> u16 {
    let rates = device.device_info.as_ref().map(|info| info.baud_rates).unwrap_or_default();
    let usual = [250, 125, 500, 1000, 50, 20, 800, 10];
    usual.into_iter().find(|&rate| rates.get(rate) == Some(true)).unwrap_or(250)
}
