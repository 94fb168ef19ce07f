//! Transmission types of PDOs (CiA 301 §7.5.2.36 and §7.5.2.38).

/// Whether a transmission type is event-driven; 0 to 240 are synchronous, the values in between are reserved
/// or for remote frames.
pub(crate) const fn is_event_driven(transmission_type: u8) -> bool {
    transmission_type >= 254
}
