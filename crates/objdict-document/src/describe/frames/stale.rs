//! What has to be found again after an object of a node changed.

use crate::model::PdoKind;
use objdict_network::Service;

/// The services of a node that have to be found again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Stale {
    All,
    Pdo(PdoKind, u16),
    /// Those that are no PDOs.
    Others,
}

impl Stale {
    /// What an object decides.
    pub(super) fn of(index: u16) -> Option<Self> {
        let pdo = || PdoKind::of_communication(index).or_else(|| PdoKind::of_mapping(index));
        match index {
            0x1005 | 0x1012 | 0x1014 | 0x1200..=0x127F => Some(Self::Others),
            _ => pdo().map(|(kind, number)| Self::Pdo(kind, number)),
        }
    }

    pub(super) fn has(self, service: Service) -> bool {
        match (self, service) {
            (Self::All, _) => true,
            (Self::Pdo(kind, number), service) => service == Service::pdo(kind, number),
            (Self::Others, service) => !matches!(service, Service::Pdo(_)),
        }
    }
}
