use super::{
    Abort, BLOCK, BOOLEAN, DOMAIN, HIGH, HIGH_NODE_ID, HOOK, INTEGER8, INTEGER24, INTEGER32, INTEGER40,
    INTEGER64, LOW, LOW_NODE_ID, NODE_ID_DEFAULT, READ, REAL32, REAL64, RPDO, TIME_DIFFERENCE, TIME_OF_DAY,
    TPDO, UNICODE_STRING, WRITE,
};

/// The table of a device: a type without values that the generated file implements this for.
pub trait Table: Copy + core::fmt::Debug + PartialEq + 'static {
    /// All entries in ascending order of index and sub-index.
    const ENTRIES: &'static [Entry<Self>];
    /// Defaults and limits. For a type of at most eight bytes: the default, then the low limit and the high limit
    /// if flagged, each with the size of the type. For any other type: the capacity and the length of the default as
    /// two 16-bit numbers, then the default. All numbers are little-endian.
    const ROM: &'static [u8];
    /// The name of each entry in the description, or empty.
    const NAMES: &'static [&'static str] = &[];
    /// Whether writes are checked against limits.
    const CHECKS_LIMITS: bool = true;
}

/// An entry of the dictionary: a row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Entry<D> {
    index: u16,
    sub: u8,
    data_type: u8,
    /// The flags; the highest six bits extend the offsets beyond 16 bits.
    flags: u16,
    ram: u16,
    rom: u16,
    table: core::marker::PhantomData<fn() -> D>,
}

impl<D: Table> Entry<D> {
    /// The flags and data types that any row has: the compiler leaves out the code for others.
    const USED: (u16, u32) = {
        let (mut flags, mut types, mut entries) = (0, 0, D::ENTRIES);
        while let [entry, rest @ ..] = entries {
            flags |= entry.flags;
            types |= 1 << (entry.data_type & 31);
            entries = rest;
        }
        (flags, types)
    };

    /// Whether it has this flag.
    #[inline(always)]
    const fn has(&self, flag: u16) -> bool {
        Self::USED.0 & flag != 0 && self.flags & flag != 0
    }

    /// Whether any row has one of these data types, given as a bit mask.
    #[inline(always)]
    const fn uses(types: u32) -> bool {
        Self::USED.1 & types != 0
    }

    /// A row: `ram` is the offset of its value in `Data`, 0 for a value in flash, `rom` the offset
    /// of its data in flash. Both have at most 19 bits.
    #[must_use]
    pub const fn new(index: u16, sub: u8, data_type: u8, flags: u16, ram: u32, rom: u32) -> Self {
        let flags = flags | ((ram >> 16) << 10 | (rom >> 16) << 13) as u16;
        let (ram, rom) = (ram as u16, rom as u16);
        Self { index, sub, data_type, flags, ram, rom, table: core::marker::PhantomData }
    }

    /// Finds the entry with an index and a sub-index by binary search.
    ///
    /// # Errors
    /// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
    pub const fn find(index: u16, sub: u8) -> Result<&'static Self, Abort> {
        let key = (index as u32) << 8 | sub as u32;
        let mut entries = D::ENTRIES;
        let mut is_object = false;
        while let Some((below, [entry, above @ ..])) = entries.split_at_checked(entries.len() / 2) {
            let found = entry.key();
            if found == key {
                return Ok(entry);
            }
            // the neighbours of the missing key are both compared with it
            is_object |= entry.index == index;
            entries = if found < key { above } else { below };
        }
        Err(if is_object { Abort::NoSubIndex } else { Abort::NoObject })
    }

    /// The index.
    #[must_use]
    pub const fn index(&self) -> u16 {
        self.index
    }

    /// The sub-index.
    #[must_use]
    pub const fn sub(&self) -> u8 {
        self.sub
    }

    /// The index of the data type, such as 07h for UNSIGNED32; 0 for a device-specific type.
    #[must_use]
    pub const fn data_type(&self) -> u8 {
        self.data_type
    }

    /// Whether it is readable by SDO.
    #[must_use]
    pub const fn is_readable(&self) -> bool {
        self.flags & READ != 0
    }

    /// Whether it is writable by SDO.
    #[must_use]
    pub const fn is_writable(&self) -> bool {
        self.flags & WRITE != 0
    }

    /// Whether it is mappable to TPDOs.
    #[must_use]
    pub const fn fits_tpdo(&self) -> bool {
        self.flags & TPDO != 0
    }

    /// Whether it is mappable to RPDOs.
    #[must_use]
    pub const fn fits_rpdo(&self) -> bool {
        self.flags & RPDO != 0
    }

    /// Whether hooks are called.
    #[must_use]
    pub const fn is_hooked(&self) -> bool {
        self.flags & HOOK != 0
    }

    /// Whether the default is an offset to the node-ID.
    #[must_use]
    pub const fn adds_node_id(&self) -> bool {
        self.has(NODE_ID_DEFAULT)
    }

    /// The name in the description; empty if the table has none.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.row().and_then(|row| D::NAMES.get(row)).copied().unwrap_or("")
    }

    /// The number of its row in the table.
    #[must_use]
    pub fn row(&self) -> Option<usize> {
        D::ENTRIES.binary_search_by_key(&self.key(), Self::key).ok()
    }

    /// Whether its value can change, that is, it is not a constant or a DOMAIN without capacity.
    #[must_use]
    pub const fn is_variable(&self) -> bool {
        self.ram() != 0
    }

    /// Maximum size of a value in an SDO transfer, in bytes.
    #[must_use]
    pub const fn size(&self) -> usize {
        match number_size(self.data_type) {
            0 if Self::uses(NO_NUMBERS) => self.head(0),
            size => size,
        }
    }

    /// The bytes of the default; for a formula, of the offset to the node-ID.
    #[must_use]
    pub const fn default_bytes(&self) -> &'static [u8] {
        match number_size(self.data_type) {
            0 if Self::uses(NO_NUMBERS) => self.stored(4, self.head(2)),
            size => self.stored(0, size),
        }
    }

    /// The default for a node as the bits of the value; 0 if it is not a number.
    #[must_use]
    pub const fn default_number(&self, node_id: u8) -> u64 {
        self.number(0, NODE_ID_DEFAULT, node_id)
    }

    /// The low limit for a node as the bits of the value; `None` without a limit, or if limits are omitted.
    #[must_use]
    pub const fn low_limit(&self, node_id: u8) -> Option<u64> {
        if !D::CHECKS_LIMITS || !self.has(LOW) {
            return None;
        }
        Some(self.number(1, LOW_NODE_ID, node_id))
    }

    /// The high limit for a node, as [`Self::low_limit`].
    #[must_use]
    pub const fn high_limit(&self, node_id: u8) -> Option<u64> {
        if !D::CHECKS_LIMITS || !self.has(HIGH) {
            return None;
        }
        let block = if self.has(LOW) { 2 } else { 1 };
        Some(self.number(block, HIGH_NODE_ID, node_id))
    }

    const fn key(&self) -> u32 {
        (self.index as u32) << 8 | self.sub as u32
    }

    pub(super) const fn is_number(&self) -> bool {
        number_size(self.data_type) != 0
    }

    pub(super) const fn is_block(&self) -> bool {
        self.data_type == BLOCK
    }

    /// Whether its value has a current length, which precedes its bytes.
    pub(super) const fn has_length(&self) -> bool {
        Self::uses(NO_NUMBERS & !(1 << BLOCK)) && !self.is_number() && !self.is_block()
    }

    pub(super) const fn is_time(&self) -> bool {
        Self::uses(1 << TIME_OF_DAY | 1 << TIME_DIFFERENCE)
            && matches!(self.data_type, TIME_OF_DAY | TIME_DIFFERENCE)
    }

    /// Whether the application must transfer its data: a DOMAIN without capacity.
    pub(super) const fn is_elsewhere(&self) -> bool {
        Self::uses(1 << DOMAIN) && self.data_type == DOMAIN && self.size() == 0
    }

    /// The offset of its value; 0 for a value in flash.
    pub(super) const fn ram(&self) -> usize {
        self.ram as usize | (self.flags as usize >> 10 & 7) << 16
    }

    /// Size of its value in RAM, in bytes.
    pub(super) const fn ram_size(&self) -> usize {
        self.size() + if self.has_length() { 2 } else { 0 }
    }

    /// A part of its data in flash.
    const fn stored(&self, skip: usize, length: usize) -> &'static [u8] {
        let rom = self.rom as usize | (self.flags as usize >> 13) << 16;
        part(D::ROM, rom + skip, length)
    }

    /// The default as stored in RAM: strings include their length. A formula needs the node-ID.
    pub(super) const fn initial_bytes(&self) -> &'static [u8] {
        if self.has_length() { self.stored(2, 2 + self.head(2)) } else { self.default_bytes() }
    }

    /// One of the two lengths before a non-numeric default.
    #[inline(never)]
    const fn head(&self, skip: usize) -> usize {
        match self.stored(skip, 2) {
            [low, high] => *low as usize | (*high as usize) << 8,
            _ => 0,
        }
    }

    /// A number in flash, plus the node-ID if the flag is set.
    const fn number(&self, block: usize, flag: u16, node_id: u8) -> u64 {
        let size = number_size(self.data_type);
        let number = number(self.data_type, self.stored(block * size, size));
        if !self.has(flag) { number } else { number.wrapping_add((node_id & 0x7F) as u64) }
    }

    /// Whether a value may be written.
    pub(super) fn check(&self, bytes: &[u8], node_id: u8) -> Result<(), Abort> {
        let (length, size) = (bytes.len(), self.size());
        if length > size {
            Err(Abort::TooLong)
        } else if length < size && !self.has_length() {
            Err(Abort::TooShort)
        } else if Self::uses(1 << UNICODE_STRING) && self.data_type == UNICODE_STRING && length & 1 != 0 {
            Err(Abort::LengthMismatch)
        } else if Self::uses(1 << BOOLEAN) && self.data_type == BOOLEAN && bytes != [0] && bytes != [1] {
            Err(Abort::InvalidValue)
        } else if D::CHECKS_LIMITS && self.has(LOW | HIGH) {
            self.check_limits(number(self.data_type, bytes), node_id)
        } else {
            Ok(())
        }
    }

    fn check_limits(&self, number: u64, node_id: u8) -> Result<(), Abort> {
        let order = |number| order(self.data_type, number);
        let value = order(number).ok_or(Abort::InvalidValue)?;
        let low = self.low_limit(node_id).and_then(order);
        let high = self.high_limit(node_id).and_then(order);
        if low.is_some_and(|low| value < low) {
            Err(Abort::TooLow)
        } else if high.is_some_and(|high| value > high) {
            Err(Abort::TooHigh)
        } else {
            Ok(())
        }
    }
}

/// A part of these bytes; empty beyond their end.
pub(super) const fn part(bytes: &[u8], start: usize, length: usize) -> &[u8] {
    let Some((_, rest)) = bytes.split_at_checked(start) else { return &[] };
    match rest.split_at_checked(length) {
        Some((part, _)) => part,
        None => &[],
    }
}

/// Size of a number of each data type, in bytes; 0 for other types.
const NUMBER_SIZES: [u8; 28] =
    [0, 1, 1, 2, 4, 1, 2, 4, 4, 0, 0, 0, 6, 6, 0, 0, 3, 8, 5, 6, 7, 8, 3, 0, 5, 6, 7, 8];

/// The bit mask of data types that are not numbers.
const NO_NUMBERS: u32 = {
    let (mut types, mut data_type, mut sizes): (u32, u32, &[u8]) =
        (!0 << NUMBER_SIZES.len(), 0, &NUMBER_SIZES);
    while let [size, rest @ ..] = sizes {
        types |= ((*size == 0) as u32) << data_type;
        data_type += 1;
        sizes = rest;
    }
    types
};

// functions with several callers are not inlined, which saves flash
#[inline(never)]
const fn number_size(data_type: u8) -> usize {
    match NUMBER_SIZES.split_at_checked(data_type as usize) {
        Some((_, [size, ..])) => *size as usize,
        _ => 0,
    }
}

const fn is_signed(data_type: u8) -> bool {
    matches!(data_type, INTEGER8..=INTEGER32 | INTEGER24 | INTEGER40..=INTEGER64)
}

/// Converts at most eight bytes to a number, with sign extension.
pub(super) const fn number(data_type: u8, mut bytes: &[u8]) -> u64 {
    let mut number = match bytes {
        [.., last] if *last >= 0x80 && is_signed(data_type) => u64::MAX,
        _ => 0,
    };
    while let [rest @ .., last] = bytes {
        number = number << 8 | *last as u64;
        bytes = rest;
    }
    number
}

/// Converts a value to a number with the same order; `None` for NaN.
#[inline(never)]
fn order(data_type: u8, number: u64) -> Option<u64> {
    const SIGN: u64 = 1 << 63;
    let (real, infinity) = match data_type {
        REAL32 => (number << 32, 0x7F80_0000 << 32),
        REAL64 => (number, 0x7FF0_0000_0000_0000),
        _ if is_signed(data_type) => return Some(number ^ SIGN),
        _ => return Some(number),
    };
    let magnitude = real & !SIGN;
    if magnitude > infinity {
        return None;
    }
    Some(if real & SIGN == 0 { SIGN + magnitude } else { SIGN - magnitude })
}
