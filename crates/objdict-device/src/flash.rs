//! Storage in the flash memory of drivers that implement the traits of `embedded-storage`.

use embedded_storage::nor_flash::NorFlash;

use crate::{Abort, Storage, crc};

/// The maximum write unit of a flash, in bytes.
pub(crate) const UNIT: usize = 64;

/// An address range of a flash memory; both addresses are multiples of the erase size.
#[derive(Clone, Debug)]
pub struct Region<F> {
    /// The driver.
    pub flash: F,
    start: u32,
    end: u32,
}

impl<F: NorFlash> Region<F> {
    /// The range between two addresses; `None` if it exceeds the flash or is not a multiple of its erase size, or the
    /// flash's write unit does not divide 64 bytes.
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

    /// Writes whole units; the last one is padded with FFh.
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

    /// Reads bytes; the driver reads whole units.
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

/// Storage groups in a flash, each in two banks that are written in turn: the last image remains valid until the next
/// one is written, so a power failure at any time does not lose stored values. Each image erases one bank, so only
/// every second image wears out the same bank.
#[derive(Clone, Debug)]
pub struct FlashStorage<F> {
    region: Region<F>,
    /// Bytes of a bank.
    bank: u32,
}

/// The trailer after the image in a bank: number of the image, its length and a CRC of everything,
/// little-endian.
const HEADER: usize = 10;

/// The last image of a group.
#[derive(Clone, Copy)]
struct KeptImage {
    /// The start of its bank.
    offset: u32,
    number: u32,
    /// 0 if the group was erased.
    length: usize,
}

impl<F: NorFlash> FlashStorage<F> {
    /// Creates two banks of the same size for each group; `None` if there is not enough space.
    pub fn new(region: Region<F>, groups: usize) -> Option<Self> {
        let units = (region.length() as usize / F::ERASE_SIZE).checked_div(groups.checked_mul(2)?)?;
        let bank = u32::try_from(units * F::ERASE_SIZE).ok()?;
        (bank as usize > UNIT).then_some(Self { region, bank })
    }

    /// The part of the flash, with its driver.
    pub fn into_region(self) -> Region<F> {
        self.region
    }

    /// The starts of a group's banks.
    fn banks(&self, group: usize) -> Result<[u32; 2], Abort> {
        let first = u32::try_from(group).ok().and_then(|group| group.checked_mul(2 * self.bank));
        let first = first.ok_or(Abort::OutOfMemory)?;
        self.region.within(first, 2 * self.bank as usize)?;
        Ok([first, first + self.bank])
    }

    /// The image in a bank, if it is whole.
    fn kept(&mut self, offset: u32) -> Result<Option<KeptImage>, Abort> {
        let mut header = [0; HEADER];
        self.region.read(offset, &mut header)?;
        let [a, b, c, d, e, f, g, h, check @ ..] = header;
        let (number, length) = (u32::from_le_bytes([a, b, c, d]), u32::from_le_bytes([e, f, g, h]) as usize);
        if length > self.bank as usize - UNIT {
            return Ok(None);
        }
        let mut found = crc(0, &[a, b, c, d, e, f, g, h]);
        let mut unit = [0; UNIT];
        for start in (0..length).step_by(UNIT) {
            let unit = unit.get_mut(..UNIT.min(length - start)).unwrap_or_default();
            self.region.read(offset + (UNIT + start) as u32, unit)?;
            found = crc(found, unit);
        }
        Ok((found == u16::from_le_bytes(check)).then_some(KeptImage { offset, number, length }))
    }

    /// The last image of a group.
    fn last(&mut self, group: usize) -> Result<Option<KeptImage>, Abort> {
        let [first, second] = self.banks(group)?;
        Ok(match (self.kept(first)?, self.kept(second)?) {
            // numbers begin again after the highest one
            (Some(one), Some(other)) if one.number.wrapping_sub(other.number) as i32 > 0 => Some(one),
            (one, other) => other.or(one),
        })
    }

    /// Whether a group has never been written.
    fn is_blank(&mut self, group: usize) -> Result<bool, Abort> {
        let mut headers = [0; 2 * HEADER];
        for (offset, header) in self.banks(group)?.into_iter().zip(headers.chunks_exact_mut(HEADER)) {
            self.region.read(offset, header)?;
        }
        Ok(headers == [0xFF; 2 * HEADER])
    }
}

impl<F: NorFlash> Storage for FlashStorage<F> {
    fn save(&mut self, group: usize, image: &[u8]) -> Result<(), Abort> {
        if image.len() > self.bank as usize - UNIT {
            return Err(Abort::OutOfMemory);
        }
        let ([first, second], last) = (self.banks(group)?, self.last(group)?);
        let offset = if last.is_some_and(|last| last.offset == first) { second } else { first };
        let number = last.map_or(0, |last| last.number.wrapping_add(1)).to_le_bytes();
        let length = (image.len() as u32).to_le_bytes();
        let check = crc(crc(crc(0, &number), &length), image).to_le_bytes();
        self.region.erase(offset, self.bank)?;
        self.region.write(offset + UNIT as u32, image)?;
        let mut header = [0; HEADER];
        header.iter_mut().zip(number.iter().chain(&length).chain(&check)).for_each(|(to, from)| *to = *from);
        self.region.write(offset, &header)
    }

    fn load(&mut self, group: usize, image: &mut [u8]) -> Result<(), Abort> {
        image.fill(0xFF);
        match self.last(group)? {
            Some(kept) => {
                let length = kept.length.min(image.len());
                let image = image.get_mut(..length).unwrap_or_default();
                self.region.read(kept.offset + UNIT as u32, image)
            }
            None if self.is_blank(group)? => Ok(()),
            None => Err(Abort::NoData),
        }
    }

    fn erase(&mut self, group: usize) -> Result<(), Abort> {
        self.save(group, &[])
    }
}
