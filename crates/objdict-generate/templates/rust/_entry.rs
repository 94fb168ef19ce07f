/// A location in RAM (0: none, the value is in flash) or in [`ROM`].
type Offset = {{ offset }};

/// An entry of the dictionary.
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    index: u16,
    sub: u8,
    data_type: u8,
    flags: u16,
    ram: Offset,
    rom: Offset,
}

#[allow(dead_code, unreachable_pub)]
impl Entry {
    const fn row(address: (u16, u8), data_type: u8, flags: u16, ram: Offset, rom: Offset) -> Self {
        let (index, sub) = address;
        Self {
            index,
            sub,
            data_type,
            flags,
            ram,
            rom,
        }
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
{%- if hooks %}

    /// Whether [`Hooks`] are called.
    #[must_use]
    pub const fn is_hooked(&self) -> bool {
        self.flags & HOOK != 0
    }
{%- endif %}

    /// Whether the default is an offset to the node-ID.
    #[must_use]
    pub const fn adds_node_id(&self) -> bool {
        self.flags & NODE_ID_DEFAULT != 0
    }

    /// Maximum size of a value in an SDO transfer, in bytes.
    #[must_use]
    pub fn size(&self) -> usize {
        match number_size(self.data_type) {
            0 => self.head(0),
            size => size,
        }
    }

    /// The bytes of the default; for a formula, of the offset to the node-ID.
    #[must_use]
    pub fn default_bytes(&self) -> &'static [u8] {
        match number_size(self.data_type) {
            0 => self.bytes(4, self.head(2)),
            size => self.bytes(0, size),
        }
    }

    {% if gates -%}
    #[cfg(feature = "od-limits")]
    {% endif -%}
    /// The low limit for a node as `u64` with the bits of the value.
    #[must_use]
    pub fn low_limit(&self, node_id: u8) -> Option<u64> {
        (self.flags & LOW != 0).then(|| self.number(1, LOW_NODE_ID, node_id))
    }

    {% if gates -%}
    #[cfg(feature = "od-limits")]
    {% endif -%}
    /// The high limit for a node as `u64` with the bits of the value.
    #[must_use]
    pub fn high_limit(&self, node_id: u8) -> Option<u64> {
        let block = 1 + usize::from(self.flags & LOW != 0);
        (self.flags & HIGH != 0).then(|| self.number(block, HIGH_NODE_ID, node_id))
    }

    const fn key(&self) -> u32 {
        key(self.index, self.sub)
    }

    const fn is_number(&self) -> bool {
        number_size(self.data_type) != 0
    }

    /// The data of this entry in flash.
    fn bytes(&self, skip: usize, length: usize) -> &'static [u8] {
        let start = self.rom as usize + skip;
        ROM.get(start..start + length).unwrap_or(&[])
    }

    /// One of the two lengths before a non-numeric default.
    fn head(&self, skip: usize) -> usize {
        match self.bytes(skip, 2) {
            [low, high] => usize::from(*low) | (usize::from(*high) << 8),
            _ => 0,
        }
    }

    /// Reads a number from flash and adds the node-ID if the flag is set.
    fn number(&self, block: usize, flag: u16, node_id: u8) -> u64 {
        let size = self.size();
        let number = number(self.data_type, self.bytes(block * size, size));
        if self.flags & flag == 0 {
            return number;
        }
        number.wrapping_add(u64::from(node_id & 0x7F))
    }

    /// The value of an entry without a field.
    fn in_flash(&self, node_id: u8) -> Result<Value<'static>, Abort> {
        if self.is_number() {
            let number = self.number(0, NODE_ID_DEFAULT, node_id);
            return Ok(Value::Number(number.to_le_bytes()));
        }
        if self.data_type == DOMAIN && self.size() == 0 {
            return Err(Abort::NoData);
        }
        Ok(Value::Bytes(self.default_bytes()))
    }

    fn check_length(&self, length: usize) -> Result<(), Abort> {
        let exact = self.is_number() || self.data_type == BLOCK;
        if length > self.size() {
            Err(Abort::TooLong)
        } else if exact && length < self.size() {
            Err(Abort::TooShort)
        } else if self.data_type == UNICODE_STRING && length & 1 != 0 {
            Err(Abort::LengthMismatch)
        } else {
            Ok(())
        }
    }

    fn check_value(&self, number: u64, node_id: u8) -> Result<(), Abort> {
        if self.data_type == BOOLEAN && number > 1 {
            return Err(Abort::InvalidValue);
        }
        self.check_limits(number, node_id)
    }
{%- if gates %}

    #[cfg(not(feature = "od-limits"))]
    #[allow(clippy::unused_self, clippy::unnecessary_wraps)]
    fn check_limits(&self, _: u64, _: u8) -> Result<(), Abort> {
        Ok(())
    }

    #[cfg(feature = "od-limits")]
{%- else %}
{% endif %}
    fn check_limits(&self, number: u64, node_id: u8) -> Result<(), Abort> {
        if self.flags & (LOW | HIGH) == 0 {
            return Ok(());
        }
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

/// Finds the entry with an index and a sub-index by binary search.
///
/// # Errors
/// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
#[allow(dead_code, unreachable_pub)]
pub fn find(index: u16, sub: u8) -> Result<&'static Entry, Abort> {
    match ENTRIES.binary_search_by_key(&key(index, sub), Entry::key) {
        Ok(row) => ENTRIES.get(row).ok_or(Abort::NoObject),
        Err(row) => {
            let mut neighbours = ENTRIES.iter().skip(row.saturating_sub(1)).take(2);
            if neighbours.any(|entry| entry.index == index) {
                Err(Abort::NoSubIndex)
            } else {
                Err(Abort::NoObject)
            }
        }
    }
}

const fn key(index: u16, sub: u8) -> u32 {
    ((index as u32) << 8) | sub as u32
}

/// Size of a number of this data type, in bytes; 0 for other types.
const fn number_size(data_type: u8) -> usize {
    match data_type {
        BOOLEAN | INTEGER8 | UNSIGNED8 => 1,
        INTEGER16 | UNSIGNED16 => 2,
        INTEGER24 | UNSIGNED24 => 3,
        INTEGER32 | UNSIGNED32 | REAL32 => 4,
        INTEGER40 | UNSIGNED40 => 5,
        INTEGER48 | UNSIGNED48 | TIME_OF_DAY | TIME_DIFFERENCE => 6,
        INTEGER56 | UNSIGNED56 => 7,
        INTEGER64 | UNSIGNED64 | REAL64 => 8,
        _ => 0,
    }
}

const fn is_signed(data_type: u8) -> bool {
    matches!(data_type, INTEGER8..=INTEGER32 | INTEGER24 | INTEGER40..=INTEGER64)
}

/// Converts at most eight bytes to a number, with sign extension.
fn number(data_type: u8, bytes: &[u8]) -> u64 {
    let negative = is_signed(data_type) && bytes.last().is_some_and(|&last| last >= 0x80);
    let start = if negative { u64::MAX } else { 0 };
    let shift = |number: u64, &byte: &u8| (number << 8) | u64::from(byte);
    bytes.iter().rev().fold(start, shift)
}

{% if gates -%}
#[cfg(feature = "od-limits")]
{% endif -%}
/// Converts a value to a number with the same order; `None` for NaN.
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
    if real & SIGN == 0 {
        Some(SIGN + magnitude)
    } else {
        Some(SIGN - magnitude)
    }
}

const READ: u16 = 0x001;
const WRITE: u16 = 0x002;
const TPDO: u16 = 0x004;
const RPDO: u16 = 0x008;{% if gates %}
#[allow(dead_code)]{% endif %}
const LOW: u16 = 0x010;{% if gates %}
#[allow(dead_code)]{% endif %}
const HIGH: u16 = 0x020;
const NODE_ID_DEFAULT: u16 = 0x040;{% if gates %}
#[allow(dead_code)]{% endif %}
const LOW_NODE_ID: u16 = 0x080;{% if gates %}
#[allow(dead_code)]{% endif %}
const HIGH_NODE_ID: u16 = 0x100;
{%- if hooks %}
const HOOK: u16 = 0x200;
{%- endif %}

const BLOCK: u8 = 0x00;
const BOOLEAN: u8 = 0x01;
const INTEGER8: u8 = 0x02;
const INTEGER16: u8 = 0x03;
const INTEGER32: u8 = 0x04;
const UNSIGNED8: u8 = 0x05;
const UNSIGNED16: u8 = 0x06;
const UNSIGNED32: u8 = 0x07;
const REAL32: u8 = 0x08;
#[allow(dead_code)]
const VISIBLE_STRING: u8 = 0x09;
#[allow(dead_code)]
const OCTET_STRING: u8 = 0x0A;
const UNICODE_STRING: u8 = 0x0B;
const TIME_OF_DAY: u8 = 0x0C;
const TIME_DIFFERENCE: u8 = 0x0D;
const DOMAIN: u8 = 0x0F;
const INTEGER24: u8 = 0x10;
const REAL64: u8 = 0x11;
const INTEGER40: u8 = 0x12;
const INTEGER48: u8 = 0x13;
const INTEGER56: u8 = 0x14;
const INTEGER64: u8 = 0x15;
const UNSIGNED24: u8 = 0x16;
const UNSIGNED40: u8 = 0x18;
const UNSIGNED48: u8 = 0x19;
const UNSIGNED56: u8 = 0x1A;
const UNSIGNED64: u8 = 0x1B;
