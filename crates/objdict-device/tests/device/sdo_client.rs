//! The SDO client: with the server on a bus that loses frames, and with invalid responses.

use objdict_device::{Abort, Frame, SdoClient, SdoData, SdoServer, SdoStep};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use crate::client::request;
use crate::dictionary::{Map, UNSIGNED32};
use crate::frame;

const BUFFER: usize = 1024;
const TIMEOUT: u64 = SdoClient::TIMEOUT;

/// A transfer of a client.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Transfer {
    Download,
    Upload,
    BlockDownload,
    BlockUpload,
}

use Transfer::{BlockDownload, BlockUpload, Download, Upload};

const TRANSFERS: [Transfer; 4] = [Download, Upload, BlockDownload, BlockUpload];

impl Transfer {
    const fn is_upload(self) -> bool {
        matches!(self, Upload | BlockUpload)
    }

    const fn is_block(self) -> bool {
        matches!(self, BlockDownload | BlockUpload)
    }
}

/// A client and a server. `change` gets the number of each frame, and returns the part that arrives.
struct Bus<C> {
    client: SdoClient,
    server: SdoServer<BUFFER>,
    map: Map,
    now: u64,
    frames: usize,
    change: C,
}

const fn arrives(_: usize, frame: Frame) -> Option<Frame> {
    Some(frame)
}

fn bus<C: FnMut(usize, Frame) -> Option<Frame>>(change: C) -> Bus<C> {
    let map = Map::default().domain(0x2000, BUFFER, b"").number(0x2001, 0, UNSIGNED32, 7);
    let map = map.with(0x2001, 0, |attributes| attributes.writable = false);
    Bus { client: SdoClient::new(5), server: SdoServer::new(0, 5), map, now: 0, frames: 0, change }
}

impl<C: FnMut(usize, Frame) -> Option<Frame>> Bus<C> {
    /// Begins a transfer of 2000h and runs it to its end; of an upload, `value` gets the value.
    fn run(&mut self, transfer: Transfer, value: &mut [u8]) -> Result<usize, Abort> {
        self.run_entry(transfer, 0x2000, 0, value)
    }

    fn run_entry(
        &mut self,
        transfer: Transfer,
        index: u16,
        sub: u8,
        value: &mut [u8],
    ) -> Result<usize, Abort> {
        let (client, now) = (&mut self.client, self.now);
        let mut step = match transfer {
            Download => client.download(value, index, sub, value.len(), now),
            Upload => client.upload(index, sub, now),
            BlockDownload => client.download_block(index, sub, value.len(), now),
            BlockUpload => client.upload_block(index, sub, now),
        };
        loop {
            let answer = step.frame.and_then(|frame| self.carry(frame));
            let answer = answer.and_then(|frame| self.server.receive(&mut self.map, &frame, self.now));
            if let Some(end) = step.end {
                assert!(!self.client.is_busy() && self.client.next().is_none());
                return end;
            }
            step = self.next(answer, value);
        }
    }

    fn carry(&mut self, frame: Frame) -> Option<Frame> {
        self.frames += 1;
        (self.change)(self.frames - 1, frame)
    }

    /// The next step of the client: with the response, or after a delay.
    fn next(&mut self, answer: Option<Frame>, value: &mut [u8]) -> SdoStep {
        if let Some(answer) = answer.and_then(|frame| self.carry(frame)) {
            return self.client.receive(value, &answer, self.now);
        }
        let step = self.client.poll(value, self.now);
        if step != SdoStep::default() {
            return step;
        }
        match self.server.poll(&mut self.map, self.now) {
            Some(frame) => self.next(Some(frame), value),
            None => {
                self.now += TIMEOUT / 10;
                step
            }
        }
    }

    /// An upload into a buffer that is too long.
    fn upload(&mut self, transfer: Transfer) -> Result<Vec<u8>, Abort> {
        let mut buffer = [0xEE; BUFFER];
        let length = self.run(transfer, &mut buffer)?;
        assert!(buffer[length..].iter().all(|&byte| byte == 0xEE), "nothing behind the value is changed");
        Ok(buffer[..length].to_vec())
    }

    /// A transfer of a value, and whether it arrived.
    fn exchange(&mut self, transfer: Transfer, value: &[u8]) -> Result<bool, Abort> {
        if transfer.is_upload() {
            self.map.set(0x2000, 0, value);
            return Ok(self.upload(transfer)? == value);
        }
        let length = self.run(transfer, &mut value.to_vec())?;
        Ok(length == value.len() && self.map.value(0x2000, 0) == value)
    }
}

fn value(length: usize) -> Vec<u8> {
    (0..length).map(|at| (at * 37 + at / 256 + length) as u8).collect()
}

#[test]
fn values_of_every_length_arrive_by_each_protocol() {
    let mut bus = bus(arrives);
    for length in 0..=900 {
        for transfer in TRANSFERS {
            assert_eq!(bus.exchange(transfer, &value(length)), Ok(true), "{length} bytes, {transfer:?}");
            assert!(!bus.server.is_busy());
        }
    }
    assert_eq!(bus.now, 0, "no transfer waits");
}

/// Segments in a sub-block as few as a driver can keep.
#[test]
fn sub_blocks_are_as_long_as_the_client_wants() {
    for (size, segments) in [(1, 1), (3, 3), (127, 127), (0, 127), (128, 127)] {
        let mut longest = 0;
        let mut bus = bus(|_, frame| {
            if frame.id() == 0x605 && frame.data()[0] == 0xA2 {
                longest = longest.max(frame.data()[1]);
            }
            Some(frame)
        });
        bus.client = bus.client.with_block_size(size);
        assert_eq!(bus.exchange(BlockUpload, &value(900)), Ok(true));
        assert_eq!(longest, segments);
    }
}

/// A lost frame leads to the correct value or to an error, and the next transfer works. A segment of a
/// sub-block is repeated.
#[test]
fn no_lost_frame_changes_a_value() {
    for length in [0, 1, 4, 5, 7, 8, 14, 100, 888, 889, 890, 900] {
        for transfer in TRANSFERS {
            let mut whole = bus(arrives);
            assert_eq!(whole.exchange(transfer, &value(length)), Ok(true));
            let mut arrived = 0;
            for lost in 0..whole.frames {
                let mut bus = bus(|number, frame| (number != lost).then_some(frame));
                match bus.exchange(transfer, &value(length)) {
                    Ok(is_right) => {
                        assert!(is_right, "{length} bytes, {transfer:?} without frame {lost}");
                        arrived += 1;
                    }
                    Err(abort) => assert_ne!(abort, Abort::Crc),
                }
                for next in TRANSFERS {
                    assert_eq!(bus.exchange(next, b"another value"), Ok(true), "{next:?} after {transfer:?}");
                }
            }
            // all frames except the first, the last and the acknowledgements
            let most = if transfer.is_block() && length > 100 { whole.frames - 10 } else { 0 };
            assert!(arrived >= most, "{length} bytes, {transfer:?}: {arrived} of {}", whole.frames);
        }
    }
}

/// Each bit of each response is changed once, except those that select a block upload, its CRC and its
/// length.
#[test]
fn a_changed_answer_is_an_error_or_does_no_harm() {
    for length in [3, 5, 20, 40] {
        for transfer in [Download, BlockDownload, BlockUpload] {
            let first = if transfer == BlockUpload { 8 } else { 0 };
            for bit in first..64 * 30 {
                let mut answers = 0;
                let mut bus = bus(|_, frame| {
                    let mut data = frame.data().to_vec();
                    if frame.id() == 0x585 {
                        answers += 1;
                        if answers == bit / 64 + 1 {
                            data[bit % 64 / 8] ^= 1 << (bit % 8);
                        }
                    }
                    Frame::new(frame.id(), &data)
                });
                let is_right = bus.exchange(transfer, &value(length));
                assert_ne!(is_right, Ok(false), "{length} bytes, {transfer:?}, bit {bit}");
            }
        }
    }
}

/// The responses of a server, and the result of the transfer.
fn answered(transfer: Transfer, length: usize, answers: &[[u8; 8]]) -> Option<Result<usize, Abort>> {
    let (mut client, mut data) = (SdoClient::new(5), [0; BUFFER]);
    let mut step = match transfer {
        Download => client.download(&mut data[..], 0x2000, 0, length, 0),
        Upload => client.upload(0x2000, 0, 0),
        BlockDownload => client.download_block(0x2000, 0, length, 0),
        BlockUpload => client.upload_block(0x2000, 0, 0),
    };
    for answer in answers {
        assert_eq!(step.end, None, "{answer:02X?}");
        while client.poll(&mut data[..], 0) != SdoStep::default() {}
        step = client.receive(&mut data[..length], &frame(0x585, answer), 0);
    }
    if let Some(Err(abort)) = step.end {
        let sent = answers.last().is_none_or(|answer| answer[0] != 0x80);
        let expected = frame(0x605, &request(0x80, 0x2000, 0, abort.code().to_le_bytes()));
        assert_eq!(step.frame, sent.then_some(expected));
    }
    step.end
}

/// A transfer of a length, responses, and the result.
type Case<'a> = (Transfer, usize, &'a [[u8; 8]], Result<usize, Abort>);

#[test]
fn errors_of_the_protocol_are_aborted() {
    let start = |command, data| request(command, 0x2000, 0, data);
    let cases: [Case<'_>; 20] = [
        (Download, 2, &[start(0x60, [0; 4])], Ok(2)),
        (Download, 9, &[start(0x60, [0; 4]), [0x30; 8]], Err(Abort::ToggleBit)),
        (Download, 9, &[start(0x60, [0; 4]), [0x20; 8], [0x20; 8]], Err(Abort::ToggleBit)),
        (Download, 9, &[start(0x60, [0; 4]), [0; 8]], Err(Abort::UnknownCommand)),
        (Download, 2, &[[0x20; 8]], Err(Abort::UnknownCommand)),
        (Download, 2, &[start(0xA4, [1; 4])], Err(Abort::UnknownCommand)),
        (Upload, 9, &[start(0x40, [0; 4]), [0x10; 8]], Err(Abort::ToggleBit)),
        (Upload, 9, &[start(0x41, [8, 0, 0, 0]), [0x01; 8]], Err(Abort::LengthMismatch)),
        (Upload, 9, &[start(0x41, [6, 0, 0, 0]), [0x01; 8]], Err(Abort::LengthMismatch)),
        (Upload, 6, &[start(0x40, [0; 4]), [0x01; 8]], Err(Abort::OutOfMemory)),
        (Upload, 9, &[start(0x40, [0; 4]), [0x01; 8]], Ok(7)),
        (Upload, 9, &[start(0x42, [0; 4])], Ok(4)),
        (Upload, 9, &[start(0x4F, [0; 4])], Ok(1)),
        (Upload, 9, &[start(0x80, [0x11, 0, 0x09, 0x06])], Err(Abort::NoSubIndex)),
        (BlockDownload, 9, &[start(0xA4, [0; 4])], Err(Abort::BlockSize)),
        (BlockDownload, 9, &[start(0xA4, [128, 0, 0, 0])], Err(Abort::BlockSize)),
        (BlockDownload, 9, &[start(0xA4, [1; 4]), [0xA2, 2, 9, 0, 0, 0, 0, 0]], Err(Abort::SequenceNumber)),
        (BlockUpload, 9, &[start(0xC6, [0; 4]), [0; 8]], Err(Abort::SequenceNumber)),
        (BlockUpload, 9, &[start(0xC6, [7, 0, 0, 0]), [0x81; 8], [0xC1; 8]], Err(Abort::Crc)),
        (BlockUpload, 9, &[start(0xC2, [8, 0, 0, 0]), [0x81; 8], [0xC1; 8]], Err(Abort::LengthMismatch)),
    ];
    for (transfer, length, answers, end) in cases {
        assert_eq!(answered(transfer, length, answers), Some(end), "{transfer:?} {answers:02X?}");
    }
}

#[test]
fn the_reason_of_the_server_is_known() {
    let mut bus = bus(arrives);
    for length in [4, 20] {
        for transfer in [Download, BlockDownload] {
            let mut try_it = |index, sub, length| bus.run_entry(transfer, index, sub, &mut value(length));
            assert_eq!(try_it(0x3000, 0, length), Err(Abort::NoObject));
            assert_eq!(try_it(0x2000, 1, length), Err(Abort::NoSubIndex));
            assert_eq!(try_it(0x2001, 0, length), Err(Abort::ReadOnly));
            assert_eq!(try_it(0x2000, 0, BUFFER + 1), Err(Abort::TooLong));
        }
        for transfer in [Upload, BlockUpload] {
            assert_eq!(bus.run_entry(transfer, 0x3000, 0, &mut []), Err(Abort::NoObject));
        }
    }
    bus.map.set(0x2000, 0, &value(20));
    for transfer in [Upload, BlockUpload] {
        assert_eq!(bus.run(transfer, &mut [0; 19]), Err(Abort::OutOfMemory));
        assert_eq!(bus.run(transfer, &mut [0; 20]), Ok(20));
    }
}

/// Servers without block transfers, or that prefer a different protocol for a short value.
#[test]
fn a_block_upload_may_become_another() {
    let mut bus = bus(|_, frame| {
        let mut data = frame.data().to_vec();
        if frame.id() == 0x605 && data[0] == 0xA4 {
            data[0] = 0x40;
        }
        Frame::new(frame.id(), &data)
    });
    for length in [1, 4, 5, 30] {
        assert_eq!(bus.exchange(BlockUpload, &value(length)), Ok(true));
    }
}

#[test]
fn a_transfer_without_an_answer_ends() {
    let mut client = SdoClient::new(5).with_timeout(1000);
    let step = client.upload(0x1000, 0, 7);
    assert_eq!((step.frame, step.end), (Some(frame(0x605, &request(0x40, 0x1000, 0, [0; 4]))), None));
    assert_eq!(client.next(), Some(1007));
    assert_eq!(client.poll(&mut [][..], 1006), SdoStep::default());
    let abort = frame(0x605, &request(0x80, 0x1000, 0, Abort::Timeout.code().to_le_bytes()));
    let end = SdoStep { frame: Some(abort), end: Some(Err(Abort::Timeout)) };
    assert_eq!(client.poll(&mut [][..], 1007), end);
    assert_eq!((client.is_busy(), client.next()), (false, None));
    assert_eq!(client.abort(Abort::General), SdoStep::default());
}

#[test]
fn frames_of_others_are_ignored() {
    let mut client = SdoClient::with_can_ids(0x640, 0x5C0);
    let mut data = [0; 8];
    let step = client.upload(0x1000, 0, 0);
    assert_eq!(step.frame.unwrap().id(), 0x640);
    let answer = request(0x43, 0x1000, 0, [1, 2, 3, 4]);
    let others = [
        frame(0x585, &answer),
        frame(0x5C0, &answer[..7]),
        frame(0x5C0, &request(0x43, 0x1000, 1, [0; 4])),
        frame(0x5C0, &request(0x80, 0x1001, 0, [0; 4])),
    ];
    for other in others {
        assert_eq!(client.receive(&mut data[..], &other, 5), SdoStep::default());
    }
    assert_eq!(client.next(), Some(TIMEOUT), "they do not count");
    let end = SdoStep { frame: None, end: Some(Ok(4)) };
    assert_eq!(client.receive(&mut data[..], &frame(0x5C0, &answer), 5), end);
    assert_eq!(client.receive(&mut data[..], &frame(0x5C0, &answer), 5), SdoStep::default());
    assert_eq!(data[..4], [1, 2, 3, 4]);
}

/// Numbers that are generated when sent, and added up on arrival.
struct Counter(u64);

impl SdoData for Counter {
    fn read(&mut self, offset: usize, buffer: &mut [u8]) -> Result<(), Abort> {
        buffer.iter_mut().zip(offset..).for_each(|(byte, number)| *byte = number as u8);
        Ok(())
    }

    fn write(&mut self, offset: usize, bytes: &[u8]) -> Result<(), Abort> {
        assert!(offset.is_multiple_of(7) && bytes.len() <= 7);
        self.0 += bytes.iter().map(|&byte| u64::from(byte)).sum::<u64>();
        Ok(())
    }
}

#[test]
fn data_need_no_memory() {
    let (mut client, mut server) = (SdoClient::new(5), SdoServer::<BUFFER>::new(0, 5));
    let mut map = Map::default().domain(0x2000, BUFFER, b"");
    let mut data = Counter(0);
    let begin = |client: &mut SdoClient, data: &mut Counter, number| match number {
        0 => client.download(data, 0x2000, 0, 1000, 0),
        1 => client.upload(0x2000, 0, 0),
        2 => client.download_block(0x2000, 0, 999, 0),
        _ => client.upload_block(0x2000, 0, 0),
    };
    for number in 0..4 {
        let mut step = begin(&mut client, &mut data, number);
        while step.end.is_none() {
            let answer = step.frame.and_then(|frame| server.receive(&mut map, &frame, 0));
            let answer = answer.or_else(|| server.poll(&mut map, 0));
            step = match answer {
                Some(answer) => client.receive(&mut data, &answer, 0),
                None => client.poll(&mut data, 0),
            };
        }
        step.frame.and_then(|frame| server.receive(&mut map, &frame, 0));
        assert_eq!(step.end, Some(Ok(if number < 2 { 1000 } else { 999 })));
    }
    let sum: u64 = (0..1000).chain(0..999).map(|number| number % 256).sum();
    assert_eq!(data.0, sum);
    // a slice that is only read, and data shorter than stated
    assert_eq!((&[1_u8, 2, 3][..]).write(0, &[1]), Err(Abort::CannotStore));
    assert_eq!(client.download(&mut &[1_u8, 2][..], 0x2000, 0, 3, 0).end, Some(Err(Abort::NoData)));
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(301), ..ProptestConfig::default() })]

    /// Values of any length arrive, whatever segments are lost.
    #[test]
    fn what_is_written_is_read(
        value in prop::collection::vec(any::<u8>(), 0..=BUFFER),
        size in 1_u8..=127,
        lost in prop::collection::vec(prop::bool::weighted(0.2), 0..300),
    ) {
        let mut lost = lost.into_iter();
        let mut is_segment = false;
        let mut bus = bus(|_, frame| {
            // segments of sub-blocks occur between the response to the first request and the request that
            // ends
            let command = frame.data()[0];
            match (frame.id(), command) {
                (0x585, 0xA4) | (0x605, 0xA3) => is_segment = true,
                (0x585, 0xA2) | (0x605, 0xA2) => {}
                // neither the first nor the last one
                (_, 2..=127) if is_segment => return (!lost.next().unwrap_or(false)).then_some(frame),
                _ => {}
            }
            Some(frame)
        });
        bus.client = bus.client.with_block_size(size);
        for transfer in [BlockDownload, BlockUpload] {
            if let Err(abort) = bus.exchange(transfer, &value) {
                // a sub-block of a single lost segment, or a completely lost one
                prop_assert_eq!(abort, Abort::Timeout);
            }
        }
    }

    /// No sequence of frames makes the client panic or never terminate.
    #[test]
    fn any_frames_are_survived(
        transfer in prop::sample::select(&TRANSFERS[..]),
        length in 0_usize..300,
        frames in prop::collection::vec((any::<[u8; 8]>(), 0_u8..4), 0..60),
    ) {
        let (mut client, mut data) = (SdoClient::new(5), [0; 200]);
        let mut ends = 0;
        match transfer {
            Download => client.download(&mut data[..], 0x2000, 0, length, 0),
            Upload => client.upload(0x2000, 0, 0),
            BlockDownload => client.download_block(0x2000, 0, length, 0),
            BlockUpload => client.upload_block(0x2000, 0, 0),
        };
        for (mut bytes, kind) in frames {
            if kind > 0 {
                bytes[1..4].copy_from_slice(&[0, 0x20, 0]);
            }
            if kind == 2 {
                bytes[0] = [0x60, 0x41, 0xA4, 0xC6][bytes[0] as usize % 4];
            }
            ends += usize::from(client.receive(&mut data[..], &frame(0x585, &bytes), 0).end.is_some());
            for _ in 0..127 {
                ends += usize::from(client.poll(&mut data[..], 0).end.is_some());
            }
            prop_assert_eq!(client.poll(&mut data[..], 0), SdoStep::default());
        }
        ends += usize::from(client.poll(&mut data[..], TIMEOUT).end.is_some());
        prop_assert!(!client.is_busy() && ends <= 1);
    }
}
