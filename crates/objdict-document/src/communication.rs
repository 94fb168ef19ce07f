//! How a device communicates: its services and PDOs in words, and its CAN-IDs.

use super::connections::{self, Connection};
use super::diagram::Grid;
use super::pdos::{self, PdoView};
use super::services::{self, Service};
use crate::describe::Decoder;
use crate::model::Entry;

/// What a page says of communication.
#[derive(Clone, Debug)]
pub(crate) struct Communication {
    pub(crate) services: Vec<Service>,
    pub(crate) pdos: Vec<PdoView>,
    pub(crate) connections: Vec<Connection>,
}

impl Communication {
    /// That of a device, with the PDOs that `CompactPDO` implies where it is one that has them as objects
    /// ([`Device::with_implicit_pdos`](crate::model::Device::with_implicit_pdos)). `name` says what entries are called.
    pub(crate) fn new(decoder: &Decoder<'_>, name: &dyn Fn(&Entry) -> String) -> Self {
        Self {
            services: services::services(decoder, name),
            pdos: pdos::pdos(decoder, name),
            connections: connections::connections(decoder),
        }
    }

    /// What all drawings of PDOs share.
    pub(crate) fn grid(&self) -> Grid {
        Grid::new()
    }
}
