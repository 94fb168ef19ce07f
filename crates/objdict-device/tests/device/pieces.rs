//! Values that are longer than the buffer of the server.

use objdict_device::{Abort, Attributes, Dictionary, Scope};
use proptest::prelude::*;

use crate::client::{Failure, Protocol, Session};
use crate::dictionary::DOMAIN;

/// A memory at 2000h, which transfers values in pieces.
#[derive(Default)]
struct Memory {
    bytes: Vec<u8>,
    room: usize,
    is_complete: bool,
}

const EXISTS: Attributes = Attributes {
    size: usize::MAX,
    data_type: DOMAIN,
    readable: true,
    writable: true,
    fits_tpdo: false,
    fits_rpdo: false,
};

impl Dictionary for Memory {
    fn attributes(&self, index: u16, _: u8) -> Result<Attributes, Abort> {
        if index == 0x2000 { Ok(EXISTS) } else { Err(Abort::NoObject) }
    }

    fn read(&mut self, _: u16, _: u8, _: &mut [u8]) -> Result<usize, Abort> {
        Err(Abort::General)
    }

    fn write(&mut self, _: u16, _: u8, _: &[u8]) -> Result<(), Abort> {
        Err(Abort::General)
    }

    fn replace(&mut self, _: u16, _: u8, _: &[u8]) -> Result<(), Abort> {
        Err(Abort::General)
    }

    fn restart(&mut self, _: Scope, _: u8) {}

    fn begin_read(&mut self, _: u16, _: u8) -> Result<Option<usize>, Abort> {
        Ok(Some(self.bytes.len()))
    }

    fn read_piece(&mut self, _: u16, _: u8, offset: usize, piece: &mut [u8]) -> Result<(), Abort> {
        piece.copy_from_slice(self.bytes.get(offset..offset + piece.len()).ok_or(Abort::NoData)?);
        Ok(())
    }

    fn begin_write(&mut self, _: u16, _: u8, length: Option<usize>) -> Result<bool, Abort> {
        if length.is_some_and(|length| length > self.room) {
            return Err(Abort::OutOfMemory);
        }
        (self.bytes, self.is_complete) = (Vec::new(), false);
        Ok(true)
    }

    fn write_piece(&mut self, _: u16, _: u8, offset: usize, piece: &[u8]) -> Result<(), Abort> {
        assert_eq!(offset, self.bytes.len(), "in order, without gaps");
        if offset + piece.len() > self.room {
            return Err(Abort::OutOfMemory);
        }
        self.bytes.extend_from_slice(piece);
        Ok(())
    }

    fn end_write(&mut self, _: u16, _: u8, length: usize) -> Result<(), Abort> {
        assert_eq!(length, self.bytes.len());
        self.is_complete = true;
        Ok(())
    }
}

const SEGMENTED: Protocol = Protocol::Segmented { states_length: true };
const UNSTATED: Protocol = Protocol::Segmented { states_length: false };

fn session(room: usize) -> Session<'static, Memory, 4> {
    Session::new(Memory { room, ..Memory::default() })
}

#[test]
fn a_value_in_pieces_needs_no_buffer() {
    let value: Vec<u8> = (0..1000).map(|at| (at % 251) as u8).collect();
    for protocol in [SEGMENTED, UNSTATED, Protocol::Block { states_length: true, crc: true, size: 127 }] {
        for length in [1, 4, 5, 7, 8, 889, 890, 1000] {
            let mut session = session(1000);
            session.download(0x2000, 0, &value[..length], protocol).unwrap();
            assert!(session.dictionary.is_complete);
            assert_eq!(session.upload(0x2000, 0, protocol).unwrap(), value[..length]);
        }
    }
    let mut session = session(4);
    session.download(0x2000, 0, &value[..3], Protocol::Expedited).unwrap();
    assert!(session.dictionary.is_complete);
    assert_eq!(session.upload(0x2000, 0, Protocol::Expedited).unwrap(), value[..3]);
}

#[test]
fn a_value_that_is_too_long_is_refused_at_its_beginning() {
    let mut stated = session(10);
    assert_eq!(stated.download(0x2000, 0, &[0; 11], SEGMENTED), Err(Failure::Abort(0x0504_0005)));
    assert!(!stated.server.is_busy());
    let mut unstated = session(10);
    assert_eq!(unstated.download(0x2000, 0, &[0; 11], UNSTATED), Err(Failure::Abort(0x0504_0005)));
    assert!(!unstated.dictionary.is_complete);
}

proptest! {
    /// Segments of block transfers are lost on the way.
    #[test]
    fn lost_segments_come_again(
        value in prop::collection::vec(any::<u8>(), 1..1500),
        size in 1..=127_u8,
        lost in prop::collection::vec(prop::bool::weighted(0.1), 0..200),
    ) {
        let protocol = Protocol::Block { states_length: false, crc: true, size };
        let mut session = session(1500);
        session.lost = &lost;
        session.download(0x2000, 0, &value, protocol).unwrap();
        prop_assert!(session.dictionary.is_complete);
        prop_assert_eq!(session.upload(0x2000, 0, protocol).unwrap(), value);
    }
}
