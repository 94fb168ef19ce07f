//! A program that is downloaded into a memory (1F50h, 1F51h, 1F56h, 1F57h; CiA 302-3): the first one, for which there is `WithProgram`.

use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashErrorKind, ReadNorFlash};
use objdict_device::{Abort, Dictionary, Region, WithProgram};

use super::bench::Bench;
use super::described::{DescribedEntries, abort_code, hex};
use super::{CheckStep, checks, ensure};

checks! { "programs":
    "CiA 302-3" "1F51h: clear, 1F50h: download, 1F51h: start" |bench| { load(bench, &PROGRAM)?; bench.write(CONTROL, 1, START)?; state_is(bench, 1) };
    "CiA 302-3" "1F51h: stop" |bench| { load(bench, &PROGRAM)?; bench.write(CONTROL, 1, START)?; bench.write(CONTROL, 1, STOP)?; state_is(bench, 0) };
    "CiA 302-3" "1F51h: clear while the program runs is rejected" |bench| { load(bench, &PROGRAM)?; bench.write(CONTROL, 1, START)?; bench.refuse(CONTROL, 1, CLEAR, Abort::DeviceState) };
    "CiA 302-3" "1F51h: start without a program is rejected" |bench| { clear(bench)?; bench.refuse(CONTROL, 1, START, Abort::DeviceState) };
    "CiA 302-3" "1F51h: an unknown command is rejected" |bench| { clear(bench)?; bench.refuse(CONTROL, 1, 0x7F, Abort::InvalidValue) };
    "CiA 302-3" "1F50h: a download before clear is rejected" |bench| { load(bench, &PROGRAM)?; bench.refuse_bytes(DATA, 1, &PROGRAM, Abort::DeviceState) };
    "CiA 302-3" "1F50h: a download in blocks" |bench| { clear(bench)?; ok(bench.download_block(DATA, 1, &PROGRAM))?; bench.write(CONTROL, 1, START) };
    "CiA 302-3" "1F50h: more than the memory holds is rejected" |bench| { clear(bench)?; bench.refuse_bytes(DATA, 1, &[0; ROOM + 1], Abort::OutOfMemory) };
    "CiA 302-3" "1F50h: the program reads as it was downloaded" |bench| { load(bench, &PROGRAM)?; bench.expect(DATA, 1, &PROGRAM) };
    "CiA 302-3" "1F50h: an aborted download leaves no program" give_up;
    "CiA 302-3" "1F56h: a different program, a different number" |bench| { let other = [PROGRAM, [0; LENGTH]].concat(); let first = identified(bench, &PROGRAM)?; let second = identified(bench, &other)?; ensure(first != second, || format!("{first:X}h twice")) };
    "CiA 302-3" "1F57h: start without a program" |bench| { clear(bench)?; bench.refuse(CONTROL, 1, START, Abort::DeviceState)?; status_is(bench, 1) };
    "CiA 302-3" "1F57h: a download before clear, and none after it" |bench| { load(bench, &PROGRAM)?; bench.refuse_bytes(DATA, 1, &PROGRAM, Abort::DeviceState)?; status_is(bench, 4)?; clear(bench)?; status_is(bench, 0) };
}

const DATA: u16 = 0x1F50;
const CONTROL: u16 = 0x1F51;
const STATUS: u16 = 0x1F57;

const STOP: u64 = 0;
const START: u64 = 1;
const CLEAR: u64 = 3;

/// Bytes of the memory and of the program.
const ROOM: usize = 1024;
const LENGTH: usize = 301;
const PROGRAM: [u8; LENGTH] = [0x5A; LENGTH];

/// The memory of the program.
#[derive(Clone, Debug)]
pub(super) struct ProgramMemory([u8; ROOM]);

impl ErrorType for ProgramMemory {
    type Error = NorFlashErrorKind;
}

impl ReadNorFlash for ProgramMemory {
    const READ_SIZE: usize = 1;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Self::Error> {
        let start = offset as usize;
        let from = self.0.get(start..start + bytes.len()).ok_or(NorFlashErrorKind::OutOfBounds)?;
        bytes.copy_from_slice(from);
        Ok(())
    }

    fn capacity(&self) -> usize {
        ROOM
    }
}

impl NorFlash for ProgramMemory {
    const WRITE_SIZE: usize = 8;
    const ERASE_SIZE: usize = ROOM;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), Self::Error> {
        let part = self.0.get_mut(from as usize..to as usize).ok_or(NorFlashErrorKind::OutOfBounds)?;
        part.fill(0xFF);
        Ok(())
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Self::Error> {
        let start = offset as usize;
        let part = self.0.get_mut(start..start + bytes.len()).ok_or(NorFlashErrorKind::OutOfBounds)?;
        part.copy_from_slice(bytes);
        Ok(())
    }
}

/// A dictionary with a memory for a program, and none in it.
#[expect(clippy::expect_used, reason = "the region is the whole memory")]
pub(super) fn with_memory<D: Dictionary>(dictionary: D) -> WithProgram<D, ProgramMemory> {
    let region = Region::new(ProgramMemory([0xFF; ROOM]), 0, ROOM as u32).expect("a region");
    WithProgram::new(dictionary, region, 0)
}

/// Whether the description has what downloads and starts a program.
pub(super) fn is_described(described: &DescribedEntries) -> bool {
    [DATA, CONTROL].into_iter().all(|index| described.needs_writable(index, 1).is_ok())
}

/// What the entries of a memory without a program have: `None` for other entries.
pub(super) fn initial(index: u16, sub: u8) -> Option<Result<u8, Abort>> {
    match (index, sub) {
        (DATA, 1) => Some(Err(Abort::NoData)),
        (CONTROL, 1) => Some(Ok(CLEAR as u8)),
        (0x1F56 | STATUS, 1) => Some(Ok(0)),
        _ => None,
    }
}

fn ok(result: Result<(), Abort>) -> CheckStep {
    result.or_else(|abort| super::failed(abort_code(abort)))
}

fn clear(bench: &mut Bench<'_>) -> CheckStep {
    bench.described.needs_writable(DATA, 1)?;
    bench.write(CONTROL, 1, STOP)?;
    bench.write(CONTROL, 1, CLEAR)?;
    Ok(())
}

fn load(bench: &mut Bench<'_>, program: &[u8]) -> CheckStep {
    clear(bench)?;
    ok(bench.download(DATA, 1, program))
}

/// Checks 1F51h, if it can be read.
fn state_is(bench: &mut Bench<'_>, expected: u8) -> CheckStep {
    let value = bench.read(CONTROL, 1)?;
    ensure(value.first() == Some(&expected), || format!("1F51h sub 1 is {}", hex(&value)))
}

/// Checks the error in 1F57h.
fn status_is(bench: &mut Bench<'_>, error: u64) -> CheckStep {
    let status = bench.number(STATUS, 1)?;
    ensure(status == error << 1, || format!("1F57h sub 1 is {status:X}h"))
}

fn identified(bench: &mut Bench<'_>, program: &[u8]) -> CheckStep<u64> {
    load(bench, program)?;
    bench.number(0x1F56, 1)
}

fn give_up(bench: &mut Bench<'_>) -> CheckStep {
    clear(bench)?;
    bench.request([0x20, 0x50, 0x1F, 1, 0, 0, 0, 0]);
    bench.request([0x00, 1, 2, 3, 4, 5, 6, 7]);
    bench.request([0x80, 0x50, 0x1F, 1, 0, 0, 4, 5]);
    bench.refuse(CONTROL, 1, START, Abort::DeviceState)
}
