/// Why an SDO transfer is aborted (`CiA` 301).
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]{{ derives("") }}
#[repr(u32)]
pub enum Abort {
    /// The buffer is shorter than the value.
    OutOfMemory = 0x0504_0005,
    /// Attempt to read a write-only entry.
    WriteOnly = 0x0601_0001,
    /// Attempt to write a read-only entry.
    ReadOnly = 0x0601_0002,
    /// There is no object with this index.
    NoObject = 0x0602_0000,
    /// The number of bytes does not match the data type.
    LengthMismatch = 0x0607_0010,
    /// More bytes than the data type or the capacity.
    TooLong = 0x0607_0012,
    /// Fewer bytes than the data type.
    TooShort = 0x0607_0013,
    /// The object has no such sub-index.
    NoSubIndex = 0x0609_0011,
    /// Not valid for the data type.
    InvalidValue = 0x0609_0030,
    /// Above the high limit.
    TooHigh = 0x0609_0031,
    /// Below the low limit.
    TooLow = 0x0609_0032,
    /// No capacity for the data; the application must store them.
    CannotStore = 0x0800_0020,
    /// No data in the table; the application must provide them.
    NoData = 0x0800_0024,
{%- if hooks %}
    /// For hooks: the value contradicts others.
    Incompatible = 0x0604_0043,
    /// For hooks: the hardware failed.
    Hardware = 0x0606_0000,
    /// For hooks: any other error.
    General = 0x0800_0000,
    /// For hooks: the device is controlled locally.
    LocalControl = 0x0800_0021,
    /// For hooks: not in this state of the device.
    DeviceState = 0x0800_0022,
{%- endif %}
}

#[allow(dead_code, unreachable_pub)]
impl Abort {
    /// The abort code.
    #[must_use]
    pub const fn code(self) -> u32 {
        self as u32
    }
}

impl core::fmt::Display for Abort {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "SDO abort {:08X}h", self.code())
    }
}

/// Text or bytes of varying length, at most `N`.
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Octets<const N: usize> {
    length: u16,
    bytes: [u8; N],
}

#[allow(dead_code, unreachable_pub)]
impl<const N: usize> Octets<N> {
    /// The first `N` of these bytes.
    #[must_use]
    pub const fn new(bytes: &[u8]) -> Self {
        let mut octets = Self {
            length: 0,
            bytes: [0; N],
        };
        while (octets.length as usize) < N && (octets.length as usize) < bytes.len() {
            octets.bytes[octets.length as usize] = bytes[octets.length as usize];
            octets.length += 1;
        }
        octets
    }

    /// The bytes.
    #[must_use]
    pub fn as_slice(&self) -> &[u8] {
        let length = usize::from(self.length);
        self.bytes.get(..length).unwrap_or(&self.bytes)
    }

    /// Replaces the bytes.
    ///
    /// # Errors
    /// [`Abort::TooLong`] for more than `N` bytes.
    pub fn set(&mut self, bytes: &[u8]) -> Result<(), Abort> {
        if bytes.len() > N {
            return Err(Abort::TooLong);
        }
        *self = Self::new(bytes);
        Ok(())
    }
}

/// A time of day since 1984-01-01, or a time difference.
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]{{ derives("") }}
pub struct Time {
    /// Milliseconds after midnight, 28 bits.
    pub milliseconds: u32,
    /// Days.
    pub days: u16,
}

impl Time {
    /// The used bits of the first four bytes.
    const USED: u32 = 0x0FFF_FFFF;
}

/// A value transferred by an SDO.
#[allow(dead_code)]
enum Value<'a> {
    /// Little-endian.
    Number([u8; 8]),
    Bytes(&'a [u8]),
}

/// Common operations of the fields of `Data`.
#[allow(dead_code)]
trait Field {
    fn load(&self) -> Value<'_>;
    fn store(&mut self, value: Value<'_>);
}

macro_rules! number_fields {
    ($($number:ty)*) => {
        $(impl Field for $number {
            fn load(&self) -> Value<'_> {
                let bytes = self.to_le_bytes();
                let mut number = [0; 8];
                number[..bytes.len()].copy_from_slice(&bytes);
                Value::Number(number)
            }

            fn store(&mut self, value: Value<'_>) {
                let mut bytes = self.to_le_bytes();
                if let Value::Number(number) = value {
                    bytes.copy_from_slice(&number[..core::mem::size_of::<Self>()]);
                }
                *self = Self::from_le_bytes(bytes);
            }
        })*
    };
}

number_fields!(i8 i16 i32 i64 u8 u16 u32 u64 f32 f64);

impl Field for bool {
    fn load(&self) -> Value<'_> {
        Value::Number([u8::from(*self), 0, 0, 0, 0, 0, 0, 0])
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Number([byte, ..]) = value {
            *self = byte != 0;
        }
    }
}

impl Field for Time {
    fn load(&self) -> Value<'_> {
        let mut number = [0; 8];
        number[..4].copy_from_slice(&(self.milliseconds & Self::USED).to_le_bytes());
        number[4..6].copy_from_slice(&self.days.to_le_bytes());
        Value::Number(number)
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Number([low, second, third, high, days @ .., _, _]) = value {
            self.milliseconds = u32::from_le_bytes([low, second, third, high]) & Self::USED;
            self.days = u16::from_le_bytes(days);
        }
    }
}

impl<const N: usize> Field for Octets<N> {
    fn load(&self) -> Value<'_> {
        Value::Bytes(self.as_slice())
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Bytes(bytes) = value {
            *self = Self::new(bytes);
        }
    }
}

impl<const N: usize> Field for [u8; N] {
    fn load(&self) -> Value<'_> {
        Value::Bytes(self)
    }

    fn store(&mut self, value: Value<'_>) {
        if let Value::Bytes(bytes) = value {
            *self = Octets::new(bytes).bytes;
        }
    }
}
