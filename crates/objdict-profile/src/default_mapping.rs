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

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(channels: Channels) -> Vec<String> {
        let names = of_channels(&channels).into_iter().map(|pdo| {
            let (first, last) = (pdo.mapped.first().unwrap(), pdo.mapped.last().unwrap());
            let subs = format!("{:02X}-{:02X}", first.sub, last.sub);
            format!("{} {}: {:04X}:{subs}", pdo.kind.name(), pdo.number, first.index)
        });
        names.collect()
    }

    #[test]
    fn the_figures_of_the_default_mapping() {
        let all = Channels { digital_inputs: 8, digital_outputs: 8, analog_inputs: 12, analog_outputs: 12 };
        assert_eq!(
            shown(all),
            [
                "RPDO 1: 6200:01-08",
                "RPDO 2: 6411:01-04",
                "RPDO 3: 6411:05-08",
                "RPDO 4: 6411:09-0C",
                "TPDO 1: 6000:01-08",
                "TPDO 2: 6401:01-04",
                "TPDO 3: 6401:05-08",
                "TPDO 4: 6401:09-0C",
            ]
        );
    }

    #[test]
    fn few_channels_shorten_it_and_many_lengthen_it() {
        assert_eq!(
            shown(Channels { analog_inputs: 5, ..Channels::default() }),
            ["TPDO 2: 6401:01-04", "TPDO 3: 6401:05-05"]
        );
        let many = Channels { digital_outputs: 9, analog_outputs: 13, ..Channels::default() };
        assert_eq!(
            shown(many),
            [
                "RPDO 1: 6200:01-08",
                "RPDO 2: 6411:01-04",
                "RPDO 3: 6411:05-08",
                "RPDO 4: 6411:09-0C",
                "RPDO 5: 6411:0D-0D",
                "RPDO 6: 6200:09-09",
            ]
        );
    }
}
