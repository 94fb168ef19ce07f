use super::Data;

/// The bytes of all values, after the node-ID.
impl<D, const RAM: usize> defmt::Format for Data<D, RAM> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "Data({=[u8]})", self.bytes.as_slice());
    }
}
