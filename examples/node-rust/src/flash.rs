//! Flash in pages of 2 KiB, written in units of 8 bytes. Its contents are in a file, if it has one.

use std::fs;
use std::path::PathBuf;

use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash};

pub struct Flash {
    bytes: Vec<u8>,
    file: Option<PathBuf>,
}

#[derive(Debug)]
pub struct FlashError(NorFlashErrorKind);

impl NorFlashError for FlashError {
    fn kind(&self) -> NorFlashErrorKind {
        self.0
    }
}

impl ErrorType for Flash {
    type Error = FlashError;
}

impl Flash {
    /// With the contents of the file, if there is one of this length.
    pub fn new(length: usize, file: Option<PathBuf>) -> Self {
        let bytes = file.as_ref().and_then(|file| fs::read(file).ok()).filter(|bytes| bytes.len() == length);
        Self { bytes: bytes.unwrap_or_else(|| vec![0xFF; length]), file }
    }

    fn part(&mut self, from: u32, length: usize) -> Result<&mut [u8], FlashError> {
        let part = self.bytes.get_mut(from as usize..from as usize + length);
        part.ok_or(FlashError(NorFlashErrorKind::OutOfBounds))
    }

    fn keep(&self) -> Result<(), FlashError> {
        let kept = self.file.as_ref().map_or(Ok(()), |file| fs::write(file, &self.bytes));
        kept.map_err(|_| FlashError(NorFlashErrorKind::Other))
    }
}

impl ReadNorFlash for Flash {
    const READ_SIZE: usize = 4;

    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), FlashError> {
        bytes.copy_from_slice(self.part(offset, bytes.len())?);
        Ok(())
    }

    fn capacity(&self) -> usize {
        self.bytes.len()
    }
}

impl NorFlash for Flash {
    const WRITE_SIZE: usize = 8;
    const ERASE_SIZE: usize = 2048;

    fn erase(&mut self, from: u32, to: u32) -> Result<(), FlashError> {
        self.part(from, (to - from) as usize)?.fill(0xFF);
        self.keep()
    }

    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), FlashError> {
        self.part(offset, bytes.len())?.copy_from_slice(bytes);
        self.keep()
    }
}
