//! Frames on the bus and the time that they take.

use objdict_device::Frame;

/// A data frame or a remote frame of classical CAN with an 11-bit identifier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BusFrame {
    frame: Frame,
    is_remote: bool,
}

impl BusFrame {
    /// A remote frame; `None` for an identifier of more than 11 bits.
    pub fn remote(id: u16) -> Option<Self> {
        Some(Self { frame: Frame::new(id, &[])?, is_remote: true })
    }

    /// The identifier, 11 bits.
    pub const fn id(&self) -> u16 {
        self.frame.id()
    }

    /// The data, at most eight bytes; none of a remote frame.
    pub fn data(&self) -> &[u8] {
        self.frame.data()
    }

    /// Whether it asks for the data frame with this identifier.
    pub const fn is_remote(&self) -> bool {
        self.is_remote
    }

    /// The data frame; `None` for a remote frame.
    pub(crate) fn data_frame(&self) -> Option<&Frame> {
        (!self.is_remote).then_some(&self.frame)
    }

    /// By what arbitration decides: the lowest wins, a data frame before a remote frame.
    pub(crate) const fn priority(&self) -> (u16, bool) {
        (self.id(), self.is_remote)
    }

    /// The bits that it takes on the bus: with its stuff bits, and with the space of three bits to the next frame (ISO 11898-1).
    pub fn bits(&self) -> u32 {
        classical_bits(self.id().into(), false, self.is_remote, self.data())
    }

    /// The time that it takes on the bus in nanoseconds, at a bit rate in kbit/s.
    pub fn duration(&self, bit_rate: u16) -> u64 {
        u64::from(self.bits()) * 1_000_000 / u64::from(bit_rate.max(1))
    }
}

impl From<Frame> for BusFrame {
    fn from(frame: Frame) -> Self {
        Self { frame, is_remote: false }
    }
}

/// The bits that a frame of classical CAN takes on the bus, as [`BusFrame::bits`]; its CAN-ID may have 29 bits.
pub fn classical_bits(can_id: u32, is_extended: bool, is_remote: bool, data: &[u8]) -> u32 {
    /// Delimiters, acknowledgement, end of frame, interframe space.
    const UNSTUFFED: u32 = 1 + 2 + 7 + 3;
    let mut bits = Stream::default();
    bits.push(0, 1); // start of frame
    if is_extended {
        bits.push(can_id >> 18, 11);
        bits.push(3, 2); // substitute for the remote bit, 29-bit identifier
        bits.push(can_id, 18);
    } else {
        bits.push(can_id, 11);
    }
    bits.push(is_remote.into(), 1);
    bits.push(0, 2); // 11-bit identifier or reserved, reserved
    bits.push(data.len() as u32, 4);
    data.iter().for_each(|byte| bits.push(u32::from(*byte), 8));
    bits.push(bits.crc.into(), 15);
    bits.bits + UNSTUFFED
}

/// The part of a frame that is stuffed: after five equal bits comes one of the other kind.
#[derive(Default)]
struct Stream {
    bits: u32,
    crc: u16,
    last: Option<bool>,
    equal: u32,
}

impl Stream {
    fn push(&mut self, number: u32, count: u32) {
        for position in (0..count).rev() {
            let bit = number >> position & 1 == 1;
            self.feed_crc(bit);
            self.count(bit);
            if self.equal == 5 {
                self.count(!bit);
            }
        }
    }

    fn count(&mut self, bit: bool) {
        self.equal = if self.last == Some(bit) { self.equal + 1 } else { 1 };
        self.last = Some(bit);
        self.bits += 1;
    }

    fn feed_crc(&mut self, bit: bool) {
        const POLYNOMIAL: u16 = 0x4599;
        let is_set = bit != (self.crc >> 14 & 1 == 1);
        self.crc = self.crc << 1 & 0x7FFF;
        if is_set {
            self.crc ^= POLYNOMIAL;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(id: u16, data: &[u8]) -> BusFrame {
        Frame::new(id, data).unwrap().into()
    }

    #[test]
    fn stuff_bits_and_checksum_count() {
        let cases: [(u16, &[u8], u32); 5] = [
            (0x080, &[], 51),
            (0x000, &[1, 0], 68),
            (0x70B, &[5], 57),
            (0x18B, &[1, 2, 4, 8, 0x11], 92),
            (0x601, &[0; 8], 125),
        ];
        for (id, data, bits) in cases {
            assert_eq!(frame(id, data).bits(), bits, "{id:03X}");
        }
    }

    #[test]
    fn a_bit_has_its_time_at_every_rate() {
        let sync = frame(0x080, &[]);
        let times = [10, 125, 800, 1000].map(|rate| sync.duration(rate));
        assert_eq!(times, [5_100_000, 408_000, 63_750, 51_000]);
    }

    #[test]
    fn a_data_frame_wins_against_its_remote_frame() {
        let (data, remote) = (frame(0x70B, &[5]), BusFrame::remote(0x70B).unwrap());
        assert!(data.priority() < remote.priority() && remote.priority() < frame(0x70C, &[]).priority());
        assert!(remote.data_frame().is_none() && BusFrame::remote(0x800).is_none());
    }
}
