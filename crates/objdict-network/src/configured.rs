//! Nodes after their configuration.

use crate::download::{ConciseDcf, Download, PlanError, PlanOptions, Step, transferred_type};
use crate::model::{Assignment, Device, DeviceKind, Value};
use crate::network::Node;
use crate::stream::Slave;

/// The device with the values that it has after the downloads.
pub(crate) fn configured(device: &Device, node_id: u8, downloads: &[Download]) -> Device {
    let mut device = device.clone();
    let value = |download: &Download| {
        let data_type = transferred_type(&device, download.index, download.sub)?;
        let value = Value::from_bytes(&download.data, data_type)?;
        Some(Assignment { index: download.index, sub: download.sub, value })
    };
    // PDOs are switched off for the time of their configuration, so the last value counts
    let values: Vec<Assignment> = downloads.iter().filter_map(value).collect();
    device.assign(&values);
    device.kind = DeviceKind::Node;
    device.commissioning.get_or_insert_default().node_id = Some(node_id);
    device
}

impl Slave {
    /// The configuration in an order that every node accepts: services are switched off by their present identifiers before
    /// they change, and application objects come before the PDOs that map them. Downloads that are sent whatever the present
    /// values are stay at the end.
    ///
    /// # Errors
    /// When the description of the node has configured values that cannot be sent.
    pub fn arranged(&self, node: &Node) -> Result<ConciseDcf, PlanError> {
        let (conditional, unconditional) =
            self.downloads.0.split_at(self.downloads.0.len() - self.unconditional);
        let device = configured(&node.device, self.node_id, conditional);
        let options = PlanOptions { node_id: Some(self.node_id), ..PlanOptions::default() };
        let plan = ConciseDcf::plan(&device, &options)?;
        let steps = plan.steps.into_iter().filter_map(|step| match step {
            Step::Write(download) => Some(download),
            Step::File(_) => None,
        });
        Ok(ConciseDcf(steps.chain(unconditional.iter().cloned()).collect()))
    }
}
