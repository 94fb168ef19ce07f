//! Nodes after their configuration.

use std::borrow::Cow;
use std::collections::BTreeMap;

use crate::download::{ConciseDcf, Download, Order, PlanError, PlanOptions, Step, effective};
use crate::model::{Device, DeviceKind, ExplicitDownload, Moment};
use crate::network::Node;
use crate::source::Span;
use crate::stream::Slave;

/// The device before the network configures it.
pub(crate) fn before(node: &Node, node_id: u8) -> Device {
    let mut device = effective(&node.device).into_owned();
    device.kind = DeviceKind::Node;
    device.commissioning.get_or_insert_default().node_id = Some(node_id);
    device
}

/// Where the network file has the final values of entries.
pub(crate) type Origins = BTreeMap<(u16, u8), Span>;

impl Slave {
    /// Where the network file has the final value of an entry; `None` if the description has it.
    pub(crate) fn said(&self, index: u16, sub: u8) -> Option<Span> {
        self.origins.get(&(index, sub)).copied()
    }

    /// The device as its DCF describes it: with its effective values, and apart from them the downloads that
    /// are sent also of values that the node already has.
    pub fn described(&self) -> Device {
        let (conditional, unconditional) =
            self.downloads.0.split_at(self.downloads.0.len() - self.unconditional);
        let mut device = self.device.clone();
        // the network file counts more than the description
        let is_replaced = |download: &ExplicitDownload| {
            conditional.iter().any(|other| (other.index, other.sub) == (download.index, download.sub))
        };
        device.downloads.retain(|download| !is_replaced(download));
        let explicit = |download: &Download| {
            let value = download.value(&self.device)?;
            Some(ExplicitDownload { when: Moment::After, index: download.index, sub: download.sub, value })
        };
        device.downloads.extend(unconditional.iter().filter_map(explicit));
        device
    }

    /// The downloads that give a node its effective values, in an order that every node accepts: services are switched off by their present identifiers before
    /// they change, and application objects come before the PDOs that map them.
    ///
    /// # Errors
    /// When the description of the node has configured values that cannot be sent.
    pub fn arranged(&self) -> Result<ConciseDcf, PlanError> {
        self.arrange(&self.described())
    }

    /// The downloads that Lely's master makes.
    ///
    /// # Errors
    /// When the description of the node has configured values that cannot be sent.
    pub fn sent(&self, order: Order) -> Result<Cow<'_, ConciseDcf>, PlanError> {
        match order {
            Order::Safe => self.arranged().map(Cow::Owned),
            Order::Dcfgen => Ok(Cow::Borrowed(&self.downloads)),
        }
    }

    /// The same as [`arranged`](Self::arranged) for a device that has further values.
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
