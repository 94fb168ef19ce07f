//! The encoding of a concise DCF: a number of entries, then index, sub-index, size and data of each. All
//! numbers are little-endian, without padding or terminator (CiA 302-3, object 1F22h).

use std::collections::BTreeMap;

use super::{ConciseDcf, Download};

/// The number of bytes of the count.
const COUNT: usize = 4;

/// Bytes of an entry before its data: index, sub-index, size.
const HEADER: usize = 7;

/// Limit of the search for padded integers in an invalid stream.
const MAX_TRIED: usize = 1 << 16;

/// A configuration too large for a stream: a count or a size exceeds 32 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EncodeError {
    what: String,
}

objdict_model::error_messages! { EncodeError: {
    Self { what } => "{what} exceeds the limit of a concise DCF, 4294967295";
} }

impl ConciseDcf {
    /// Parses a stream.
    ///
    /// # Errors
    /// If the length does not match the count and the sizes; the error contains the offset. Memory is
    /// limited by the length of the stream, not by the sizes it states.
    pub fn parse(stream: &[u8]) -> Result<Self, DecodeError> {
        let Some(count) = count(stream) else {
            return Err(DecodeError { offset: 0, kind: DecodeErrorKind::NoCount { length: stream.len() } });
        };
        decode_entries(stream, count).map_err(|error| padded_integer(stream, count).unwrap_or(error))
    }

    /// Encodes the stream.
    ///
    /// # Errors
    /// If there are more than 2³²−1 downloads, or more than 2³²−1 bytes in one of them.
    pub fn write(&self) -> Result<Vec<u8>, EncodeError> {
        encode(&self.0)
    }

    /// The downloads, each with the offset of its first byte in the stream.
    pub fn with_offsets(&self) -> impl Iterator<Item = (usize, &Download)> {
        self.0.iter().scan(COUNT, |next, download| {
            let offset = *next;
            *next += HEADER + download.data.len();
            Some((offset, download))
        })
    }
}

fn encode(downloads: &[Download]) -> Result<Vec<u8>, EncodeError> {
    let length: usize = downloads.iter().map(|download| HEADER + download.data.len()).sum();
    let count = u32::try_from(downloads.len())
        .map_err(|_| EncodeError { what: format!("a count of {} entries", downloads.len()) })?;
    let mut stream = Vec::with_capacity(COUNT + length);
    stream.extend(count.to_le_bytes());
    for Download { index, sub, data } in downloads {
        let size = u32::try_from(data.len()).map_err(|_| EncodeError {
            what: format!("the size of {} bytes for {index:04X}h sub-index {sub:X}h", data.len()),
        })?;
        stream.extend(index.to_le_bytes());
        stream.push(*sub);
        stream.extend(size.to_le_bytes());
        stream.extend(data);
    }
    Ok(stream)
}

/// The reason why a stream is not a valid concise DCF.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct DecodeError {
    /// Offset of the first invalid byte.
    pub offset: usize,
    /// The kind of the error.
    pub kind: DecodeErrorKind,
}

objdict_model::error_messages! { DecodeError: { Self { offset, kind } => "at byte {offset}: {kind}"; } }

/// Errors of a stream. Entries are counted from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecodeErrorKind {
    /// The stream is shorter than the count.
    NoCount {
        /// Length of the stream.
        length: usize,
    },
    /// The count is larger than the number of entries.
    CountTooLarge {
        /// The stated number.
        count: u32,
        /// The number of entries found.
        found: u32,
    },
    /// An entry ends within its index, sub-index or size.
    TruncatedHeader {
        /// Number of the entry.
        entry: u32,
        /// The stated number of entries.
        count: u32,
        /// Remaining bytes.
        left: usize,
    },
    /// An entry ends within its data.
    TruncatedData {
        /// Number of the entry.
        entry: u32,
        /// The stated number of entries.
        count: u32,
        /// Index of the object.
        index: u16,
        /// Sub-index of the entry.
        sub: u8,
        /// The size that the entry states.
        size: u32,
        /// Remaining bytes.
        left: usize,
    },
    /// Bytes follow the last entry.
    TrailingBytes {
        /// The stated number of entries.
        count: u32,
        /// Number of bytes after the last entry.
        left: usize,
    },
    /// A bug in the generator dcfgen: integers of 24, 40, 48 and 56 bits state their true size, but four or
    /// eight bytes follow, so every later entry is shifted.
    PaddedInteger {
        /// Number of the first such entry.
        entry: u32,
        /// The stated number of entries.
        count: u32,
        /// Index of the object.
        index: u16,
        /// Sub-index of the entry.
        sub: u8,
        /// The size that the entry states: 3, 5, 6 or 7.
        size: u32,
        /// The number of bytes that follow: 4 or 8.
        padded: u32,
    },
}

objdict_model::error_messages! { DecodeErrorKind: {
    Self::NoCount { length } => "the stream has {length} bytes, but its entry count takes 4";
    Self::CountTooLarge { count, found } => "the stream has {found} of {count} entries";
    Self::TruncatedHeader { entry, count, left } =>
        "entry {entry} of {count} has {left} of the 7 bytes for index, sub-index and size";
    Self::TruncatedData { entry, count, index, sub, size, left } =>
        "entry {entry} of {count}, {index:04X}h sub-index {sub:X}h, has a size of {size} bytes, but {left} are left";
    Self::TrailingBytes { count, left } => "{left} bytes follow the last of {count} entries";
    Self::PaddedInteger { entry, count, index, sub, size, padded } =>
        "entry {entry} of {count}, {index:04X}h sub-index {sub:X}h, has a size of {size} bytes, but {padded} bytes of data: \
         dcfgen pads integers of 24, 40, 48 and 56 bits and shifts every later entry";
} }

fn count(stream: &[u8]) -> Option<u32> {
    stream.first_chunk().copied().map(u32::from_le_bytes)
}

fn decode_entries(stream: &[u8], count: u32) -> Result<ConciseDcf, DecodeError> {
    let mut downloads = Vec::new();
    let mut at = COUNT;
    for entry in 1..=count {
        let rest = &stream[at..];
        let left = rest.len();
        let error = |offset, kind| Err(DecodeError { offset, kind });
        if rest.is_empty() {
            return error(at, DecodeErrorKind::CountTooLarge { count, found: entry - 1 });
        }
        let Some(header) = DownloadHeader::read(rest) else {
            return error(at, DecodeErrorKind::TruncatedHeader { entry, count, left });
        };
        let DownloadHeader { index, sub, size } = header;
        let Some(data) = header.data(rest) else {
            let left = left - HEADER;
            let kind = DecodeErrorKind::TruncatedData { entry, count, index, sub, size, left };
            return error(at + HEADER, kind);
        };
        downloads.push(Download::new(index, sub, data));
        at += HEADER + data.len();
    }
    match stream.len() - at {
        0 => Ok(ConciseDcf(downloads)),
        left => Err(DecodeError { offset: at, kind: DecodeErrorKind::TrailingBytes { count, left } }),
    }
}

#[derive(Clone, Copy)]
struct DownloadHeader {
    index: u16,
    sub: u8,
    size: u32,
}

impl DownloadHeader {
    fn read(rest: &[u8]) -> Option<Self> {
        let [i0, i1, sub, s0, s1, s2, s3] = *rest.first_chunk()?;
        Some(Self { index: u16::from_le_bytes([i0, i1]), sub, size: u32::from_le_bytes([s0, s1, s2, s3]) })
    }

    fn data(self, rest: &[u8]) -> Option<&[u8]> {
        rest[HEADER..].get(..usize::try_from(self.size).ok()?)
    }

    /// The number of data bytes that dcfgen writes for an integer of this size, if the stream has them and
    /// they look padded.
    fn padded(self, rest: &[u8]) -> Option<u32> {
        let padded = match self.size {
            3 => 4,
            5..=7 => 8,
            _ => return None,
        };
        let data = rest.get(HEADER..HEADER + padded as usize)?;
        let (value, padding) = data.split_at(self.size as usize);
        let negative = value.last().is_some_and(|&byte| byte >= 0x80);
        let extends = |byte: u8| padding.iter().all(|&pad| pad == byte);
        (extends(0) || negative && extends(0xFF)).then_some(padded)
    }
}

/// Checks whether the stream is valid with padded integers, and finds the first padded entry.
///
/// A three-byte string has the same size as a 24-bit integer, so the search follows both
/// alternatives. Alternatives that reach the same offset are merged.
fn padded_integer(stream: &[u8], count: u32) -> Option<DecodeError> {
    let mut ways: BTreeMap<usize, Option<DecodeError>> = BTreeMap::from([(COUNT, None)]);
    let mut tried = 0;
    for entry in 1..=count {
        let mut next = BTreeMap::new();
        for (at, first) in ways {
            tried += 1;
            let Some(rest) = stream.get(at..) else { continue };
            let Some(header) = DownloadHeader::read(rest) else { continue };
            if let Some(data) = header.data(rest) {
                next.entry(at + HEADER + data.len()).or_insert_with(|| first.clone());
            }
            if let Some(padded) = header.padded(rest) {
                let DownloadHeader { index, sub, size } = header;
                let kind = DecodeErrorKind::PaddedInteger { entry, count, index, sub, size, padded };
                let first = first.or(Some(DecodeError { offset: at, kind }));
                next.entry(at + HEADER + padded as usize).or_insert(first);
            }
        }
        if next.is_empty() || tried > MAX_TRIED {
            return None;
        }
        ways = next;
    }
    ways.remove(&stream.len()).flatten()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn bytes(hex: &str) -> Vec<u8> {
        crate::model::hex::parse(&hex.replace(' ', "")).unwrap().into()
    }

    #[test]
    fn every_kind_of_size_is_there_byte_by_byte() {
        let configuration = ConciseDcf(vec![
            Download::new(0x6423, 0, [1]),
            Download::new(0x2000, 0, [0x56, 0x34, 0x12]),
            Download::new(0x2001, 2, *b""),
        ]);
        let stream = bytes("03000000 2364 00 01000000 01 0020 00 03000000 563412 0120 02 00000000");
        assert_eq!(configuration.write(), Ok(stream.clone()));
        assert_eq!(ConciseDcf::parse(&stream), Ok(configuration));
    }

    #[test]
    fn errors_tell_the_byte() {
        let message = |hex: &str| ConciseDcf::parse(&bytes(hex)).unwrap_err().to_string();
        assert_eq!(message("010000"), "at byte 0: the stream has 3 bytes, but its entry count takes 4");
        assert_eq!(message("02000000 1710 00 02000000 FA00"), "at byte 13: the stream has 1 of 2 entries");
        assert_eq!(
            message("01000000 1710 00 0200"),
            "at byte 4: entry 1 of 1 has 5 of the 7 bytes for index, sub-index and size"
        );
        assert_eq!(
            message("01000000 1710 0A FFFFFFFF FA00"),
            "at byte 11: entry 1 of 1, 1017h sub-index Ah, has a size of 4294967295 bytes, but 2 are left"
        );
        assert_eq!(message("00000000 00"), "at byte 4: 1 bytes follow the last of 0 entries");
    }

    #[test]
    fn padded_integers_are_named() {
        let stream = bytes(
            "04000000 0820 00 03000000 616263 0020 00 03000000 FEFFFFFF 0120 00 05000000 0102030405000000 1710 00 02000000 FA00",
        );
        let error = ConciseDcf::parse(&stream).unwrap_err();
        assert_eq!(error.offset, 14);
        let expected =
            DecodeErrorKind::PaddedInteger { entry: 2, count: 4, index: 0x2000, sub: 0, size: 3, padded: 4 };
        assert_eq!(error.kind, expected);
    }

    #[test]
    fn a_stream_that_is_broken_otherwise_is_not_blamed_on_padding() {
        let stream = bytes("02000000 0020 00 03000000 010203 1710 00 09000000 FA00");
        assert!(matches!(
            ConciseDcf::parse(&stream).unwrap_err().kind,
            DecodeErrorKind::TruncatedData { entry: 2, .. }
        ));
    }

    fn configurations() -> impl Strategy<Value = ConciseDcf> {
        let data = prop::collection::vec(any::<u8>(), 0..12);
        let download =
            (any::<u16>(), any::<u8>(), data).prop_map(|(index, sub, data)| Download { index, sub, data });
        prop::collection::vec(download, 0..12).prop_map(ConciseDcf)
    }

    proptest! {
        #[test]
        fn decoding_restores_what_was_encoded(configuration in configurations()) {
            let stream = configuration.write().unwrap();
            prop_assert_eq!(ConciseDcf::parse(&stream), Ok(configuration));
        }

        #[test]
        fn what_decodes_encodes_to_the_same_bytes(stream in prop::collection::vec(any::<u8>(), 0..64)) {
            if let Ok(configuration) = ConciseDcf::parse(&stream) {
                prop_assert_eq!(configuration.write(), Ok(stream));
            }
        }

        #[test]
        fn damaged_streams_never_panic(
            configuration in configurations(),
            cut in any::<prop::sample::Index>(),
            at in any::<prop::sample::Index>(),
            byte in any::<u8>(),
        ) {
            let mut stream = configuration.write().unwrap();
            let position = at.index(stream.len());
            stream[position] = byte;
            stream.truncate(cut.index(stream.len() + 1));
            if let Ok(configuration) = ConciseDcf::parse(&stream) {
                prop_assert_eq!(configuration.write(), Ok(stream));
            }
        }
    }
}
