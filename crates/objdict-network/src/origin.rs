//! The places in node descriptions to which findings refer.
//!
//! A label into a description is `Slave::origin` for a value that no download replaces, and `because` for a
//! field.

use crate::compiled::Origins;
use crate::compiled::{Slave, indexes};
use crate::diagnostic::{At, Diagnostic, Findings, Severity, SourceLabel};
use crate::messages::{MessageId, SdoCanId, Service};
use crate::model::{Entry, Field, Part, PdoKind, PdoMapping, Place};
use crate::network::{Network, Node};
use crate::source::Span;

/// Adds the cause of a finding in the description of a node.
pub(crate) fn because(finding: Diagnostic, node: usize, place: impl Into<Option<Place>>) -> Diagnostic {
    let Some(place) = place.into() else { return finding };
    let text = match &place.field {
        None => "the object",
        Some(Field::DataType) => "the data type",
        Some(Field::AccessType) => "the access",
        Some(Field::PdoMapping) => "the PDO mapping",
        Some(Field::LowLimit | Field::HighLimit) => "the limit",
        Some(_) => "in the description",
    };
    finding.label(At::Node(node, place), text)
}

/// The field of an entry that prevents a PDO of this direction from carrying it.
pub(crate) fn refusing_field(entry: &Entry, kind: PdoKind) -> Field {
    let other = if kind == PdoKind::Rpdo { PdoMapping::Tpdo } else { PdoMapping::Rpdo };
    match entry.pdo_mapping.filter(|mapping| mapping.is_mappable() && *mapping != other) {
        Some(_) => Field::AccessType,
        None => Field::PdoMapping,
    }
}

impl Node {
    /// The place of an entry's value in the description of the node at `position`; `None` if the network replaces it.
    pub(crate) fn origin(&self, position: usize, origins: &Origins, (index, sub): (u16, u8)) -> Option<At> {
        let is_said = origins.contains_key(&(index, sub));
        (!is_said).then(|| At::Node(position, self.device.value_place(index, sub)))
    }

    /// The place of the node-ID in the description; `None` if the network file states it.
    pub(crate) fn node_id_origin(&self, position: usize) -> Option<At> {
        let is_described = self.node_id.is_some_and(|node_id| node_id.at == self.file.at);
        is_described.then(|| At::Node(position, Place::of(Part::Commissioning).field(Field::NodeId)))
    }
}

impl Slave {
    /// The place of an entry's value in the description; `None` if the configuration replaces it.
    pub(crate) fn origin(&self, network: &Network, index: u16, sub: u8) -> Option<At> {
        network.nodes[self.node].origin(self.node, &self.origins, (index, sub))
    }

    /// Converts a finding of a device rule about the effective dictionary: points to the value in the network file,
    /// otherwise in the description; `node_id` is the place of a conflicting node-ID. `None` if none of the values are
    /// from the network file, or if the object already has an error.
    pub fn found(
        &self,
        network: &Network,
        finding: &Diagnostic,
        node_id: Option<Span>,
        known: &Findings,
    ) -> Option<Diagnostic> {
        let entry = |label: &SourceLabel| match &label.at {
            At::Place(Place { part: Part::Entry(index, sub), .. }) => Some((*index, *sub)),
            At::Place(Place { part: Part::Object(index), .. }) => Some((*index, 0)),
            _ => None,
        };
        let said = |label| entry(label).and_then(|(index, sub)| self.said(index, sub));
        let at = finding.labels.iter().find_map(said).or(node_id)?;
        let own: Vec<At> =
            finding.labels.iter().filter_map(entry).flat_map(|(index, _)| self.said_of(index)).collect();
        let is_own = |label: &SourceLabel| own.contains(&label.at);
        let mut errors = known.iter().filter(|known| known.severity == Severity::Error);
        if errors.any(|known| known.labels.iter().any(is_own)) {
            return None;
        }
        let message = format!("`{}`: {}", network.nodes[self.node].name.value, finding.message);
        let mut found = Diagnostic::new(finding.rule, at, message).severity(finding.severity);
        for label in finding.labels.iter().filter(|label| said(label) != Some(at)) {
            let at = match &label.at {
                At::Place(place) => said(label).map_or(At::Node(self.node, place.clone()), At::Span),
                other => other.clone(),
            };
            let text = if label.text.is_empty() { "in the description".into() } else { label.text.clone() };
            found = found.label(at, text);
        }
        found.help.clone_from(&finding.help);
        Some(found.understood())
    }

    /// Whether an entry has an intentional value: stated in the network file, or in a DCF and different from
    /// the default.
    pub(crate) fn is_configured(&self, network: &Network, index: u16, sub: u8) -> bool {
        let by_dcf = || {
            let entry = network.nodes[self.node].device.entry(index, sub)?;
            let value = entry.configured_value()?;
            Some(entry.default.as_ref() != Some(value))
        };
        self.said(index, sub).is_some() || by_dcf().unwrap_or(false)
    }

    /// The place of a service's CAN-ID in the description, which may depend on the node-ID.
    pub(crate) fn can_id_origin(&self, network: &Network, can_id: MessageId, service: Service) -> Option<At> {
        match service {
            Service::Pdo(pdo) => self.origin(network, indexes(pdo).0, 1),
            Service::Sync => self.origin(network, 0x1005, 0),
            Service::Time => self.origin(network, 0x1012, 0),
            Service::Emcy => self.origin(network, 0x1014, 0),
            Service::SdoRequest | Service::SdoResponse => {
                match self.sdo_channels().iter().find(|channel| channel.can_id == can_id) {
                    Some(SdoCanId { entry: (index, sub), .. }) => self.origin(network, *index, *sub),
                    // the manager uses the channels of other nodes
                    None if can_id.number & 0x7F != u32::from(self.node_id) => None,
                    None => network.nodes[self.node].node_id_origin(self.node),
                }
            }
            _ => network.nodes[self.node].node_id_origin(self.node),
        }
    }
}
