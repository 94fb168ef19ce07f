//! MDF 4 of ASAM, with the channels of its standard for bus logging: `CAN_DataFrame`, `CAN_RemoteFrame` and `CAN_ErrorFrame`.
//!
//! A file consists of blocks that link each other: a data group (DG) has the records of its channel groups (CG), whose channels (CN)
//! are fields of a record. Values of variable length are elsewhere, in a block of the channel or in records of a group of their own.

mod blocks;

use std::collections::BTreeMap;
use std::io::{self, BufRead, Read as _};

use self::blocks::{MdfBlock, MdfFile, number_at};
use super::words::{BAD_ID, fd_length, fits};
use super::{LogState, LogTime, LoggedFrame};

/// The most bytes of a file, which is read whole because its blocks have any order, and of what its records unpack to.
const MAX_FILE: usize = 1 << 28;

/// Where the first block is.
const HEADER: u64 = 64;

const BAD_RECORD: &str = "the record is malformed";
const TOO_LARGE: &str = "the log is larger than 256 MiB; split it";

/// A file; `None` until it is read.
#[derive(Debug, Default)]
pub(super) struct Mdf(Option<Vec<FrameGroup>>);

/// Whether a file begins like this.
pub(super) fn begins(start: &[u8]) -> bool {
    start.starts_with(b"MDF ") || start.starts_with(b"UnFinMF")
}

impl Mdf {
    /// The next frame of all groups by time.
    pub(super) fn next_frame(
        &mut self,
        source: &mut impl BufRead,
        state: &mut LogState,
    ) -> io::Result<Option<LoggedFrame>> {
        let groups = match &mut self.0 {
            Some(groups) => groups,
            groups => groups.insert(read(source, state)?),
        };
        loop {
            let first = groups.iter_mut().filter(|group| group.record().is_some());
            let Some(group) = first.min_by_key(|group| group.time().unwrap_or(i64::MIN)) else {
                return Ok(None);
            };
            state.line += 1;
            let frame = group.frame(state);
            group.advance();
            match frame {
                Ok(frame) => return Ok(Some(frame)),
                Err(reason) => state.bad(reason),
            }
        }
    }
}

fn read(source: &mut impl BufRead, state: &mut LogState) -> io::Result<Vec<FrameGroup>> {
    let mut bytes = Vec::new();
    source.take(MAX_FILE as u64 + 1).read_to_end(&mut bytes)?;
    let file = MdfFile::new(&bytes);
    let mut groups = Vec::new();
    let mut result = if bytes.len() > MAX_FILE { Err(TOO_LARGE) } else { file.add_groups(&mut groups) };
    if file.is_cut.get() && !file.is_unfinished() {
        result = Err("the file ends in a block");
    }
    if let Err(reason) = result {
        state.line += 1;
        state.bad(reason);
    }
    Ok(groups)
}

impl MdfFile<'_> {
    /// Adds the groups with frames, as far as they can be read.
    fn add_groups(&self, groups: &mut Vec<FrameGroup>) -> Result<(), &'static str> {
        if self.bytes.get(8) != Some(&b'4') {
            return Err("only version 4 of MDF is supported; convert the log with its tool");
        }
        let header = self.block(HEADER)?;
        let start = number_at(header.data, 0, 8).cast_signed();
        for data_group in self.list(header.link(0))? {
            let sinks = self.list(data_group.link(1))?.into_iter().map(|group| Sink::of(self, group));
            let mut sinks: Vec<Sink> = sinks.collect::<Result<_, _>>()?;
            if sinks.iter().any(|sink| sink.frames.is_some()) {
                let id_bytes = number_at(data_group.data, 0, 1) as usize;
                self.split(&self.data(data_group.link(2))?, id_bytes, &mut sinks)?;
                self.take(sinks, start, groups)?;
            }
        }
        Ok(())
    }

    /// Gives each record to its group: before it is the number of the group, if there are several.
    fn split(&self, data: &[u8], id_bytes: usize, sinks: &mut [Sink]) -> Result<(), &'static str> {
        if id_bytes == 0 {
            if let [sink, ..] = sinks {
                sink.bytes = data.to_vec();
                self.note_rest(data.len().checked_rem(sink.width));
            }
            return Ok(());
        }
        let numbers: BTreeMap<u64, usize> =
            sinks.iter().enumerate().map(|(at, sink)| (sink.id, at)).collect();
        let mut rest = data;
        while rest.len() >= id_bytes {
            let id = number_at(rest, 0, id_bytes);
            rest = &rest[id_bytes..];
            let sink = &mut sinks[*numbers.get(&id).ok_or("a record is of no channel group")?];
            let width = if sink.has_values { 4 + number_at(rest, 0, 4) as usize } else { sink.width };
            let Some((record, others)) = rest.split_at_checked(width) else { break };
            if sink.has_values || sink.frames.is_some() {
                sink.bytes.extend_from_slice(record);
            }
            rest = others;
        }
        self.note_rest(Some(rest.len()));
        Ok(())
    }

    /// Bytes after the last whole record are the start of another one.
    fn note_rest(&self, bytes: Option<usize>) {
        self.is_cut.set(self.is_cut.get() || bytes.is_some_and(|bytes| bytes > 0));
    }

    /// The groups that have frames, with their records and values.
    fn take(
        &self,
        mut sinks: Vec<Sink>,
        start: i64,
        groups: &mut Vec<FrameGroup>,
    ) -> Result<(), &'static str> {
        for at in 0..sinks.len() {
            let Some(mut group) = sinks[at].frames.take() else { continue };
            group.start = start;
            group.records = std::mem::take(&mut sinks[at].bytes);
            let places = group.fields[DATA].as_ref().map_or(0, |field| field.values);
            group.values = match sinks.iter_mut().find(|sink| sink.address == places) {
                Some(sink) => {
                    group.has_no_places = self.has_no_places();
                    std::mem::take(&mut sink.bytes)
                }
                None => self.data(places)?.into_owned(),
            };
            groups.push(group);
        }
        Ok(())
    }
}

/// A channel group while records are given to it.
struct Sink {
    address: u64,
    id: u64,
    /// The bytes of a record.
    width: usize,
    /// Whether its records are values of variable length.
    has_values: bool,
    frames: Option<FrameGroup>,
    bytes: Vec<u8>,
}

impl Sink {
    fn of(file: &MdfFile<'_>, group: MdfBlock<'_>) -> Result<Self, &'static str> {
        let [data, invalid] = [24, 28].map(|at| number_at(group.data, at, 4) as usize);
        let width = data + invalid;
        let has_values = number_at(group.data, 16, 2) & 1 == 1;
        let mut frames = FrameGroup { width, ..FrameGroup::default() };
        let mut kind = None;
        for channel in file.list(group.link(1))? {
            let parent = file.name(channel.link(2));
            frames.add(file, channel, "", &parent, &mut kind);
            // the fields of a frame are a structure, except where they are an array
            let parts = channel.link(1);
            if parts != 0 && file.block(parts)?.kind == *b"CN" {
                for part in file.list(parts)? {
                    frames.add(file, part, &parent, &file.name(part.link(2)), &mut kind);
                }
            }
        }
        let kind = kind.filter(|_| frames.fields[TIME].is_some() && width > 0 && !has_values);
        let frames = kind.map(|kind| FrameGroup { kind, ..frames });
        let (address, id) = (group.address, number_at(group.data, 0, 8));
        Ok(Self { address, id, width, has_values, frames, bytes: Vec::new() })
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum FrameChannel {
    #[default]
    Data,
    Remote,
    Error,
}

/// The fields of a frame by their names; the time has any name.
const FIELD_NAMES: [&str; 9] =
    ["", "BusChannel", "ID", "IDE", "DataLength", "DLC", "DataBytes", "Dir", "EDL"];
const TIME: usize = 0;
const CHANNEL: usize = 1;
const ID: usize = 2;
const IDE: usize = 3;
const LENGTH: usize = 4;
const DLC: usize = 5;
const DATA: usize = 6;
const DIRECTION: usize = 7;
const FD: usize = 8;

/// A channel group with frames.
#[derive(Debug, Default)]
struct FrameGroup {
    kind: FrameChannel,
    /// When the log starts, in nanoseconds from 1970.
    start: i64,
    width: usize,
    fields: [Option<RecordField>; 9],
    records: Vec<u8>,
    /// Data of variable length, each after its length in four bytes.
    values: Vec<u8>,
    /// Whether the values have the order of the records, which do not say where they are.
    has_no_places: bool,
    /// The number of the next record, and where its value is if the values have their order.
    next: usize,
    next_value: usize,
}

/// Kinds of channels: values of variable length, the time of the group, and numbers that are computed from the number of the record.
const VARIABLE: u8 = 1;
const MASTER: u8 = 2;
const VIRTUAL: u8 = 6;

/// Where a channel is in a record.
#[derive(Debug)]
struct RecordField {
    kind: u8,
    byte: usize,
    bit: u32,
    bits: u32,
    data_type: u8,
    /// What values are multiplied by, and what is added.
    scale: [f64; 2],
    /// The block of values of variable length.
    values: u64,
}

impl FrameGroup {
    /// Adds a channel, if it is a field of a frame.
    fn add(
        &mut self,
        file: &MdfFile<'_>,
        channel: MdfBlock<'_>,
        parent: &str,
        name: &str,
        kind: &mut Option<FrameChannel>,
    ) {
        let (frame, part) = name.rsplit_once('.').unwrap_or((parent, name));
        let is_master = channel.data.first() == Some(&MASTER);
        let number = if is_master {
            Some(TIME)
        } else {
            FIELD_NAMES.iter().skip(1).position(|field| *field == part).map(|at| at + 1)
        };
        let found = match frame.rsplit('.').next() {
            Some("CAN_DataFrame") => Some(FrameChannel::Data),
            Some("CAN_RemoteFrame") => Some(FrameChannel::Remote),
            Some("CAN_ErrorFrame") => Some(FrameChannel::Error),
            _ => None,
        };
        if let Some(number) = number.filter(|_| is_master || found.is_some()) {
            self.fields[number] = Some(RecordField::of(file, channel));
            *kind = kind.or(found);
        }
    }

    fn record(&self) -> Option<&[u8]> {
        self.records.get(self.next.checked_mul(self.width)?..)?.get(..self.width)
    }

    /// Goes to the next record and its value, whether this one is a frame or not.
    fn advance(&mut self) {
        self.next += 1;
        let length = number_at(&self.values, self.next_value, 4) as usize;
        self.next_value = self.next_value.saturating_add(4 + length);
    }

    /// The value of a field as a whole number.
    fn number(&self, field: usize) -> Option<u64> {
        let field = self.fields[field].as_ref()?;
        match field.kind {
            VIRTUAL => Some(field.scaled(self.next as f64) as u64),
            _ => field.number(self.record()?),
        }
    }

    /// Nanoseconds from 1970.
    fn time(&self) -> Option<i64> {
        let field = self.fields[TIME].as_ref()?;
        let number = field.number(self.record()?)?;
        let seconds = match (field.data_type, field.bits) {
            (4 | 5, 64) => field.scaled(f64::from_bits(number)),
            (4 | 5, _) => field.scaled(f32::from_bits(number as u32).into()),
            _ => field.scaled(number as f64),
        };
        let nanoseconds = seconds * 1e9;
        (nanoseconds.abs() < 9e18).then_some(nanoseconds.round() as i64)?.checked_add(self.start)
    }

    fn frame(&self, state: &mut LogState) -> Result<LoggedFrame, &'static str> {
        let time = LogTime::new(self.time().ok_or("the time is out of range")?, 9);
        let channel = self.number(CHANNEL).map(|number| number.to_string()).unwrap_or_default();
        let channel = state.channels.number(channel.as_bytes());
        if self.kind == FrameChannel::Error {
            return Ok(LoggedFrame { is_error: true, ..LoggedFrame::new(time, channel, 0, false) });
        }
        let id = self.number(ID).ok_or(BAD_RECORD)?;
        let is_extended = self.number(IDE).map_or(id >> 31 & 1 == 1, |number| number != 0);
        let can_id = (id & 0x1FFF_FFFF) as u32;
        if !fits(can_id, is_extended) {
            return Err(BAD_ID);
        }
        let is_sent = self.number(DIRECTION).map(|number| number != 0);
        let is_remote = self.kind == FrameChannel::Remote;
        let is_fd = self.number(FD).is_some_and(|number| number != 0);
        let frame =
            LoggedFrame { is_sent, is_remote, is_fd, ..LoggedFrame::new(time, channel, can_id, is_extended) };
        Ok(if is_remote { frame } else { frame.with_data(self.data(is_fd)?) })
    }

    /// The bytes of the data; lengths in four bits are codes, which a conversion explains.
    fn length(&self, is_fd: bool) -> Option<u32> {
        let [length, code] = [LENGTH, DLC].map(|field| self.number(field)?.try_into().ok());
        let is_code = self.fields[LENGTH].as_ref().is_some_and(|field| field.bits <= 4);
        let code = code.or(length).map(|code| if is_fd { fd_length(code) } else { code.min(8) });
        if is_code { code } else { length.or(code) }
    }

    /// The data of the frame.
    fn data(&self, is_fd: bool) -> Result<&[u8], &'static str> {
        let length = self.length(is_fd).map_or(usize::MAX, |length| length as usize);
        let field = self.fields[DATA].as_ref().ok_or(BAD_RECORD)?;
        let data = if field.kind == VARIABLE {
            let place = self.number(DATA).and_then(|place| usize::try_from(place).ok()).ok_or(BAD_RECORD)?;
            let place = if self.has_no_places { self.next_value } else { place };
            let value = self.values.get(place..).filter(|value| value.len() >= 4).ok_or(BAD_RECORD)?;
            let end = 4 + number_at(value, 0, 4) as usize;
            value.get(4..end).ok_or(BAD_RECORD)?
        } else {
            let record = self.record().and_then(|record| record.get(field.byte..)).ok_or(BAD_RECORD)?;
            &record[..record.len().min(field.bits as usize / 8)]
        };
        let data = &data[..data.len().min(length)];
        if data.len() > 64 { Err(BAD_RECORD) } else { Ok(data) }
    }
}

impl RecordField {
    fn of(file: &MdfFile<'_>, channel: MdfBlock<'_>) -> Self {
        let [kind, _, data_type, bit] = [0, 1, 2, 3].map(|at| number_at(channel.data, at, 1) as u8);
        let [byte, bits] = [4, 8].map(|at| number_at(channel.data, at, 4) as u32);
        let conversion = file.block(channel.link(4)).ok().filter(|block| block.data.first() == Some(&1));
        let scale = conversion
            .map_or([1.0, 0.0], |block| [32, 24].map(|at| f64::from_bits(number_at(block.data, at, 8))));
        let values = if kind == VARIABLE { channel.link(5) } else { 0 };
        Self { kind, byte: byte as usize, bit: bit.into(), bits, data_type, scale, values }
    }

    fn scaled(&self, value: f64) -> f64 {
        value * self.scale[0] + self.scale[1]
    }

    /// The bits of a field of at most 64 bits.
    fn number(&self, record: &[u8]) -> Option<u64> {
        let count = (self.bit + self.bits.min(64)).div_ceil(8) as usize;
        let bytes = record.get(self.byte..)?.get(..count)?;
        let step = |number: u128, byte: &u8| number << 8 | u128::from(*byte);
        let is_big_endian = matches!(self.data_type, 1 | 3 | 5);
        let number =
            if is_big_endian { bytes.iter().fold(0, step) } else { bytes.iter().rev().fold(0, step) };
        let mask = (1_u128 << self.bits.min(64)) - 1;
        Some((number.checked_shr(self.bit)? & mask) as u64)
    }
}

#[cfg(test)]
mod tests;
