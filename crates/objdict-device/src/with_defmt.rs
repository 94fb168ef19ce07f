//! The traits of defmt for states.

use crate::NmtState;

impl defmt::Format for NmtState {
    fn format(&self, f: defmt::Formatter<'_>) {
        match self {
            Self::Initialising => defmt::write!(f, "Initialising"),
            Self::Stopped => defmt::write!(f, "Stopped"),
            Self::Operational => defmt::write!(f, "Operational"),
            Self::PreOperational => defmt::write!(f, "PreOperational"),
        }
    }
}
