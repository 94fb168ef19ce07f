//! Frames of classical CAN with 11-bit identifiers.

/// A data frame. This crate does not support frames with 29-bit identifiers and remote frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frame {
    id: u16,
    length: u8,
    bytes: [u8; 8],
}

impl Frame {
    /// A frame; `None` if the identifier exceeds 11 bits or the data exceed eight bytes.
    #[must_use]
    pub fn new(id: u16, data: &[u8]) -> Option<Self> {
        let mut bytes = [0; 8];
        bytes.get_mut(..data.len())?.iter_mut().zip(data).for_each(|(to, from)| *to = *from);
        let length = u8::try_from(data.len()).ok()?;
        (id <= Self::HIGHEST_ID).then_some(Self { id, length, bytes })
    }

    const HIGHEST_ID: u16 = 0x7FF;

    /// A frame of eight bytes with the lower 11 bits of a COB-ID.
    pub(crate) const fn full(cob_id: u32, bytes: [u8; 8]) -> Self {
        Self { id: can_id(cob_id), length: 8, bytes }
    }

    /// Shortens the data to the first `length` bytes, at most eight.
    pub(crate) const fn shortened(mut self, length: u8) -> Self {
        if length < self.length {
            self.length = length;
        }
        self
    }

    /// The identifier, 11 bits.
    #[must_use]
    pub const fn id(&self) -> u16 {
        self.id
    }

    /// The data, at most eight bytes.
    #[must_use]
    pub fn data(&self) -> &[u8] {
        self.bytes.get(..usize::from(self.length)).unwrap_or(&self.bytes)
    }

    /// The data, padded with zeros to eight bytes.
    pub(crate) const fn bytes(&self) -> [u8; 8] {
        self.bytes
    }
}

/// The bit of a COB-ID that marks the communication object as not valid.
pub(crate) const NOT_VALID: u32 = 1 << 31;

/// The bit of a COB-ID that selects a 29-bit CAN-ID.
pub(crate) const EXTENDED: u32 = 1 << 29;

/// The lower 11 bits of a COB-ID.
pub(crate) const fn can_id(cob_id: u32) -> u16 {
    (cob_id & Frame::HIGHEST_ID as u32) as u16
}

#[cfg(feature = "embedded-can")]
impl Frame {
    /// Converts a frame of a driver; `None` for a remote frame or a 29-bit identifier.
    #[must_use]
    pub fn from_driver(frame: &impl embedded_can::Frame) -> Option<Self> {
        match frame.id() {
            embedded_can::Id::Standard(id) if frame.is_data_frame() => Self::new(id.as_raw(), frame.data()),
            _ => None,
        }
    }

    /// Converts the frame to the type of a driver; `None` if the driver rejects it.
    #[must_use]
    pub fn to_driver<F: embedded_can::Frame>(&self) -> Option<F> {
        F::new(embedded_can::StandardId::new(self.id)?, self.data())
    }
}
