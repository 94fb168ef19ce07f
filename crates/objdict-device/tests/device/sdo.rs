//! SDO servers.

use objdict_device::{Abort, SdoServer};
use proptest::prelude::*;

use crate::client::{Failure, Protocol, Session, request};
use crate::dictionary::{Map, UNSIGNED16, UNSIGNED32};
use crate::frame;

const BUFFER: usize = 1024;

fn session<'a>() -> Session<'a, Map, BUFFER> {
    let map = Map::default()
        .number(0x2000, 0, UNSIGNED16, 0x1234)
        .number(0x2001, 0, UNSIGNED32, 1)
        .with(0x2001, 0, |attributes| attributes.writable = false)
        .number(0x2002, 0, UNSIGNED32, 1)
        .with(0x2002, 0, |attributes| attributes.readable = false)
        .domain(0x2003, 2 * BUFFER, b"")
        .domain(0x2004, 20, b"")
        .domain(0x2005, 0, b"");
    Session::new(map)
}

fn abort<T>(abort: Abort) -> Result<T, Failure> {
    Err(Failure::Abort(abort.code()))
}

fn protocol() -> impl Strategy<Value = Protocol> {
    prop_oneof![
        any::<bool>().prop_map(|states_length| Protocol::Segmented { states_length }),
        (any::<bool>(), any::<bool>(), 1_u8..=127).prop_map(|(states_length, crc, size)| Protocol::Block {
            states_length,
            crc,
            size
        }),
    ]
}

proptest! {
    /// Any value that fits in the buffer is written and read back, by any protocol, regardless of lost
    /// segments.
    #[test]
    fn what_is_written_is_read(
        value in prop::collection::vec(any::<u8>(), 0..=BUFFER),
        download in protocol(),
        upload in protocol(),
        lost in prop::collection::vec(prop::bool::weighted(0.2), 0..300),
    ) {
        let mut session = session();
        // without a CRC or a length, a completely lost sub-block is not requested again: it may have been
        // acknowledged
        let is_safe = !matches!(download, Protocol::Block { states_length: false, crc: false, .. });
        session.lost = if is_safe { &lost } else { &[] };
        prop_assert_eq!(session.download(0x2003, 0, &value, download), Ok(()));
        prop_assert_eq!(session.dictionary.value(0x2003, 0), &value);
        session.lost = &lost;
        prop_assert_eq!(session.upload(0x2003, 0, upload), Ok(value));
        prop_assert!(!session.server.is_busy());
    }

    /// No sequence of frames makes the server panic, or prevents a response to the next transfer.
    #[test]
    fn any_frames_are_survived(frames in prop::collection::vec((prop::num::u8::ANY, any::<[u8; 3]>(), any::<[u8; 4]>()), 0..60)) {
        let mut session = session();
        for (command, entry, data) in frames {
            // often the entry of a transfer
            let [low, high] = if entry[2] & 1 == 0 { [3, 0x20] } else { [entry[0], entry[1]] };
            session.send([command, low, high, entry[2] >> 6, data[0], data[1], data[2], data[3]]);
            for _ in 0..130 {
                session.poll();
            }
        }
        session.send(request(0x80, 0, 0, [0; 4]));
        prop_assert_eq!(session.upload(0x2000, 0, Protocol::Expedited), Ok(vec![0x34, 0x12]));
    }
}

const SEGMENTED: Protocol = Protocol::Segmented { states_length: true };
const UNSTATED: Protocol = Protocol::Segmented { states_length: false };
const BLOCK: Protocol = Protocol::Block { states_length: true, crc: true, size: 127 };

#[test]
fn numbers_are_expedited_and_may_be_segmented() {
    let mut session = session();
    for (value, protocol) in
        [([1, 2], Protocol::Expedited), ([3, 4], SEGMENTED), ([5, 6], UNSTATED), ([7, 8], BLOCK)]
    {
        assert_eq!(session.download(0x2000, 0, &value, protocol), Ok(()));
        assert_eq!(session.upload(0x2000, 0, Protocol::Expedited), Ok(value.to_vec()));
    }
    // without a length, the entry's number of bytes
    assert_eq!(session.send(request(0x22, 0x2000, 0, [9, 9, 9, 9])), Some(request(0x60, 0x2000, 0, [0; 4])));
    assert_eq!(session.dictionary.value(0x2000, 0), [9, 9]);
    assert_eq!(session.upload(0x2000, 0, BLOCK), Ok(vec![9, 9]));
}

#[test]
fn what_cannot_be_done_is_aborted() {
    let mut session = session();
    for protocol in [Protocol::Expedited, BLOCK] {
        assert_eq!(session.upload(0x3000, 0, protocol), abort(Abort::NoObject));
        assert_eq!(session.upload(0x2000, 1, protocol), abort(Abort::NoSubIndex));
        assert_eq!(session.upload(0x2002, 0, protocol), abort(Abort::WriteOnly));
    }
    for protocol in [Protocol::Expedited, SEGMENTED, UNSTATED, BLOCK] {
        assert_eq!(session.download(0x3000, 0, &[0; 4], protocol), abort(Abort::NoObject));
        assert_eq!(session.download(0x2001, 0, &[0; 4], protocol), abort(Abort::ReadOnly));
        assert_eq!(session.download(0x2000, 0, &[0; 4], protocol), abort(Abort::TooLong));
        assert_eq!(session.download(0x2000, 0, &[0; 1], protocol), abort(Abort::TooShort));
    }
    for protocol in [SEGMENTED, UNSTATED, BLOCK] {
        assert_eq!(session.download(0x2003, 0, &[0; BUFFER + 1], protocol), abort(Abort::OutOfMemory));
        assert_eq!(session.download(0x2004, 0, &[0; 21], protocol), abort(Abort::TooLong));
    }
    assert_eq!(session.download(0x2005, 0, &[0; 9], BLOCK), abort(Abort::CannotStore));
    session.dictionary.set(0x2003, 0, &[0; BUFFER + 1]);
    assert_eq!(session.upload(0x2003, 0, SEGMENTED), abort(Abort::OutOfMemory));
    assert_eq!(session.dictionary.value(0x2000, 0), [0x34, 0x12]);
}

/// Frames and the resulting abort of the last one; `None` without a response.
#[test]
fn protocol_errors_are_aborted() {
    let start = |command: u8, data| request(command, 0x2003, 0, data);
    let upload = [request(0xA4, 0x2003, 0, [2, 0, 0, 0]), request(0xA3, 0, 0, [0; 4])];
    let cases: [(&[[u8; 8]], Option<Abort>); 16] = [
        (&[start(0xE0, [0; 4])], Some(Abort::UnknownCommand)),
        (&[start(0x00, [0; 4])], Some(Abort::UnknownCommand)),
        (&[start(0x60, [0; 4])], Some(Abort::UnknownCommand)),
        (&[start(0xC1, [0; 4])], Some(Abort::UnknownCommand)),
        (&[start(0xA2, [0; 4])], Some(Abort::UnknownCommand)),
        (&[start(0x80, [0; 4])], None),
        (&[start(0x20, [0; 4]), [0x10; 8]], Some(Abort::ToggleBit)),
        (&[start(0x40, [0; 4]), [0x70; 8]], Some(Abort::ToggleBit)),
        (&[start(0x40, [0; 4]), [0; 8]], Some(Abort::UnknownCommand)),
        (&[start(0xA0, [0; 4])], Some(Abort::BlockSize)),
        (&[start(0xA0, [128, 0, 0, 0])], Some(Abort::BlockSize)),
        (&[upload[0], upload[1], [0xA2, 1, 2, 0, 0, 0, 0, 0]], Some(Abort::SequenceNumber)),
        (&[start(0xC0, [0; 4]), [0; 8]], Some(Abort::SequenceNumber)),
        (&[start(0xC4, [0; 4]), [0x81; 8], [0xC1, 1, 2, 0, 0, 0, 0, 0]], Some(Abort::Crc)),
        (&[start(0x21, [9, 0, 0, 0]), [0x01; 8]], Some(Abort::TooShort)),
        (&[start(0x21, [1, 0, 0, 0]), [0x01; 8]], Some(Abort::TooLong)),
    ];
    for (frames, expected) in cases {
        let mut session = session();
        session.dictionary.set(0x2003, 0, &[7; 99]);
        let answer = frames.iter().map(|&bytes| session.send(bytes)).last().unwrap();
        let code = expected.map(|abort| abort.code().to_le_bytes());
        assert_eq!(
            answer.map(|bytes| (bytes[0], bytes[4..].to_vec())),
            code.map(|code| (0x80, code.to_vec())),
            "{frames:02X?}"
        );
        assert_eq!(session.upload(0x2000, 0, SEGMENTED), Ok(vec![0x34, 0x12]), "{frames:02X?}");
    }
}

#[test]
fn a_transfer_times_out_and_a_new_one_replaces_it() {
    let mut session = session();
    session.dictionary.set(0x2003, 0, &[7; 99]);
    session.send(request(0x40, 0x2003, 0, [0; 4]));
    session.now = SdoServer::<BUFFER>::TIMEOUT - 1;
    assert_eq!(session.poll(), None);
    session.now += 1;
    assert_eq!(session.poll(), Some(request(0x80, 0x2003, 0, Abort::Timeout.code().to_le_bytes())));
    assert_eq!(session.poll(), None);
    session.send(request(0x40, 0x2003, 0, [0; 4]));
    assert_eq!(session.upload(0x2000, 0, SEGMENTED), Ok(vec![0x34, 0x12]));
    // the client gives up
    session.send(request(0x40, 0x2003, 0, [0; 4]));
    assert_eq!(session.send(request(0x80, 0x2003, 0, [0; 4])), None);
    assert!(!session.server.is_busy());
}

#[test]
fn each_channel_has_its_cob_ids() {
    let ids = [0x1200, 0x1201].into_iter().zip([[0x666, 0x8000_0555], [0x640, 0x8000_05C0]]);
    let map =
        ids.fold(Map::default().number(0x2000, 0, UNSIGNED16, 7), |map, (index, [request, response])| {
            map.number(index, 1, UNSIGNED32, request).number(index, 2, UNSIGNED32, response)
        });
    let mut map = map;
    let mut servers = [SdoServer::<16>::new(0, 5), SdoServer::new(1, 5)];
    let mut answers = |map: &mut Map, id| -> Vec<u16> {
        let upload = frame(id, &request(0x40, 0x2000, 0, [0; 4]));
        servers
            .iter_mut()
            .filter_map(|server| server.receive(map, &upload, 0))
            .map(|answer| answer.id())
            .collect()
    };
    assert_eq!(answers(&mut map, 0x605), [0x585], "those of the default channel are fixed");
    assert_eq!(answers(&mut map, 0x640), [0_u16; 0], "bit 31: the channel is not valid");
    map.set(0x1201, 2, &0x5C0_u32.to_le_bytes());
    assert_eq!(answers(&mut map, 0x640), [0x5C0]);
    assert_eq!(answers(&mut map, 0x606), [0_u16; 0]);
}
