//! pcap and pcapng with frames of SocketCAN (link type 227).

use std::borrow::Cow;
use std::io::{self, BufRead, ErrorKind, Read as _};

use super::words::fits;
use super::{LogForm, LogState, LogTime, LoggedFrame};

/// The link type of SocketCAN.
const SOCKETCAN: u32 = 227;

/// The most bytes of a packet or block that are kept; frames and descriptions of interfaces are shorter.
const MAX_BLOCK: usize = 1 << 16;

/// The most interfaces.
const MAX_INTERFACES: usize = 256;

const TOO_SHORT: &str = "the packet is too short for a frame";
const BAD_BLOCK: &str = "the block is malformed";

/// A file of packets.
#[derive(Debug)]
pub(super) struct Capture {
    form: LogForm,
    is_big_endian: bool,
    interfaces: Vec<Interface>,
    block: Vec<u8>,
    is_started: bool,
    is_over: bool,
}

/// Where packets come from.
#[derive(Clone, Debug)]
struct Interface {
    link_type: u32,
    channel: u16,
    /// Units of times in a second.
    resolution: u64,
    decimals: u8,
    /// Seconds to add.
    offset: i64,
}

impl Capture {
    /// The file that begins with these bytes.
    pub(super) fn of(start: &[u8]) -> Option<Self> {
        let (form, is_big_endian) = match start.first_chunk::<4>()? {
            [0x0A, 0x0D, 0x0D, 0x0A] => (LogForm::Pcapng, false),
            [0xD4, 0xC3, 0xB2, 0xA1] | [0x4D, 0x3C, 0xB2, 0xA1] => (LogForm::Pcap, false),
            [0xA1, 0xB2, 0xC3, 0xD4] | [0xA1, 0xB2, 0x3C, 0x4D] => (LogForm::Pcap, true),
            _ => return None,
        };
        let (interfaces, block) = Default::default();
        Some(Self { form, is_big_endian, interfaces, block, is_started: false, is_over: false })
    }

    pub(super) const fn form(&self) -> LogForm {
        self.form
    }

    pub(super) fn next_frame(
        &mut self,
        source: &mut impl BufRead,
        state: &mut LogState,
    ) -> io::Result<Option<LoggedFrame>> {
        while !self.is_over {
            let next = match self.form {
                LogForm::Pcap => self.packet(source, state),
                _ => self.next_block(source, state),
            };
            match next {
                Ok(Some(frame)) => return Ok(Some(frame)),
                Ok(None) => {}
                Err(error) if error.kind() == ErrorKind::UnexpectedEof => {
                    self.is_over = true;
                    // a capture that is cut off in a packet
                    if !self.block.is_empty() {
                        state.line += 1;
                        state.bad("the file ends in a packet");
                    }
                }
                Err(error) => return Err(error),
            }
        }
        Ok(None)
    }

    fn u16_at(&self, at: usize) -> u16 {
        let bytes = self.block.get(at..at + 2).map_or([0; 2], |bytes| [bytes[0], bytes[1]]);
        if self.is_big_endian { u16::from_be_bytes(bytes) } else { u16::from_le_bytes(bytes) }
    }

    fn u32_at(&self, at: usize) -> u32 {
        let bytes =
            self.block.get(at..at + 4).map_or([0; 4], |bytes| [bytes[0], bytes[1], bytes[2], bytes[3]]);
        if self.is_big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) }
    }

    /// A packet of pcap: seconds, fraction, length here, length on the bus.
    fn packet(&mut self, source: &mut impl BufRead, state: &mut LogState) -> io::Result<Option<LoggedFrame>> {
        self.block.clear();
        if !self.is_started {
            fill(&mut self.block, source, 24, MAX_BLOCK)?;
            let is_nano = self.block[..4].contains(&0x3C);
            let decimals = if is_nano { 9 } else { 6 };
            let link_type = self.u32_at(20) & 0xFFFF;
            self.interfaces = vec![Interface {
                link_type,
                channel: state.channels.number(b""),
                resolution: 10_u64.pow(decimals.into()),
                decimals,
                offset: 0,
            }];
            self.is_started = true;
            self.block.clear();
        }
        fill(&mut self.block, source, 16, MAX_BLOCK)?;
        let (seconds, fraction, length) = (self.u32_at(0), self.u32_at(4), self.u32_at(8));
        fill(&mut self.block, source, length as usize, MAX_BLOCK)?;
        state.line += 1;
        let interface = &self.interfaces[0];
        let units = u64::from(seconds) * interface.resolution + u64::from(fraction);
        Ok(frame(interface, units, self.block.get(16..).unwrap_or_default(), state))
    }

    /// A block of pcapng: type, length, content, length.
    fn next_block(
        &mut self,
        source: &mut impl BufRead,
        state: &mut LogState,
    ) -> io::Result<Option<LoggedFrame>> {
        self.block.clear();
        fill(&mut self.block, source, 8, MAX_BLOCK)?;
        let is_section = self.block.starts_with(&[0x0A, 0x0D, 0x0D, 0x0A]);
        if is_section {
            fill(&mut self.block, source, 4, MAX_BLOCK)?;
            self.is_big_endian = self.block[8..] == [0x1A, 0x2B, 0x3C, 0x4D];
            self.interfaces.clear();
        }
        state.line += 1;
        let length = self.u32_at(4) as usize;
        let Some(rest) =
            length.checked_sub(self.block.len()).filter(|_| length.is_multiple_of(4) && length >= 12)
        else {
            state.bad(BAD_BLOCK);
            self.is_over = true;
            return Ok(None);
        };
        fill(&mut self.block, source, rest, MAX_BLOCK)?;
        match self.u32_at(0) {
            1 => self.interface(state),
            // enhanced, and the obsolete one
            kind @ (2 | 6) => {
                let interface = if kind == 6 { self.u32_at(8) } else { self.u16_at(8).into() };
                let units = u64::from(self.u32_at(12)) << 32 | u64::from(self.u32_at(16));
                return Ok(self.of_interface(interface, units, 28, self.u32_at(20), state));
            }
            // simple packets have no time
            3 => return Ok(self.of_interface(0, 0, 12, self.u32_at(8), state)),
            _ => {}
        }
        Ok(None)
    }

    fn of_interface(
        &self,
        interface: u32,
        units: u64,
        start: usize,
        length: u32,
        state: &mut LogState,
    ) -> Option<LoggedFrame> {
        let end = start.saturating_add(length as usize).min(self.block.len().saturating_sub(4));
        match (self.interfaces.get(interface as usize), self.block.get(start..end)) {
            (Some(interface), Some(bytes)) => frame(interface, units, bytes, state),
            _ => {
                state.bad(BAD_BLOCK);
                None
            }
        }
    }

    /// The description of an interface with its options: name, resolution and offset of times.
    fn interface(&mut self, state: &mut LogState) {
        if self.interfaces.len() >= MAX_INTERFACES {
            return state.bad("there are too many interfaces");
        }
        let (mut name, mut resolution, mut offset) = (Vec::new(), 6_u8, 0);
        let mut at = 16;
        while at + 4 <= self.block.len().saturating_sub(4) {
            let (code, length) = (self.u16_at(at), usize::from(self.u16_at(at + 2)));
            let content = self.block.get(at + 4..at + 4 + length).unwrap_or_default();
            match (code, content) {
                (0, _) => break,
                (2, _) => name = content.to_vec(),
                (9, &[value]) => resolution = value,
                (14, content) => {
                    let bytes = content.try_into().unwrap_or_default();
                    offset = if self.is_big_endian {
                        i64::from_be_bytes(bytes)
                    } else {
                        i64::from_le_bytes(bytes)
                    };
                }
                _ => {}
            }
            at += 4 + length.next_multiple_of(4);
        }
        let exponent = u32::from(resolution & 0x7F);
        let is_binary = resolution & 0x80 != 0;
        let units = if is_binary { 2_u64.checked_pow(exponent) } else { 10_u64.checked_pow(exponent) };
        self.interfaces.push(Interface {
            link_type: self.u16_at(8).into(),
            channel: state.channels.number(&name),
            resolution: units.unwrap_or(1),
            decimals: if is_binary { 9 } else { exponent.min(9) as u8 },
            offset,
        });
    }
}

/// Reads so many bytes behind those of the block; keeps at most `most` of them.
pub(super) fn fill(
    block: &mut Vec<u8>,
    source: &mut impl BufRead,
    count: usize,
    most: usize,
) -> io::Result<()> {
    let kept = count.min(most) as u64;
    let rest = count as u64 - kept;
    // memory grows with the data that are read, not with the stated length
    let read = source.by_ref().take(kept).read_to_end(block)? as u64;
    match io::copy(&mut source.take(rest), &mut io::sink())? {
        skipped if read < kept || skipped < rest => Err(ErrorKind::UnexpectedEof.into()),
        _ => Ok(()),
    }
}

/// The frame in a packet: CAN-ID and flags in the order of the network, length, flags, two unused bytes, data.
fn frame(interface: &Interface, units: u64, packet: &[u8], state: &mut LogState) -> Option<LoggedFrame> {
    let mut bad = |reason: Cow<'static, str>| {
        state.bad(reason);
        None
    };
    if interface.link_type != SOCKETCAN {
        return bad(other_link_type(interface.link_type).into());
    }
    let &[a, b, c, d, length, flags, _, _, ref data @ ..] = packet else { return bad(TOO_SHORT.into()) };
    let Some(time) = interface.time(units) else { return bad("the time is out of range".into()) };
    let id = u32::from_be_bytes([a, b, c, d]);
    let [is_extended, is_remote, is_error] = [31, 30, 29].map(|bit| id >> bit & 1 == 1);
    let can_id = id & 0x1FFF_FFFF;
    let data = match usize::from(length) {
        _ if is_remote => &[],
        length if length <= 64 && length <= data.len() => &data[..length],
        _ => return bad(TOO_SHORT.into()),
    };
    if !is_error && !fits(can_id, is_extended) {
        return bad(super::words::BAD_ID.into());
    }
    let frame = LoggedFrame::new(time, interface.channel, can_id, is_extended && !is_error).with_data(data);
    Some(LoggedFrame { is_remote, is_error, is_fd: data.len() > 8 || flags & 4 != 0, ..frame })
}

/// What packets of another link type are said to be.
fn other_link_type(link_type: u32) -> String {
    let name = match link_type {
        1 => "Ethernet, ",
        113 | 276 => "Linux, captured on any interface, ",
        190 => "CAN 2.0b, ",
        _ => "",
    };
    format!("the packet is of {name}link type {link_type}, not of SocketCAN (link type 227)")
}

impl Interface {
    fn time(&self, units: u64) -> Option<LogTime> {
        let nanoseconds = u128::from(units) * 1_000_000_000 / u128::from(self.resolution.max(1));
        let offset = self.offset.checked_mul(1_000_000_000)?;
        let nanoseconds = i64::try_from(nanoseconds).ok()?.checked_add(offset)?;
        Some(LogTime::new(nanoseconds, self.decimals))
    }
}
