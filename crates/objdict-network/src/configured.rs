//! Nodes after their configuration.

use crate::download::{ConciseDcf, Download, PlanError, PlanOptions, Step, transferred_type};
use crate::model::{Assignment, Device, DeviceKind, ExplicitDownload, Moment, Value};
use crate::network::Node;
use crate::stream::Slave;

/// The device with the values that it has after the downloads.
pub(crate) fn configured(device: &Device, node_id: u8, downloads: &[Download]) -> Device {
    let mut device = device.clone();
    // PDOs are switched off for the time of their configuration, so the last value counts
    let values: Vec<Assignment> = downloads.iter().filter_map(|download| value(&device, download)).collect();
    device.assign(&values);
    device.kind = DeviceKind::Node;
    device.commissioning.get_or_insert_default().node_id = Some(node_id);
    device
}

/// What a download gives to its entry.
fn value(device: &Device, download: &Download) -> Option<Assignment> {
    let Download { index, sub, ref data } = *download;
    let value = Value::from_bytes(data, transferred_type(device, index, sub)?)?;
    Some(Assignment { index, sub, value })
}

impl Slave {
    /// The device as its DCF describes it: with the values that it is given, and apart from them the downloads that
    /// are sent also of values that the node already has.
    pub fn described(&self, node: &Node) -> Device {
        let (conditional, unconditional) =
            self.downloads.0.split_at(self.downloads.0.len() - self.unconditional);
        let mut device = configured(&node.device, self.node_id, conditional);
        let explicit = unconditional.iter().filter_map(|download| value(&device, download));
        let explicit = explicit.map(|Assignment { index, sub, value }| ExplicitDownload {
            when: Moment::After,
            index,
            sub,
            value,
        });
        let explicit: Vec<ExplicitDownload> = explicit.collect();
        device.downloads.extend(explicit);
        device
    }

    /// The downloads that give a node the values of a device, in an order that every node accepts: services are switched off by their present identifiers before
    /// they change, and application objects come before the PDOs that map them.
    ///
    /// # Errors
    /// When the description of the node has configured values that cannot be sent.
    pub fn arranged(&self, node: &Node) -> Result<ConciseDcf, PlanError> {
        self.arrange(&self.described(node))
    }

    /// The same for a device that has further values.
    ///
    /// # Errors
    /// When the description of the node has configured values that cannot be sent.
    pub fn arrange(&self, device: &Device) -> Result<ConciseDcf, PlanError> {
        let options = PlanOptions { node_id: Some(self.node_id), ..PlanOptions::default() };
        let plan = ConciseDcf::plan(device, &options)?;
        let steps = plan.steps.into_iter().filter_map(|step| match step {
            Step::Write(download) => Some(download),
            Step::File(_) => None,
        });
        Ok(ConciseDcf(steps.collect()))
    }
}
