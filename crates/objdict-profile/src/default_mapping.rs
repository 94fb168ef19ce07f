//! The default mapping of an I/O module (CiA 401): the channels in each PDO of an unconfigured module.

use crate::model::{MappedObject, PdoKind};

/// The numbers of I/O channels: entries of the channel arrays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Channels {
    /// Bytes of digital inputs, 6000h.
    pub digital_inputs: u8,
    /// Bytes of digital outputs, 6200h.
    pub digital_outputs: u8,
    /// Words of analogue inputs, 6401h.
    pub analog_inputs: u8,
    /// Words of analogue outputs, 6411h.
    pub analog_outputs: u8,
}

/// A PDO with its mapping.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PdoMap {
    /// The direction.
    pub kind: PdoKind,
    /// The PDO number, from 1.
    pub number: u16,
    /// The mapped objects in frame order.
    pub mapped: Vec<MappedObject>,
}

/// Number of entries in PDO 1, and in PDOs 2 to 4 together: 8 bytes, and 12 words.
const DIGITAL_IN_FIRST: usize = 8;
const WORDS_A_PDO: usize = 4;
/// PDOs 2 to 4 are for analogue channels.
const ANALOG_PDOS: usize = 3;

/// The default PDOs of a module: PDO 1 maps the first 8 bytes of digital channels, PDOs 2 to 4 map the first
/// 12 words of analogue channels; PDOs without channels are omitted. Further channels follow in PDO 5 and
/// above, numbered as CiA 301 allows: analogue channels first, then digital ones. CiA 401 §6.2, figures of
/// the default mapping.
pub fn of_channels(channels: &Channels) -> Vec<PdoMap> {
    let mut pdos =
        of_direction(PdoKind::Rpdo, (0x6200, channels.digital_outputs), (0x6411, channels.analog_outputs));
    pdos.extend(of_direction(
        PdoKind::Tpdo,
        (0x6000, channels.digital_inputs),
        (0x6401, channels.analog_inputs),
    ));
    pdos
}

fn of_direction(kind: PdoKind, digital: (u16, u8), analog: (u16, u8)) -> Vec<PdoMap> {
    let entries = |(index, count): (u16, u8), bits| -> Vec<MappedObject> {
        (1..=count).map(|sub| MappedObject { index, sub, bits }).collect()
    };
    let (bytes, words) = (entries(digital, 8), entries(analog, 16));
    let mut bytes = bytes.chunks(DIGITAL_IN_FIRST);
    let mut words = words.chunks(WORDS_A_PDO);
    let first = std::iter::once(bytes.next().unwrap_or_default());
    let usual = first.chain(words.by_ref().take(ANALOG_PDOS)).collect::<Vec<_>>();
    let usual = (1u16..).zip(usual);
    let further = (5u16..).zip(words.chain(bytes));
    let pdos = usual.chain(further).filter(|(_, mapped)| !mapped.is_empty());
    pdos.map(|(number, mapped)| PdoMap { kind, number, mapped: mapped.to_vec() }).collect()
}
