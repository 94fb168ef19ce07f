//! Storage in the flash memory of drivers that implement the traits of `embedded-storage`.

use embedded_storage::nor_flash::NorFlash;

use crate::{Abort, Storage};

/// Room for the unit in which a flash is written, in bytes.
pub(crate) const UNIT: usize = 64;

/// A part of a flash memory, from an address to another one, which are multiples of its erase size.
#[derive(Clone, Debug)]
pub struct Region<F> {
    /// The driver.
    pub flash: F,
    start: u32,
    end: u32,
}

impl<F: NorFlash> Region<F> {
    /// The part between two addresses; `None` if it is beyond the flash or not a multiple of its erase size, or the flash is written in
    /// units that do not divide 64 bytes.
    pub fn new(flash: F, start: u32, end: u32) -> Option<Self> {
        let is_multiple = |address: u32| (address as usize).is_multiple_of(F::ERASE_SIZE);
        let is_accepted = start <= end
            && end as usize <= flash.capacity()
            && is_multiple(start)
            && is_multiple(end)
            && UNIT.is_multiple_of(F::WRITE_SIZE)
            && UNIT.is_multiple_of(F::READ_SIZE);
        is_accepted.then_some(Self { flash, start, end })
    }

    pub(crate) const fn length(&self) -> u32 {
        self.end - self.start
    }

    /// Writes whole units; the last one is filled up with FFh.
    pub(crate) fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Abort> {
        for (number, part) in bytes.chunks(UNIT).enumerate() {
            let mut unit = [0xFF; UNIT];
            unit.iter_mut().zip(part).for_each(|(place, &byte)| *place = byte);
            let used = part.len().next_multiple_of(F::WRITE_SIZE);
            let unit = unit.get(..used).unwrap_or(&unit);
            self.within(offset + (number * UNIT) as u32, used)?;
            let address = self.start + offset + (number * UNIT) as u32;
            self.flash.write(address, unit).map_err(|_| Abort::Hardware)?;
        }
        Ok(())
    }

    /// Reads bytes, whose units the driver reads whole.
    pub(crate) fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Abort> {
        self.within(offset, bytes.len())?;
        let mut bytes = bytes.iter_mut();
        let mut first = offset - offset % UNIT as u32;
        let mut skipped = (offset - first) as usize;
        while bytes.len() > 0 {
            let mut unit = [0; UNIT];
            let length = (self.length() - first).min(UNIT as u32) as usize;
            let unit = unit.get_mut(..length).unwrap_or_default();
            self.flash.read(self.start + first, unit).map_err(|_| Abort::Hardware)?;
            unit.iter().skip(skipped).zip(bytes.by_ref()).for_each(|(&byte, place)| *place = byte);
            (first, skipped) = (first + UNIT as u32, 0);
        }
        Ok(())
    }

    pub(crate) fn erase(&mut self, offset: u32, length: u32) -> Result<(), Abort> {
        self.within(offset, length as usize)?;
        self.flash.erase(self.start + offset, self.start + offset + length).map_err(|_| Abort::Hardware)
    }

    pub(crate) fn within(&self, offset: u32, length: usize) -> Result<(), Abort> {
        let end = (offset as usize).checked_add(length);
        if end.is_some_and(|end| end <= self.length() as usize) { Ok(()) } else { Err(Abort::OutOfMemory) }
    }
}

/// Storage groups in a flash, each in its own part, which is erased before it is written. If the power fails in between, the group
/// begins with its defaults.
#[derive(Clone, Debug)]
pub struct FlashStorage<F> {
    region: Region<F>,
    /// Bytes for each group.
    part: u32,
}

impl<F: NorFlash> FlashStorage<F> {
    /// Parts of the same size for a number of groups; `None` if there is no room.
    pub fn new(region: Region<F>, groups: usize) -> Option<Self> {
        let units = (region.length() as usize / F::ERASE_SIZE).checked_div(groups)?;
        let part = u32::try_from(units * F::ERASE_SIZE).ok()?;
        (part > 0).then_some(Self { region, part })
    }

    fn offset(&self, group: usize, length: usize) -> Result<u32, Abort> {
        let offset = u32::try_from(group).ok().and_then(|group| group.checked_mul(self.part));
        offset.filter(|_| length <= self.part as usize).ok_or(Abort::OutOfMemory)
    }
}

impl<F: NorFlash> Storage for FlashStorage<F> {
    fn save(&mut self, group: usize, image: &[u8]) -> Result<(), Abort> {
        let offset = self.offset(group, image.len())?;
        self.region.erase(offset, self.part)?;
        self.region.write(offset, image)
    }

    fn load(&mut self, group: usize, image: &mut [u8]) -> Result<(), Abort> {
        let offset = self.offset(group, image.len())?;
        self.region.read(offset, image)
    }

    fn erase(&mut self, group: usize) -> Result<(), Abort> {
        let offset = self.offset(group, 0)?;
        self.region.erase(offset, self.part)
    }
}
