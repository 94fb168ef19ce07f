//! Communication of a device: its services and PDOs in words, and its CAN-IDs.

use super::connections::{self, ConnectionRow};
use super::diagram::Grid;
use super::pdos::{self, PdoView};
use super::services::{self, ServiceView};
use crate::describe::Decoder;
use crate::model::Entry;

/// The communication section of a page.
pub(crate) struct Communication {
    pub(crate) services: Vec<ServiceView>,
    pub(crate) pdos: Vec<PdoView>,
    pub(crate) connections: Vec<ConnectionRow>,
}

impl Communication {
    /// Describes a device. If the device stores PDOs as objects, those implied by `CompactPDO` are included
    /// ([`Device::with_implicit_pdos`](crate::model::Device::with_implicit_pdos)). `name` supplies the names
    /// of entries.
    pub(crate) fn new(decoder: &Decoder<'_>, name: &dyn Fn(&Entry) -> String) -> Self {
        Self {
            services: services::services(decoder, name),
            pdos: pdos::pdos(decoder, name),
            connections: connections::connections(decoder),
        }
    }

    /// The grid shared by all PDO diagrams.
    pub(crate) fn grid(&self) -> Grid {
        Grid::new()
    }
}
