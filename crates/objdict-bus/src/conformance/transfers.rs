//! What an SDO server refuses: requests as frames, and the answers to them (CiA 301 §7.2.4.3.17).

use objdict_device::Abort;

use super::bench::{Bench, MS};
use super::described::{abort_code, hex};
use super::{CheckRun, CheckStep, ServiceCheck, failed, impossible};

/// The entry that a request is about.
#[derive(Clone, Copy)]
pub(super) enum RequestTarget {
    /// An index without an object.
    NoObject,
    /// A sub-index that an object does not have.
    NoSub,
    ReadOnly,
    WriteOnly,
    Readable,
    /// More than four bytes.
    Segmented,
    /// A number.
    Writable,
    /// A number of two bytes.
    Word,
}
use RequestTarget::{NoObject, NoSub, ReadOnly, Readable, Segmented, Word, Writable, WriteOnly};

/// What the client does, and what the node answers.
pub(super) enum ClientExchange {
    /// A request with the entry: first byte, last four bytes.
    Start(u8, [u8; 4], ServerAnswer),
    /// A request without the entry.
    Go([u8; 8], ServerAnswer),
    /// Nothing for so many milliseconds.
    Wait(u64, ServerAnswer),
}
use ClientExchange::{Go, Start, Wait};

pub(super) enum ServerAnswer {
    Abort(Abort),
    /// An answer with this command: the first three bits.
    Command(u8),
    /// The start of a block download with a CRC, which a server need not have.
    WithCrc,
    Nothing,
}
use ServerAnswer::Nothing;

const fn abort(abort: Abort) -> ServerAnswer {
    ServerAnswer::Abort(abort)
}

const UPLOAD: u8 = 0x40;
const EXPEDITED: u8 = 0x22;
const DOWNLOAD: u8 = 0x20;
const DOWNLOAD_OF_LENGTH: u8 = 0x21;
const BLOCK_DOWNLOAD: u8 = 0xC4;
const BLOCK_DOWNLOAD_OF_LENGTH: u8 = 0xC6;
const BLOCK_UPLOAD: u8 = 0xA4;
const FOUR: [u8; 4] = [4, 0, 0, 0];
const BLOCK: [u8; 4] = [127, 0, 0, 0];
const HUGE: [u8; 4] = [0, 0, 1, 0];

const UPLOADS: ServerAnswer = ServerAnswer::Command(0x40);
const TAKES: ServerAnswer = ServerAnswer::Command(0x60);
const TAKES_SEGMENT: ServerAnswer = ServerAnswer::Command(0x20);
const TAKES_BLOCK: ServerAnswer = ServerAnswer::Command(0xA0);
const GIVES_BLOCK: ServerAnswer = ServerAnswer::Command(0xC0);

/// A request of one byte.
const fn only(command: u8, answer: ServerAnswer) -> ClientExchange {
    Go([command, 0, 0, 0, 0, 0, 0, 0], answer)
}

/// The rows: name, what it needs on a real bus if it can be made there and CiA 301 decides the answer, entry, and what is sent in order.
macro_rules! refusals {
    ($($name:literal $(@$remote:ident)? $target:ident [$($exchange:expr),*];)*) => {
        pub(super) const CHECKS: &[ServiceCheck] = &[$(ServiceCheck {
            service: "SDO aborts",
            name: $name,
            section: "7.2.4.3.17",
            remote: &[$(super::CheckEffect::$remote)?],
            run: CheckRun::Frames($target, &[$($exchange),*]),
        }),*];
    };
}

refusals! {
    "0602 0000h: upload without an object" @Reads NoObject [Start(UPLOAD, [0; 4], abort(Abort::NoObject))];
    "0602 0000h: download without an object" @Reads NoObject [Start(EXPEDITED, [0; 4], abort(Abort::NoObject))];
    "0602 0000h: block upload without an object" @Reads NoObject [Start(BLOCK_UPLOAD, BLOCK, abort(Abort::NoObject))];
    "0602 0000h: block download without an object" @Reads NoObject [Start(BLOCK_DOWNLOAD, [0; 4], abort(Abort::NoObject))];
    "0609 0011h: upload without a sub-index" @Reads NoSub [Start(UPLOAD, [0; 4], abort(Abort::NoSubIndex))];
    "0609 0011h: download without a sub-index" @Reads NoSub [Start(EXPEDITED, [0; 4], abort(Abort::NoSubIndex))];
    "0601 0001h: upload of what is write-only" @Reads WriteOnly [Start(UPLOAD, [0; 4], abort(Abort::WriteOnly))];
    "0601 0001h: block upload of what is write-only" @Reads WriteOnly [Start(BLOCK_UPLOAD, BLOCK, abort(Abort::WriteOnly))];
    "0601 0002h: expedited download to what is read-only" @Writes ReadOnly [Start(EXPEDITED, [0; 4], abort(Abort::ReadOnly))];
    "0601 0002h: segmented download to what is read-only" @Writes ReadOnly [Start(DOWNLOAD_OF_LENGTH, FOUR, abort(Abort::ReadOnly))];
    "0601 0002h: block download to what is read-only" @Writes ReadOnly [Start(BLOCK_DOWNLOAD_OF_LENGTH, FOUR, abort(Abort::ReadOnly))];
    "0503 0000h: a toggle bit in an upload" @Reads Segmented [Start(UPLOAD, [0; 4], UPLOADS), only(0x70, abort(Abort::ToggleBit))];
    "0503 0000h: a toggle bit in a download" @Writes Writable [Start(DOWNLOAD, [0; 4], TAKES), only(0x1F, abort(Abort::ToggleBit))];
    "0504 0000h: an upload that the client leaves" Segmented [Start(UPLOAD, [0; 4], UPLOADS), Wait(499, Nothing), Wait(2, abort(Abort::Timeout))];
    "0504 0000h: a download that the client leaves" Writable [Start(DOWNLOAD, [0; 4], TAKES), Wait(499, Nothing), Wait(2, abort(Abort::Timeout))];
    "0504 0000h: a block upload that the client leaves" Readable [Start(BLOCK_UPLOAD, BLOCK, GIVES_BLOCK), Wait(501, abort(Abort::Timeout))];
    "0504 0001h: an unknown command" @Reads Readable [Start(0xE0, [0; 4], abort(Abort::UnknownCommand))];
    "0504 0001h: a segment without a download" @Reads Readable [only(0x00, abort(Abort::UnknownCommand))];
    "0504 0001h: the request of a segment without an upload" @Reads Readable [only(0x60, abort(Abort::UnknownCommand))];
    "0504 0001h: the start of a block upload without a request" @Reads Readable [only(0xA3, abort(Abort::UnknownCommand))];
    "0504 0001h: an acknowledgement without a block upload" @Reads Readable [Go([0xA2, 1, 127, 0, 0, 0, 0, 0], abort(Abort::UnknownCommand))];
    "0504 0001h: the end of a block download without a download" @Reads Readable [only(0xC1, abort(Abort::UnknownCommand))];
    "0504 0002h: a block size of 0" @Reads Readable [Start(BLOCK_UPLOAD, [0; 4], abort(Abort::BlockSize))];
    "0504 0002h: a block size of 128" @Reads Readable [Start(BLOCK_UPLOAD, [128, 0, 0, 0], abort(Abort::BlockSize))];
    "0504 0003h: the segment 0 in a block download" Writable [Start(BLOCK_DOWNLOAD, [0; 4], TAKES_BLOCK), only(0x00, abort(Abort::SequenceNumber))];
    "0504 0003h: the acknowledgement of a segment that was not sent" @Reads Readable [Start(BLOCK_UPLOAD, BLOCK, GIVES_BLOCK), Go([0xA3, 0, 0, 0, 0, 0, 0, 0], ServerAnswer::Command(0x80)), Go([0xA2, 127, 127, 0, 0, 0, 0, 0], abort(Abort::SequenceNumber))];
    "0504 0004h: a wrong CRC in a block download" @Writes Word [Start(BLOCK_DOWNLOAD, [0; 4], ServerAnswer::WithCrc), Go([0x81, 1, 2, 0, 0, 0, 0, 0], TAKES_BLOCK), Go([0xD5, 0, 0, 0, 0, 0, 0, 0], abort(Abort::Crc))];
    "0607 0012h: a stated length beyond the entry's" @Writes Writable [Start(DOWNLOAD_OF_LENGTH, HUGE, abort(Abort::TooLong))];
    "0607 0012h: a block download with a length beyond the entry's" @Writes Writable [Start(BLOCK_DOWNLOAD_OF_LENGTH, HUGE, abort(Abort::TooLong))];
    "0607 0012h: more bytes than stated" @Writes Word [Start(DOWNLOAD_OF_LENGTH, [2, 0, 0, 0], TAKES), only(0x00, abort(Abort::TooLong))];
    "0607 0013h: fewer bytes than stated" @Writes Word [Start(DOWNLOAD_OF_LENGTH, [2, 0, 0, 0], TAKES), only(0x0D, abort(Abort::TooShort))];
    "0607 0013h: a download of one byte to a longer entry" @Writes Word [Start(0x2F, [0; 4], abort(Abort::TooShort))];
    "an abort of the client ends an upload" @Reads Segmented [Start(UPLOAD, [0; 4], UPLOADS), Start(0x80, [0, 0, 4, 5], Nothing), only(0x60, abort(Abort::UnknownCommand))];
    "an abort of the client ends a download" @Writes Writable [Start(DOWNLOAD, [0; 4], TAKES), Start(0x80, [0, 0, 4, 5], Nothing), only(0x0D, abort(Abort::UnknownCommand))];
    "an abort of the client ends a block download" @Writes Writable [Start(BLOCK_DOWNLOAD, [0; 4], TAKES_BLOCK), Start(0x80, [0, 0, 4, 5], Nothing), only(0xC1, abort(Abort::UnknownCommand))];
    "an abort without a transfer is not answered" @Reads Readable [Start(0x80, [0, 0, 4, 5], Nothing)];
    "a new request replaces a transfer" Segmented [Start(UPLOAD, [0; 4], UPLOADS), only(0x60, ServerAnswer::Command(0)), Start(UPLOAD, [0; 4], UPLOADS), only(0x60, ServerAnswer::Command(0))];
    "a new download replaces a download" Writable [Start(DOWNLOAD, [0; 4], TAKES), only(0x0C, TAKES_SEGMENT), Start(DOWNLOAD, [0; 4], TAKES), only(0x1D, abort(Abort::ToggleBit))];
}

/// Runs the requests of a row.
pub(super) fn run(bench: &mut Bench<'_>, target: RequestTarget, exchanges: &[ClientExchange]) -> CheckStep {
    let (index, sub) = entry(bench, target)?;
    let [low, high] = index.to_le_bytes();
    for exchange in exchanges {
        let (request, answered, expected) = match exchange {
            Start(command, [a, b, c, d], expected) => {
                let request = [*command, low, high, sub, *a, *b, *c, *d];
                (hex(&request), bench.request(request), expected)
            }
            Go(request, expected) => (hex(request), bench.request(*request), expected),
            Wait(time, expected) => {
                let id = 0x580 + bench.node_id();
                let sent = bench.listen(id, time * MS);
                let answer = sent.last().and_then(|(_, frame)| frame.data().try_into().ok());
                (format!("{time} ms"), answer, expected)
            }
        };
        if let (Some([0xA0, ..]), ServerAnswer::WithCrc) = (answered, expected) {
            return impossible("the server makes no CRC");
        }
        if !is_expected(answered, expected) {
            let answered = answered.map_or_else(|| "nothing".to_owned(), |bytes| hex(&bytes));
            return failed(format!("after {request}: {answered}, not {}", words(expected)));
        }
    }
    Ok(())
}

fn is_expected(answered: Option<[u8; 8]>, expected: &ServerAnswer) -> bool {
    match (answered, expected) {
        (None, Nothing) => true,
        (Some([0x80, _, _, _, code @ ..]), ServerAnswer::Abort(abort)) => {
            u32::from_le_bytes(code) == abort.code()
        }
        (Some([command, ..]), ServerAnswer::Command(expected)) => command & 0xE0 == *expected,
        (Some([command, ..]), ServerAnswer::WithCrc) => command == 0xA4,
        _ => false,
    }
}

fn words(expected: &ServerAnswer) -> String {
    match expected {
        Nothing => "nothing".to_owned(),
        ServerAnswer::Abort(abort) => format!("the abort {}", abort_code(*abort)),
        ServerAnswer::Command(command) => format!("the command {command:02X}"),
        ServerAnswer::WithCrc => "the command A4".to_owned(),
    }
}

fn entry(bench: &Bench<'_>, target: RequestTarget) -> CheckStep<(u16, u8)> {
    let described = bench.described;
    let found = match target {
        NoObject => return Ok((described.unused(), 0)),
        NoSub => {
            let object = described.entries.iter().find(|entry| described.find(entry.index, 0xFD).is_none());
            return object.map_or_else(|| super::absent("an object"), |entry| Ok((entry.index, 0xFD)));
        }
        ReadOnly => described.first("a read-only entry", |entry| !entry.is_writable()),
        WriteOnly => described.first("a write-only entry", |entry| !entry.is_readable()),
        Readable => described.first("a readable entry", |entry| {
            entry.is_readable() && (1..800).contains(&entry.default.len())
        }),
        Segmented => described.first("a readable value of more than four bytes", |entry| {
            entry.is_readable() && entry.default.len() > 4
        }),
        Writable => described.first("a writable number", |entry| entry.is_writable() && entry.is_integer()),
        Word => described.first("a writable number of two bytes", |entry| {
            entry.is_writable() && entry.is_integer() && entry.size() == Some(2)
        }),
    };
    found.map(|entry| (entry.index, entry.sub))
}
