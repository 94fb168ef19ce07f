//! An SDO client, on a bus that loses segments of block transfers.

use objdict_device::{Dictionary, Frame, SdoServer};

use crate::frame;

/// The transfer protocols that a client can request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Protocol {
    Expedited,
    Segmented { states_length: bool },
    Block { states_length: bool, crc: bool, size: u8 },
}

/// The client, the server and the connection between them. `lost` returns for each segment of a block transfer whether
/// it is lost; those after its end arrive.
pub(crate) struct Session<'a, D, const BUFFER: usize> {
    pub(crate) server: SdoServer<BUFFER>,
    pub(crate) dictionary: D,
    pub(crate) now: u64,
    pub(crate) lost: &'a [bool],
}

/// The reason of an abort, or the command of an unexpected response.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    Abort(u32),
    Protocol(String),
}

pub(crate) type Outcome<T> = Result<T, Failure>;

const NODE: u8 = 5;

impl<'a, D: Dictionary, const BUFFER: usize> Session<'a, D, BUFFER> {
    pub(crate) fn new(dictionary: D) -> Self {
        Self { server: SdoServer::new(0, NODE), dictionary, now: 0, lost: &[] }
    }

    pub(crate) fn send(&mut self, bytes: [u8; 8]) -> Option<[u8; 8]> {
        let answer = self.server.receive(&mut self.dictionary, &frame(0x605, &bytes), self.now);
        answer.map(|frame| bytes_of(&frame))
    }

    pub(crate) fn poll(&mut self) -> Option<[u8; 8]> {
        let sent = self.server.poll(&mut self.dictionary, self.now);
        sent.map(|frame| bytes_of(&frame))
    }

    /// Sends a request and checks the command of the response under a mask.
    pub(crate) fn ask(&mut self, request: [u8; 8], command: u8, mask: u8) -> Outcome<[u8; 8]> {
        let answer = self.send(request);
        accept(answer, command, mask)
    }

    fn is_lost(&mut self) -> bool {
        let Some((&first, rest)) = self.lost.split_first() else { return false };
        self.lost = rest;
        first
    }

    pub(crate) fn download(&mut self, index: u16, sub: u8, value: &[u8], protocol: Protocol) -> Outcome<()> {
        let length = (value.len() as u32).to_le_bytes();
        match protocol {
            Protocol::Expedited => {
                let mut data = [0; 4];
                data[..value.len()].copy_from_slice(value);
                let command = 0x23 | (4 - value.len() as u8) << 2;
                self.ask(request(command, index, sub, data), 0x60, 0xFF).map(drop)
            }
            Protocol::Segmented { states_length } => {
                let data = if states_length { length } else { [0; 4] };
                self.ask(request(0x20 | u8::from(states_length), index, sub, data), 0x60, 0xFF)?;
                for (at, part) in parts(value).enumerate() {
                    let toggle = (at as u8 & 1) << 4;
                    let is_last = (at + 1) * 7 >= value.len();
                    let command = toggle | (7 - part.len() as u8) << 1 | u8::from(is_last);
                    self.ask(segment(command, part), 0x20 | toggle, 0xFF)?;
                }
                Ok(())
            }
            Protocol::Block { states_length, crc, .. } => {
                let command = 0xC0 | u8::from(crc) << 2 | u8::from(states_length) << 1;
                let data = if states_length { length } else { [0; 4] };
                let answer = self.ask(request(command, index, sub, data), 0xA0, 0xFB)?;
                self.send_block(value, answer[4])?;
                let unused = (7 - parts(value).last().unwrap().len()) as u8;
                let [low, high] = if crc { checksum(value).to_le_bytes() } else { [0; 2] };
                self.ask([0xC1 | unused << 2, low, high, 0, 0, 0, 0, 0], 0xA1, 0xFF).map(drop)
            }
        }
    }

    fn send_block(&mut self, value: &[u8], mut size: u8) -> Outcome<()> {
        let parts: Vec<_> = parts(value).collect();
        let (mut done, mut is_late) = (0, false);
        while done < parts.len() {
            let block = &parts[done..parts.len().min(done + usize::from(size))];
            let mut answer = None;
            for (part, sequence) in block.iter().zip(1..) {
                let is_last = done + usize::from(sequence) == parts.len();
                // a client whose frames are lost twice gives up
                if !self.is_lost() || is_late && sequence == 1 {
                    answer = self.send(segment(sequence | u8::from(is_last) << 7, part));
                }
            }
            is_late = answer.is_none();
            if is_late {
                // the end was lost: the server acknowledges its segments after a while
                self.now += SdoServer::<BUFFER>::TIMEOUT / 2;
                answer = self.poll();
            }
            let [_, acknowledged, next, ..] = accept(answer, 0xA2, 0xFF)?;
            done += usize::from(acknowledged);
            size = next;
        }
        Ok(())
    }

    pub(crate) fn upload(&mut self, index: u16, sub: u8, protocol: Protocol) -> Outcome<Vec<u8>> {
        let Protocol::Block { crc, size, .. } = protocol else { return self.upload_segments(index, sub) };
        let answer = self.ask(request(0xA0 | u8::from(crc) << 2, index, sub, [size, 0, 0, 0]), 0xC2, 0xFB)?;
        let length = u32::from_le_bytes(answer[4..].try_into().unwrap()) as usize;
        let start = self.send([0xA3, 0, 0, 0, 0, 0, 0, 0]);
        assert_eq!(start, None, "segments come one by one");
        let mut value = Vec::new();
        let mut is_complete = false;
        let end = loop {
            let mut expected = 1;
            while let Some(bytes) = self.poll() {
                let is_in_order = bytes[0] & 0x7F == expected;
                if !self.is_lost() && is_in_order {
                    value.extend_from_slice(&bytes[1..]);
                    is_complete |= bytes[0] & 0x80 != 0;
                    expected += 1;
                }
            }
            let answer = self.send([0xA2, expected - 1, size, 0, 0, 0, 0, 0]);
            if is_complete {
                break accept(answer, 0xC1, 0xE3)?;
            }
            accept(answer.or(Some([0; 8])), 0, 0xFF)?;
        };
        value.truncate(value.len() - usize::from(end[0] >> 2 & 7));
        assert_eq!(value.len(), length);
        let expected = if crc { checksum(&value) } else { 0 };
        assert_eq!(u16::from_le_bytes([end[1], end[2]]), expected);
        assert_eq!(self.send([0xA1, 0, 0, 0, 0, 0, 0, 0]), None);
        Ok(value)
    }

    fn upload_segments(&mut self, index: u16, sub: u8) -> Outcome<Vec<u8>> {
        let answer = self.ask(request(0x40, index, sub, [0; 4]), 0x40, 0xE0)?;
        if answer[0] & 2 != 0 {
            return Ok(answer[4..8 - usize::from(answer[0] >> 2 & 3)].to_vec());
        }
        assert_eq!(answer[0], 0x41);
        let length = u32::from_le_bytes(answer[4..].try_into().unwrap()) as usize;
        let mut value = Vec::new();
        for at in 0.. {
            let toggle = (at & 1) << 4;
            let answer = self.ask([0x60 | toggle, 0, 0, 0, 0, 0, 0, 0], toggle, 0xF0)?;
            value.extend_from_slice(&answer[1..8 - usize::from(answer[0] >> 1 & 7)]);
            if answer[0] & 1 != 0 {
                break;
            }
        }
        assert_eq!(value.len(), length);
        Ok(value)
    }
}

fn bytes_of(frame: &Frame) -> [u8; 8] {
    assert_eq!(frame.id(), 0x585);
    frame.data().try_into().unwrap()
}

pub(crate) fn request(command: u8, index: u16, sub: u8, data: [u8; 4]) -> [u8; 8] {
    let ([low, high], [a, b, c, d]) = (index.to_le_bytes(), data);
    [command, low, high, sub, a, b, c, d]
}

fn segment(command: u8, part: &[u8]) -> [u8; 8] {
    let mut bytes = [0xEE; 8];
    bytes[0] = command;
    bytes[1..=part.len()].copy_from_slice(part);
    bytes
}

/// The segments of a value: an empty one has one too.
fn parts(value: &[u8]) -> impl Iterator<Item = &[u8]> {
    value.chunks(7).chain(value.is_empty().then_some(&[][..]))
}

fn accept(answer: Option<[u8; 8]>, command: u8, mask: u8) -> Outcome<[u8; 8]> {
    match answer {
        Some(bytes) if bytes[0] == 0x80 => {
            Err(Failure::Abort(u32::from_le_bytes(bytes[4..].try_into().unwrap())))
        }
        Some(bytes) if bytes[0] & mask == command => Ok(bytes),
        other => Err(Failure::Protocol(format!("{other:02X?} for {command:02X}"))),
    }
}

/// CRC-16 with 1021h, bit by bit.
fn checksum(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |crc, &byte| {
        (0..8).fold(
            crc ^ u16::from(byte) << 8,
            |crc: u16, _| if crc & 0x8000 == 0 { crc << 1 } else { crc << 1 ^ 0x1021 },
        )
    })
}
