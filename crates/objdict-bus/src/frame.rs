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
    let can_id = u64::from(can_id);
    // start of frame, CAN-ID, remote bit, two bits of 0, length; zeros in front fill the first byte
    let end = u64::from(is_remote) << 6 | data.len() as u64 & 0xF;
    let (header, header_bytes, zeros, run) = if is_extended {
        // between its parts are the substitute for the remote bit and the mark of 29 bits
        let id = (can_id >> 18 & 0x7FF) << 20 | 3 << 18 | can_id & 0x3_FFFF;
        (id << 7 | end, 5, 1, 6)
    } else {
        ((can_id & 0x7FF) << 7 | end, 3, 5, 1)
    };
    let mut bits = StuffedBits { crc: 0, run, stuffed: 0 };
    header.to_be_bytes()[8 - header_bytes..].iter().for_each(|byte| bits.push(*byte));
    data.iter().take(8).for_each(|byte| bits.push(*byte));
    // the bit that fills the last byte differs from the one before it, so it ends no run
    let crc = bits.crc << 1 | !bits.crc & 1;
    crc.to_be_bytes().iter().for_each(|byte| bits.push(*byte));
    let sent = 8 * (header_bytes + data.len().min(8) + 2) as u32 - zeros - 1;
    // with the run that they continue, the zeros end in a stuff bit, so the frame begins a run of its own
    sent + bits.stuffed - 1 + UNSTUFFED
}

/// The part of a frame that is stuffed: after five equal bits comes one of the other kind.
struct StuffedBits {
    /// The check sum. It begins with 0, so zeros in front do not change it.
    crc: u16,
    /// The last bit, and twice the number of bits directly before it that equal it.
    run: u8,
    stuffed: u32,
}

impl StuffedBits {
    fn push(&mut self, byte: u8) {
        self.crc = (self.crc << 8 & 0x7FFF) ^ CRC[usize::from((self.crc >> 7) as u8 ^ byte)];
        let next = RUNS[usize::from(self.run & 7)][usize::from(byte)];
        self.run = next;
        self.stuffed += u32::from(next >> 3);
    }
}

/// The run at the end of a byte, by the run before it, and eight times the number of stuff bits.
const RUNS: [[u8; 256]; 8] = {
    let mut runs = [[0; 256]; 8];
    let mut at = 0;
    while at < 8 * 256 {
        let (mut last, mut equal, mut stuffed) = (at >> 8 & 1, at >> 9, 0);
        let mut bit = 8;
        while bit > 0 {
            bit -= 1;
            equal = if at >> bit & 1 == last { equal + 1 } else { 0 };
            last = at >> bit & 1;
            if equal == 4 {
                (last, equal, stuffed) = (1 - last, 0, stuffed + 1);
            }
        }
        runs[at >> 8][at & 0xFF] = (stuffed << 3 | equal << 1 | last) as u8;
        at += 1;
    }
    runs
};

/// The check sums of bytes, for the polynomial 4599h of 15 bits.
const CRC: [u16; 256] = {
    let mut sums = [0; 256];
    let mut byte = 0;
    while byte < sums.len() {
        let mut sum = (byte as u16) << 7;
        let mut bit = 0;
        while bit < 8 {
            let is_set = sum >> 14 & 1 == 1;
            sum = sum << 1 & 0x7FFF;
            if is_set {
                sum ^= 0x4599;
            }
            bit += 1;
        }
        sums[byte] = sum;
        byte += 1;
    }
    sums
};

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

    /// The same bit by bit, as a controller does it.
    fn counted(numbers: &[(u32, u32)]) -> u32 {
        let bit_of = |(number, count): (u32, u32)| (0..count).rev().map(move |at| number >> at & 1 == 1);
        let mut bits: Vec<bool> = numbers.iter().copied().flat_map(bit_of).collect();
        let crc = bits.iter().fold(0_u32, |crc, bit| {
            let is_set = *bit != (crc >> 14 & 1 == 1);
            crc << 1 & 0x7FFF ^ if is_set { 0x4599 } else { 0 }
        });
        bits.extend(bit_of((crc, 15)));
        let (mut count, mut last, mut equal) = (0, None, 0);
        for bit in bits {
            equal = if last == Some(bit) { equal + 1 } else { 1 };
            (last, count) = (Some(bit), count + 1);
            if equal == 5 {
                (last, equal, count) = (Some(!bit), 1, count + 1);
            }
        }
        count + 13
    }

    #[test]
    fn frames_are_as_long_as_counted_bit_by_bit() {
        let mut state = 0x9E37_79B9_u32;
        let mut random = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 8
        };
        for round in 0..20_000_u32 {
            // half of them have many equal bits
            let mut byte = || {
                [0, 0xFF, random() as u8, random() as u8]
                    [random() as usize % if round % 2 == 0 { 2 } else { 4 }]
            };
            let data: Vec<u8> = (0..round % 9).map(|_| byte()).collect();
            let id = random() & 0x1FFF_FFFF;
            let (is_extended, is_remote) = (round % 3 == 0, round % 7 == 0);
            let id = if is_extended { id } else { id & 0x7FF };
            let mut numbers = vec![(0, 1)];
            if is_extended {
                numbers.extend([(id >> 18, 11), (3, 2), (id, 18)]);
            } else {
                numbers.push((id, 11));
            }
            numbers.extend([(is_remote.into(), 1), (0, 2), (data.len() as u32, 4)]);
            numbers.extend(data.iter().map(|byte| (u32::from(*byte), 8)));
            assert_eq!(
                classical_bits(id, is_extended, is_remote, &data),
                counted(&numbers),
                "{id:X}#{data:02X?}"
            );
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
