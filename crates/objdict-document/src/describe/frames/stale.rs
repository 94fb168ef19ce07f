//! The data that must be determined again after an object of a node changed.

use crate::model::PdoKind;
use objdict_network::Service;

/// The services of a node that must be determined again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Stale {
    All,
    Pdo(PdoKind, u16),
    /// The content of a PDO, which is written entry by entry; its CAN-ID is unchanged.
    Content(PdoKind, u16),
    /// Services other than PDOs.
    Others,
}

impl Stale {
    /// The data that depends on an entry.
    pub(super) fn of((index, sub): (u16, u8)) -> Option<Self> {
        if matches!(index, 0x1005 | 0x1012 | 0x1014 | 0x1200..=0x127F) {
            return Some(Self::Others);
        }
        let made = |of: fn(PdoKind, u16) -> Self| move |(kind, number)| of(kind, number);
        let communication = if sub == 1 { Self::Pdo } else { Self::Content };
        let pdo = PdoKind::of_communication(index).map(made(communication));
        pdo.or_else(|| PdoKind::of_mapping(index).map(made(Self::Content)))
    }

    pub(super) fn has(self, service: Service) -> bool {
        match (self, service) {
            (Self::All, _) => true,
            (Self::Pdo(kind, number) | Self::Content(kind, number), service) => {
                service == Service::pdo(kind, number)
            }
            (Self::Others, service) => !matches!(service, Service::Pdo(_)),
        }
    }
}
