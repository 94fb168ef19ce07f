//! SDO transfers that go well, or go on after a loss (CiA 301 §7.2.4).

use objdict_device::Abort;

use super::bench::{Bench, MS};
use super::described::{DescribedEntry, answer, hex, place};
use super::{CheckStep, checks, ensure, impossible};

checks! { "SDO":
    "7.2.4.3" "expedited upload" @Reads |bench| upload(bench, 1..=4, false);
    "7.2.4.3" "segmented upload" @Reads |bench| upload(bench, 5..=LONGEST, false);
    "7.2.4.3" "block upload" @Reads |bench| upload(bench, 1..=LONGEST, true);
    "7.2.4.3" "expedited download" @Writes |bench| download(bench, 1..=4, false);
    "7.2.4.3" "expedited download without a stated length" @Writes without_length;
    "7.2.4.3" "segmented download" @Writes |bench| download(bench, 5..=LONGEST, false);
    "7.2.4.3" "block download" @Writes |bench| download(bench, 1..=LONGEST, true);
    "7.2.4.3" "block download: a lost segment is sent again" lost_segment;
    "7.2.4.3" "block download: the lost end of a sub-block is sent again" lost_end;
    "7.2.4.3" "block upload: lost segments are sent again" lost_upload;
    "7.2.4.3" "block upload: sub-blocks of the size that the client wants" @Reads small_blocks;
    "7.2.4" "the SDO of a different node is ignored" |bench| { let id = 0x600 + u16::from(bench.neighbour()); let sent = bench.send(id, &[0x40, 0, 0x10, 0, 0, 0, 0, 0]); ensure(sent.is_empty(), || "an answer".into()) };
    "7.2.4.3" "a frame of seven bytes is ignored" |bench| { let answered = bench.answer_of(&[0x40, 0, 0x10, 0, 0, 0, 0]); ensure(answered.is_none(), || "an answer".into()) };
    "7.5.2.33" "the COB-IDs in 1200h follow the node-ID" @Reads default_channel;
    "7.5.2.33" "other COB-IDs in 1200h are rejected" @Writes |bench| { let id = 0x6A0; bench.refuse(0x1200, 1, id, Abort::InvalidValue) };
    "7.5.2.33" "a second SDO server, as in 1201h" second_channel;
    "7.5.2.33" "1201h: a restricted CAN-ID is rejected" |bench| { close(bench)?; bench.refuse(0x1201, 1, 0x601, Abort::InvalidValue) };
    "7.5.2.33" "1201h: a new CAN-ID while it is valid is rejected" |bench| { open(bench)?; bench.refuse(0x1201, 1, u64::from(CHANNEL[0] + 1), Abort::InvalidValue) };
}

const LONGEST: usize = 1 << 15;

/// The CAN-IDs that the checks give a second channel.
const CHANNEL: [u16; 2] = [0x6B0, 0x6B1];

fn upload(bench: &mut Bench<'_>, lengths_of: std::ops::RangeInclusive<usize>, in_blocks: bool) -> CheckStep {
    let what = format!("a readable value of {} to {} bytes", lengths_of.start(), lengths_of.end());
    let entry = bench
        .described
        .first(&what, |entry| entry.is_readable() && lengths_of.contains(&entry.default.len()))?;
    let (index, sub, expected) = (entry.index, entry.sub, entry.default.clone());
    let value = if in_blocks { bench.upload_block(index, sub) } else { bench.upload(index, sub) };
    expect_value(&value, &expected, index, sub)
}

fn expect_value(value: &Result<Vec<u8>, Abort>, expected: &[u8], index: u16, sub: u8) -> CheckStep {
    ensure(value.as_deref() == Ok(expected), || {
        let value =
            value.as_ref().map_or_else(|abort| super::described::abort_code(*abort), |value| hex(value));
        format!("{} is {value}, not {}", place(index, sub), hex(expected))
    })
}

/// A value to write, with so many bytes, and its entry.
fn written(bench: &Bench<'_>, lengths: std::ops::RangeInclusive<usize>) -> CheckStep<(u16, u8, Vec<u8>)> {
    let what = format!("a writable value of {} to {} bytes", lengths.start(), lengths.end());
    let value = |entry: &DescribedEntry| {
        entry.other_than(&entry.default).filter(|value| lengths.contains(&value.len()))
    };
    let entry = bench
        .described
        .first(&what, |entry| entry.is_readable() && entry.is_writable() && value(entry).is_some())?;
    Ok((entry.index, entry.sub, value(entry).unwrap_or_default()))
}

fn download(bench: &mut Bench<'_>, lengths: std::ops::RangeInclusive<usize>, in_blocks: bool) -> CheckStep {
    let (index, sub, value) = written(bench, lengths)?;
    let result =
        if in_blocks { bench.download_block(index, sub, &value) } else { bench.download(index, sub, &value) };
    ensure(result.is_ok(), || format!("writing {}: {}", place(index, sub), answer(&result)))?;
    bench.expect(index, sub, &value)
}

fn start(command: u8, index: u16, sub: u8, data: [u8; 4]) -> [u8; 8] {
    let ([low, high], [a, b, c, d]) = (index.to_le_bytes(), data);
    [command, low, high, sub, a, b, c, d]
}

fn expect_answer(answer: Option<[u8; 8]>, expected: &[u8]) -> CheckStep {
    let is_expected = answer.is_some_and(|answer| answer.starts_with(expected));
    ensure(is_expected, || {
        format!(
            "the answer is {}, not {}",
            answer.map_or_else(|| "missing".into(), |bytes| hex(&bytes)),
            hex(expected)
        )
    })
}

fn without_length(bench: &mut Bench<'_>) -> CheckStep {
    let (index, sub, value) = written(bench, 1..=4)?;
    let mut data = [0; 4];
    data[..value.len()].copy_from_slice(&value);
    let answered = bench.request(start(0x22, index, sub, data));
    expect_answer(answered, &[0x60])?;
    bench.expect(index, sub, &value)
}

/// A block download that has begun.
struct BlockDownload {
    index: u16,
    sub: u8,
    value: Vec<u8>,
    segments: Vec<[u8; 8]>,
}

/// Begins a block download of two segments or more.
fn begin_block(bench: &mut Bench<'_>) -> CheckStep<BlockDownload> {
    let (index, sub, value) = written(bench, 8..=LONGEST)?;
    let answered = bench.request(start(0xC2, index, sub, (value.len() as u32).to_le_bytes()));
    expect_answer(answered, &[0xA4])?;
    let count = value.len().div_ceil(7);
    let segments = value.chunks(7).enumerate().map(|(at, bytes)| {
        let mut segment = [0; 8];
        segment[0] = at as u8 + 1;
        segment[1..=bytes.len()].copy_from_slice(bytes);
        if at + 1 == count {
            segment[0] |= 0x80;
        }
        segment
    });
    let segments = segments.collect();
    Ok(BlockDownload { index, sub, segments, value })
}

fn end_block(bench: &mut Bench<'_>, index: u16, sub: u8, value: &[u8]) -> CheckStep {
    let unused = (7 - value.len() % 7) % 7;
    let answered = bench.request([0xC1 | (unused as u8) << 2, 0, 0, 0, 0, 0, 0, 0]);
    expect_answer(answered, &[0xA1])?;
    bench.expect(index, sub, value)
}

/// A segment in another sub-block.
fn renumbered(mut segment: [u8; 8], number: usize) -> [u8; 8] {
    segment[0] = segment[0] & 0x80 | number as u8;
    segment
}

fn lost_segment(bench: &mut Bench<'_>) -> CheckStep {
    let BlockDownload { index, sub, value, segments } = begin_block(bench)?;
    for (at, segment) in segments.iter().enumerate() {
        let is_last = at + 1 == segments.len();
        // the first one is lost
        if at > 0 {
            let answered = bench.request(*segment);
            if is_last {
                expect_answer(answered, &[0xA2, 0])?;
            } else {
                ensure(answered.is_none(), || "an early answer".into())?;
            }
        }
    }
    send_rest(bench, &segments, 0)?;
    end_block(bench, index, sub, &value)
}

/// Sends the segments from one on in a new sub-block.
fn send_rest(bench: &mut Bench<'_>, segments: &[[u8; 8]], from: usize) -> CheckStep {
    for (at, segment) in segments.iter().enumerate().skip(from) {
        let number = at - from + 1;
        let answered = bench.request(renumbered(*segment, number));
        if at + 1 == segments.len() {
            expect_answer(answered, &[0xA2, number as u8])?;
        }
    }
    Ok(())
}

fn lost_end(bench: &mut Bench<'_>) -> CheckStep {
    let BlockDownload { index, sub, value, segments } = begin_block(bench)?;
    bench.request(segments[0]);
    let late = bench.listen(0x580 + bench.node_id(), 400 * MS);
    let is_acknowledged = late.len() == 1 && late[0].1.data().starts_with(&[0xA2, 1]);
    ensure(is_acknowledged, || "what came is not acknowledged".into())?;
    send_rest(bench, &segments, 1)?;
    end_block(bench, index, sub, &value)
}

/// Reads a long value by blocks of some segments, of which the client first has only the one before `lost`.
fn read_block(bench: &mut Bench<'_>, size: u8, lost: Option<u8>) -> CheckStep {
    let entry = bench.described.first("a readable value of more than 14 bytes", |entry| {
        entry.is_readable() && entry.default.len() > 14
    })?;
    let (index, sub, expected) = (entry.index, entry.sub, entry.default.clone());
    if expected.len() > 800 {
        return impossible("the first value of this length is too long for one sub-block");
    }
    let answered = bench.request(start(0xA0, index, sub, [size, 0, 0, 0]));
    let is_accepted = answered.is_some_and(|answer| answer[0] & 0xE1 == 0xC0);
    ensure(is_accepted, || "the block upload does not begin".into())?;
    let (mut value, mut request, mut lost) = (Vec::new(), [0xA3, 0, 0, 0, 0, 0, 0, 0], lost);
    let id = [0x600 + bench.node_id(), 0x580 + bench.node_id()];
    for _ in 0..500 {
        let frames: Vec<_> =
            bench.send(id[0], &request).into_iter().filter(|frame| frame.id() == id[1]).collect();
        if let Some(end) = frames.first().filter(|frame| frame.data()[0] & 0xE3 == 0xC1 && request[0] == 0xA2)
        {
            let unused = usize::from(end.data()[0] >> 2 & 7);
            value.truncate(value.len() - unused.min(value.len()));
            bench.send(id[0], &[0xA1, 0, 0, 0, 0, 0, 0, 0]);
            return expect_value(&Ok(value), &expected, index, sub);
        }
        ensure(!frames.is_empty() && frames.len() <= usize::from(size), || {
            format!("{} segments of {size}", frames.len())
        })?;
        let taken = lost.take().map_or(frames.len(), |lost| usize::from(lost) - 1);
        for frame in frames.iter().take(taken) {
            value.extend(&frame.data()[1..]);
        }
        request = [0xA2, taken as u8, size, 0, 0, 0, 0, 0];
    }
    super::failed("the transfer does not end")
}

fn lost_upload(bench: &mut Bench<'_>) -> CheckStep {
    read_block(bench, 127, Some(2))
}

fn small_blocks(bench: &mut Bench<'_>) -> CheckStep {
    read_block(bench, 2, None)
}

fn default_channel(bench: &mut Bench<'_>) -> CheckStep {
    let node_id = u32::from(bench.node_id());
    bench.described.needs(0x1200, 1)?;
    for (sub, id) in [(1, 0x600), (2, 0x580)] {
        let default = bench.described.number(0x1200, sub);
        if bench.described.needs(0x1200, sub)?.size() == Some(4) && default != u64::from(id + node_id) {
            return impossible(format!("{} has the default {default:X}h", place(0x1200, sub)));
        }
        bench.expect(0x1200, sub, &(id + node_id).to_le_bytes())?;
    }
    Ok(())
}

fn close(bench: &mut Bench<'_>) -> CheckStep {
    for sub in 1..=2 {
        let cob_id = bench.described.number(0x1201, sub) & 0x7FF;
        bench.write(0x1201, sub, 1 << 31 | cob_id)?;
    }
    Ok(())
}

fn open(bench: &mut Bench<'_>) -> CheckStep {
    close(bench)?;
    for (sub, id) in (1..).zip(CHANNEL) {
        bench.write(0x1201, sub, id.into())?;
    }
    Ok(())
}

fn second_channel(bench: &mut Bench<'_>) -> CheckStep {
    open(bench)?;
    let expected = bench.read(0x1000, 0)?;
    let value = bench.upload_by(CHANNEL, 0x1000, 0);
    expect_value(&value, &expected, 0x1000, 0)
}
