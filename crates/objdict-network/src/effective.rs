//! Nodes after their configuration.

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::compiled::Slave;
use crate::diagnostic::At;
use crate::download::{ConciseDcf, Download, Order, PlanError, PlanOptions, effective};
use crate::model::{Device, DeviceKind, ExplicitDownload, Moment, Object};
use crate::network::{Network, Node};
use crate::source::Span;

/// The device before the network configures it.
pub(crate) fn before(node: &Node, node_id: u8) -> Device {
    let mut device = effective(&node.device).into_owned();
    device.kind = DeviceKind::Node;
    device.commissioning.get_or_insert_default().node_id = Some(node_id);
    device
}

/// The device at power-on, whose initial values become its defaults: dcfgen assumes that a node has its configured
/// values, even those of an EDS.
pub fn switched_on<'n>(network: &Network, node: &'n Node) -> Cow<'n, Device> {
    let is_configured =
        |object: &Object| object.described().any(|(_, entry)| entry.configured_value().is_some());
    let has_values =
        |object: &Object| object.compact.as_ref().is_some_and(|compact| !compact.values.is_empty());
    let mut objects = node.device.objects.values();
    if network.order != Order::Dcfgen || !objects.any(|object| is_configured(object) || has_values(object)) {
        return Cow::Borrowed(&node.device);
    }
    let mut device = node.device.clone();
    for object in device.objects.values_mut_of(is_configured) {
        for entry in object.subs.iter_mut().map(|(_, entry)| entry).chain([&mut object.main]) {
            if let Some(value) = entry.configured_value().cloned() {
                entry.default = Some(value);
            }
        }
    }
    Cow::Owned(device)
}

/// The object, and the other object of its PDO.
fn with_pdo(index: u16) -> impl Iterator<Item = u16> {
    let other = (0x1400..0x1C00).contains(&index).then_some(index ^ 0x0200);
    [index].into_iter().chain(other)
}

impl Slave {
    /// The position of an entry's final value in the network file; `None` if it is from the description.
    pub(crate) fn said(&self, index: u16, sub: u8) -> Option<Span> {
        self.origins.get(&(index, sub)).copied()
    }

    /// The positions of an object's values in the network file, including replaced ones; for a PDO, the
    /// values of both objects.
    pub fn said_of(&self, index: u16) -> impl Iterator<Item = At> + '_ {
        with_pdo(index).flat_map(|index| {
            let last = self.origins.range((index, 0)..=(index, u8::MAX)).map(|(_, span)| *span);
            let former = self.former.iter().filter(move |(of, _)| *of == index).map(|(_, span)| *span);
            last.chain(former).map(At::Span)
        })
    }

    /// The objects for which [`said_of`](Self::said_of) has a position.
    pub fn said_objects(&self) -> BTreeSet<u16> {
        let last = self.origins.keys().map(|(index, _)| *index);
        last.chain(self.former.iter().map(|(index, _)| *index)).flat_map(with_pdo).collect()
    }

    /// The device of the node's DCF: with its effective values, and separately the downloads that are sent
    /// even if the node already has their values.
    pub fn described(&self) -> Device {
        let (conditional, unconditional) =
            self.downloads.0.split_at(self.downloads.0.len() - self.unconditional);
        let mut device = self.device.clone();
        // the network file overrides the description
        let is_replaced = |download: &ExplicitDownload| {
            conditional.iter().any(|other| other.entry() == (download.index, download.sub))
        };
        device.downloads.retain(|download| !is_replaced(download));
        let explicit = |download: &Download| {
            let value = download.value(&self.device)?;
            Some(ExplicitDownload { when: Moment::After, index: download.index, sub: download.sub, value })
        };
        device.downloads.extend(unconditional.iter().filter_map(explicit));
        device
    }

    /// The downloads that assign a node its effective values, in an order that every node accepts: services are
    /// disabled using their present identifiers before they change, and application objects come before the PDOs that
    /// map them.
    ///
    /// # Errors
    /// If the description of the node has configured values that cannot be sent.
    pub fn arranged(&self) -> Result<&ConciseDcf, PlanError> {
        self.arranged.get_or_init(|| self.arrange(&self.described())).as_ref().map_err(PlanError::clone)
    }

    /// Like [`arranged`](Self::arranged); unsendable downloads are as in the network file.
    pub fn arranged_or_stated(&self) -> &ConciseDcf {
        self.arranged().unwrap_or(&self.downloads)
    }

    /// The downloads that Lely's master sends.
    ///
    /// # Errors
    /// If the description of the node has configured values that cannot be sent.
    pub fn sent(&self, order: Order) -> Result<&ConciseDcf, PlanError> {
        match order {
            Order::Safe => self.arranged(),
            Order::Dcfgen => Ok(&self.downloads),
        }
    }

    /// Like [`arranged`](Self::arranged), for a device that has further values.
    ///
    /// # Errors
    /// If the description of the node has configured values that cannot be sent.
    pub fn arrange(&self, device: &Device) -> Result<ConciseDcf, PlanError> {
        let options = PlanOptions { node_id: Some(self.node_id), ..PlanOptions::default() };
        Ok(ConciseDcf::plan(device, &options)?.without_files())
    }
}
