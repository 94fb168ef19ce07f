//! A program that is downloaded into flash (CiA 302-3).

use embedded_storage::nor_flash::NorFlash;

use crate::dictionary::forward;
use crate::flash::UNIT;
use crate::sdo::crc::crc;
use crate::{Abort, Attributes, Dictionary, ObjectSet, Place, Region, Scope};

/// Program data, control, software identification and flash status (CiA 302-3); sub-index 1 is the program.
const DATA: u16 = 0x1F50;
const CONTROL: u16 = 0x1F51;
const IDENTIFICATION: u16 = 0x1F56;
const STATUS: u16 = 0x1F57;

/// Errors in 1F57h, from bit 1 on.
const NO_PROGRAM: u8 = 1;
const NOT_CLEARED: u8 = 4;
const WRITE_ERROR: u8 = 5;

/// The content of the program memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ProgramState {
    /// The program runs.
    Running,
    /// The program does not run and may be cleared.
    Stopped,
    /// There is no program; the memory is erased.
    Cleared,
    /// A part of a program: its download has not ended.
    Partial,
}

/// A request of a master for the program (1F51h).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ProgramRequest {
    /// Stop it.
    Stop,
    /// Start it.
    Start,
    /// Start it again.
    Reset,
}

/// A dictionary whose 1F50h downloads a program of any length into a flash, and whose 1F51h, 1F56h and 1F57h control it
/// (CiA 302-3): the program is stopped, cleared, downloaded and started.
#[derive(Clone, Debug)]
pub struct WithProgram<V, F> {
    /// The values.
    pub data: V,
    region: Region<F>,
    state: ProgramState,
    /// Bytes of the program.
    length: u32,
    /// The CRC-16 of CiA 301 of these bytes.
    crc: u16,
    error: u8,
    /// Bytes that wait for a whole unit.
    unit: [u8; UNIT],
    request: Option<ProgramRequest>,
}

impl<V: Dictionary, F: NorFlash> WithProgram<V, F> {
    /// Creates a dictionary with a running program of `length` bytes at the start of a region; 0 for none.
    pub fn new(data: V, mut region: Region<F>, length: u32) -> Self {
        let length = length.min(region.length());
        let mut sum = 0;
        let is_read = (0..length).step_by(UNIT).all(|at| {
            let mut unit = [0; UNIT];
            let used = (length - at).min(UNIT as u32) as usize;
            let unit = unit.get_mut(..used).unwrap_or_default();
            let answer = region.read(at, unit);
            sum = crc(sum, unit);
            answer.is_ok()
        });
        let has_program = is_read && length > 0;
        let state = if has_program { ProgramState::Running } else { ProgramState::Partial };
        let length = if has_program { length } else { 0 };
        Self { data, region, state, length, crc: sum, error: 0, unit: [0; UNIT], request: None }
    }

    /// The content of the memory.
    pub const fn state(&self) -> ProgramState {
        self.state
    }

    /// The memory.
    pub const fn region(&self) -> &Region<F> {
        &self.region
    }

    /// Bytes of the program.
    pub const fn length(&self) -> u32 {
        self.length
    }

    /// The master's request since the last call.
    pub const fn take_request(&mut self) -> Option<ProgramRequest> {
        self.request.take()
    }

    fn control(&mut self, command: u8) -> Result<(), Abort> {
        let has_program = matches!(self.state, ProgramState::Running | ProgramState::Stopped);
        let (state, request) = match command {
            // there is nothing to stop
            0 if !has_program => return Ok(()),
            0 => (ProgramState::Stopped, ProgramRequest::Stop),
            1 | 2 if !has_program => return self.fail(NO_PROGRAM, Abort::DeviceState),
            1 => (ProgramState::Running, ProgramRequest::Start),
            2 => (ProgramState::Running, ProgramRequest::Reset),
            3 if self.state == ProgramState::Running => return Err(Abort::DeviceState),
            3 => return self.clear(),
            _ => return Err(Abort::InvalidValue),
        };
        (self.state, self.request) = (state, Some(request));
        self.error = 0;
        Ok(())
    }

    fn clear(&mut self) -> Result<(), Abort> {
        (self.state, self.length, self.crc) = (ProgramState::Partial, 0, 0);
        if let Err(abort) = self.region.erase(0, self.region.length()) {
            return self.fail(WRITE_ERROR, abort);
        }
        (self.state, self.error) = (ProgramState::Cleared, 0);
        Ok(())
    }

    fn fail<T>(&mut self, error: u8, abort: Abort) -> Result<T, Abort> {
        self.error = error;
        Err(abort)
    }

    /// Appends bytes of a download, and writes each complete unit.
    fn append(&mut self, bytes: &[u8]) -> Result<(), Abort> {
        for &byte in bytes {
            self.region.within(self.length, 1)?;
            let filled = self.length as usize % UNIT;
            if let Some(place) = self.unit.get_mut(filled) {
                *place = byte;
            }
            self.length += 1;
            if filled + 1 == UNIT {
                let unit = self.unit;
                self.region.write(self.length - UNIT as u32, &unit)?;
            }
        }
        self.crc = crc(self.crc, bytes);
        Ok(())
    }

    fn number_of(&self, index: u16) -> Option<u32> {
        let control = match self.state {
            ProgramState::Running => 1,
            ProgramState::Stopped => 0,
            ProgramState::Cleared | ProgramState::Partial => 3,
        };
        match index {
            CONTROL => Some(control),
            IDENTIFICATION => Some(u32::from(self.crc)),
            STATUS => Some(u32::from(self.error) << 1),
            _ => None,
        }
    }
}

impl<V: Dictionary, F: NorFlash> Dictionary for WithProgram<V, F> {
    forward! { data:
        fn serves_more(self: &Self) -> bool;
        fn own_node_id(self: &Self) -> Option<u8>;
        fn objects(self: &Self) -> ObjectSet;
        fn replace(self: &mut Self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort>;
        fn locate(self: &Self, index: u16, sub: u8) -> Result<Place, Abort>;
        fn attributes_at(self: &Self, place: Place) -> Result<Attributes, Abort>;
        fn number_at(self: &mut Self, place: Place) -> Result<u64, Abort>;
        fn write_at(self: &mut Self, place: Place, bytes: &[u8]) -> Result<(), Abort>;
        fn restart(self: &mut Self, scope: Scope, node_id: u8);
        fn can_store(self: &Self, sub: u8) -> bool;
        fn store(self: &mut Self, sub: u8) -> Result<(), Abort>;
        fn restore(self: &mut Self, sub: u8) -> Result<(), Abort>;
    }

    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        self.data.attributes(index, sub)
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let entry = self.data.attributes(index, sub)?;
        let Some(number) = self.number_of(index).filter(|_| sub == 1 && entry.readable) else {
            return self.data.read(index, sub, buffer);
        };
        let size = entry.size.min(4);
        let room = buffer.get_mut(..size).ok_or(Abort::OutOfMemory)?;
        room.iter_mut().zip(number.to_le_bytes()).for_each(|(place, byte)| *place = byte);
        Ok(size)
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let entry = self.data.attributes(index, sub)?;
        match (index, sub, bytes) {
            // some devices have more than one byte
            (CONTROL, 1, [command, rest @ ..]) if entry.writable && bytes.len() == entry.size => {
                let is_known = rest.iter().all(|&byte| byte == 0);
                if is_known { self.control(*command) } else { Err(Abort::InvalidValue) }
            }
            _ => self.data.write(index, sub, bytes),
        }
    }

    fn begin_read(&mut self, index: u16, sub: u8) -> Result<Option<usize>, Abort> {
        match (index, sub, self.state) {
            (DATA, 1, _) if !self.data.attributes(index, sub)?.readable => Err(Abort::WriteOnly),
            (DATA, 1, ProgramState::Running | ProgramState::Stopped) => Ok(Some(self.length as usize)),
            (DATA, 1, _) => Err(Abort::NoData),
            _ => self.data.begin_read(index, sub),
        }
    }

    fn read_piece(&mut self, index: u16, sub: u8, offset: usize, piece: &mut [u8]) -> Result<(), Abort> {
        match (index, sub) {
            (DATA, 1) => self.region.read(offset as u32, piece),
            _ => self.data.read_piece(index, sub, offset, piece),
        }
    }

    fn begin_write(&mut self, index: u16, sub: u8, length: Option<usize>) -> Result<bool, Abort> {
        match (index, sub) {
            (DATA, 1) if self.state != ProgramState::Cleared => self.fail(NOT_CLEARED, Abort::DeviceState),
            (DATA, 1) => {
                self.region.within(0, length.unwrap_or(0))?;
                (self.state, self.length, self.crc) = (ProgramState::Partial, 0, 0);
                Ok(true)
            }
            (CONTROL, 1) => Ok(false),
            _ => self.data.begin_write(index, sub, length),
        }
    }

    fn write_piece(&mut self, index: u16, sub: u8, offset: usize, piece: &[u8]) -> Result<(), Abort> {
        match (index, sub) {
            (DATA, 1) => self.append(piece).or_else(|abort| self.fail(WRITE_ERROR, abort)),
            _ => self.data.write_piece(index, sub, offset, piece),
        }
    }

    fn end_write(&mut self, index: u16, sub: u8, length: usize) -> Result<(), Abort> {
        if (index, sub) != (DATA, 1) {
            return self.data.end_write(index, sub, length);
        }
        let rest = self.length % UNIT as u32;
        let unit = self.unit;
        let unit = unit.get(..rest as usize).unwrap_or(&unit);
        self.region.write(self.length - rest, unit).or_else(|abort| self.fail(WRITE_ERROR, abort))?;
        (self.state, self.error) = (ProgramState::Stopped, 0);
        Ok(())
    }
}
