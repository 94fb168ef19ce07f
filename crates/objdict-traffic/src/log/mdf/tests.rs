use super::super::tests::{read, read_in};

/// python-can wrote it, packed by columns.
#[test]
fn what_mdf_has() {
    let log = std::fs::read("../../fixtures/logs/short.mf4").unwrap();
    let expected = [
        "1700000000.500000000 1 705 received 00",
        "1700000000.625000000 1 605 sent 4017100000000000",
        "1700000000.750000000 1 585 received 4B17100064000000",
        "1700000001.000000000 1 185 received 370201",
        "1700000001.250000000 2 18EFF105 received 0102",
        "1700000001.500000000 1 705 remote received ",
        "1700000001.750000000 1 000 error ",
        "1700000002.000000000 1 185 fd received 000102030405060708090A0B",
    ];
    assert_eq!(read(&log), expected);
    assert_eq!(read_in(&log, 8), expected);
    assert_eq!(read(&log[..log.len() - 40]).last().unwrap(), "line 1: the file ends in a block");
    let earlier = [b"MDF     3.30    ", &log[16..]].concat();
    assert_eq!(read(&earlier), ["line 1: only version 4 of MDF is supported; convert the log with its tool"]);
    // a file that is cut, and every change of a byte, is read without a panic
    for at in 8..log.len() {
        read(&log[..at]);
        let mut other = log.clone();
        other[at] ^= 0x81;
        read(&other);
    }
}

/// Name, kind, data type, first bit, bits, scale, block of values.
type MadeChannel<'a> = (&'a str, u8, u8, u32, u32, [f64; 2], usize);

/// A file in which blocks are added one after the other.
struct MdfWriter(Vec<u8>);

impl MdfWriter {
    /// Adds a block; its address.
    fn block(&mut self, kind: &str, links: &[usize], data: &[&[u8]]) -> usize {
        let (address, data) = (self.0.len(), data.concat());
        let length = 24 + 8 * links.len() + data.len();
        self.0.extend_from_slice(format!("##{kind}\0\0\0\0").as_bytes());
        for number in [length, links.len()].iter().chain(links) {
            self.0.extend_from_slice(&(*number as u64).to_le_bytes());
        }
        self.0.extend(data);
        address
    }

    /// Adds channels, the last one first.
    fn channels(&mut self, channels: &[MadeChannel<'_>]) -> usize {
        channels.iter().rev().fold(0, |next, (name, kind, data_type, bit, bits, [offset, factor], values)| {
            let name = self.block("TX", &[], &[name.as_bytes(), &[0]]);
            let numbers = [offset.to_le_bytes(), factor.to_le_bytes()].concat();
            let scale = self.block("CC", &[0; 4], &[&[1, 0, 0, 0, 0, 0, 2, 0], &[0; 16], &numbers]);
            let data = [
                &[*kind, 0, *data_type, (*bit % 8) as u8][..],
                &(bit / 8).to_le_bytes(),
                &bits.to_le_bytes(),
            ]
            .concat();
            self.block("CN", &[next, 0, name, 0, scale, *values, 0, 0], &[&data])
        })
    }

    /// Adds a channel group: flags and bytes of a record.
    fn group(&mut self, next: usize, channels: usize, id: u64, flags: u16, width: u32) -> usize {
        let head = [&id.to_le_bytes()[..], &[0; 8], &flags.to_le_bytes(), &[0; 6]].concat();
        self.block("CG", &[next, channels, 0, 0, 0, 0], &[&head, &width.to_le_bytes(), &[0; 4]])
    }

    /// Ends the file with its records, each of which has its number before it.
    fn end(mut self, group: usize, records: &[u8]) -> Vec<u8> {
        let records = self.block("DT", &[], &[records]);
        let data_group = self.block("DG", &[0, group, records, 0], &[&[1, 0, 0, 0, 0, 0, 0, 0]]);
        // the header was written first
        self.0[64 + 24..64 + 32].copy_from_slice(&(data_group as u64).to_le_bytes());
        self.0
    }
}

const PLAIN: [f64; 2] = [0.0, 1.0];

fn writer(start: &[u8; 16], flags: u16) -> MdfWriter {
    let mut file = [&start[..], &[0; 44], &flags.to_le_bytes(), &[0; 2]].concat();
    file.truncate(64);
    let mut file = MdfWriter(file);
    file.block("HD", &[0; 6], &[&2_000_000_000_u64.to_le_bytes(), &[0; 24]]);
    file
}

/// As the loggers of several makers write it: bits of a byte, data in a group of their own, a channel that is a constant, codes of
/// lengths, the highest byte first.
#[test]
fn groups_and_values_are_found() {
    for (start, flags, places) in [(b"MDF     4.11    ", 0, [0, 6, 11]), (b"UnFinMF 4.11    ", 0x25, [0; 3])]
    {
        let mut file = writer(start, flags);
        let values = file.group(0, 0, 2, 1, 0);
        let channels = file.channels(&[
            ("Timestamp", 2, 0, 0, 32, [0.0, 1e-6], 0),
            ("CAN_DataFrame.IDE", 0, 0, 32, 1, PLAIN, 0),
            ("CAN_DataFrame.ID", 0, 0, 35, 29, PLAIN, 0),
            ("CAN_DataFrame.BusChannel", 6, 0, 0, 0, [9.0, 0.0], 0),
            ("CAN_DataFrame.DataBytes", 1, 10, 64, 64, PLAIN, values),
        ]);
        let data = file.group(values, channels, 1, 6, 16);
        let channels = file
            .channels(&[("t", 2, 1, 0, 16, [0.0, 0.25], 0), ("CAN_RemoteFrame.ID", 0, 1, 16, 16, PLAIN, 0)]);
        let remote = file.group(data, channels, 3, 6, 4);
        let frame = |time: u32, id: u32, place: u64| {
            [&[1][..], &time.to_le_bytes(), &id.to_le_bytes(), &place.to_le_bytes()].concat()
        };
        let value = |data: &[u8]| [&[2, data.len() as u8, 0, 0, 0][..], data].concat();
        let records = [
            frame(500_000, 0x705 << 3, places[0]),
            value(&[5, 6]),
            frame(700_000, 0x1705 << 3, places[1]),
            value(&[9]),
            vec![3, 0, 3, 0x07, 0x05],
            frame(1_000_000, 0x18EF_F105 << 3 | 1, places[2]),
            value(&[7]),
        ];
        let log = file.end(remote, &records.concat());
        let expected = [
            "2.500000000 9 705 0506",
            "2.750000000  705 remote ",
            "3.000000000 9 18EFF105 07",
            "line 2: the CAN-ID is not valid",
        ];
        assert_eq!(read(&log), expected);
    }
}

#[test]
fn lengths_may_be_codes() {
    let mut file = writer(b"MDF     4.10    ", 0);
    let channels = file.channels(&[
        ("t", 2, 4, 0, 32, PLAIN, 0),
        ("CAN_DataFrame.ID", 0, 0, 32, 32, PLAIN, 0),
        ("CAN_DataFrame.DLC", 0, 0, 64, 4, PLAIN, 0),
        ("CAN_DataFrame.EDL", 0, 0, 68, 1, PLAIN, 0),
        ("CAN_DataFrame.DataLength", 0, 0, 64, 4, PLAIN, 0),
        ("CAN_DataFrame.DataBytes", 0, 10, 72, 512, PLAIN, 0),
    ]);
    let group = file.group(0, channels, 1, 6, 73);
    let frame = |time: f32, id: u32, length: u8| {
        [&[1][..], &time.to_le_bytes(), &id.to_le_bytes(), &[length], &[0xAB; 64]].concat()
    };
    let log = file.end(
        group,
        &[frame(0.5, 0x185, 0x19), frame(1.0, 0x8000_0185, 0x0C), frame(1.5, 0x1185, 0)].concat(),
    );
    let [long, short] = [12, 8].map(|count| "AB".repeat(count));
    let expected = [
        format!("2.500000000  185 fd {long}"),
        format!("3.000000000  00000185 {short}"),
        "line 3: the CAN-ID is not valid".to_owned(),
    ];
    assert_eq!(read(&log), expected);
    let mut cut = log.clone();
    let at = cut.windows(4).position(|bytes| bytes == b"##DT").unwrap();
    cut[at + 8] -= 1;
    assert_eq!(read(&cut)[2..], ["line 1: the file ends in a block"]);
    let mut unknown = log.clone();
    let at = unknown.windows(4).position(|bytes| bytes == b"##DT").unwrap();
    unknown[at + 24] = 7;
    assert_eq!(read(&unknown), ["line 1: a record is of no channel group"]);
}
