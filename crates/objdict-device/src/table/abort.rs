macro_rules! aborts {
    ($($name:ident = $code:literal, $text:literal;)*) => {
        /// Why an SDO transfer is aborted (`CiA` 301, 7.2.4.3.17).
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        pub enum Abort {
            $(#[doc = concat!($text, ".")] $name,)*
            /// A code without a meaning in `CiA` 301.
            Other(u32),
        }

        impl Abort {
            /// The abort code.
            #[must_use]
            pub const fn code(self) -> u32 {
                if let Self::Other(code) = self { code } else { self.known() }
            }

            // only constants, from which the compiler creates a table
            #[inline(never)]
            const fn known(self) -> u32 {
                match self {
                    $(Self::$name => $code,)*
                    Self::Other(_) => 0,
                }
            }

            const fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                    Self::Other(_) => "unknown abort code",
                }
            }
        }

        impl From<u32> for Abort {
            fn from(code: u32) -> Self {
                match code {
                    $($code => Self::$name,)*
                    _ => Self::Other(code),
                }
            }
        }
    };
}

aborts! {
    ToggleBit = 0x0503_0000, "the toggle bit does not alternate";
    Timeout = 0x0504_0000, "the transfer timed out";
    UnknownCommand = 0x0504_0001, "unknown command specifier";
    BlockSize = 0x0504_0002, "invalid block size";
    SequenceNumber = 0x0504_0003, "invalid sequence number";
    Crc = 0x0504_0004, "the CRC does not match";
    OutOfMemory = 0x0504_0005, "the buffer is shorter than the value";
    UnsupportedAccess = 0x0601_0000, "unsupported access";
    WriteOnly = 0x0601_0001, "attempt to read a write-only entry";
    ReadOnly = 0x0601_0002, "attempt to write a read-only entry";
    NoObject = 0x0602_0000, "there is no object with this index";
    NotMappable = 0x0604_0041, "the entry cannot be mapped to the PDO";
    PdoTooLong = 0x0604_0042, "the mapped entries are longer than the PDO";
    Incompatible = 0x0604_0043, "the value contradicts others";
    InternalIncompatible = 0x0604_0047, "the device contradicts itself";
    Hardware = 0x0606_0000, "the hardware failed";
    LengthMismatch = 0x0607_0010, "the number of bytes does not match the data type";
    TooLong = 0x0607_0012, "more bytes than the data type or the capacity";
    TooShort = 0x0607_0013, "fewer bytes than the data type";
    NoSubIndex = 0x0609_0011, "the object has no such sub-index";
    InvalidValue = 0x0609_0030, "not valid for the data type";
    TooHigh = 0x0609_0031, "above the high limit";
    TooLow = 0x0609_0032, "below the low limit";
    MaximumBelowMinimum = 0x0609_0036, "the maximum is below the minimum";
    NoSdoConnection = 0x060A_0023, "no SDO connection is available";
    General = 0x0800_0000, "general error";
    CannotStore = 0x0800_0020, "the application cannot take the data";
    LocalControl = 0x0800_0021, "the device is controlled locally";
    DeviceState = 0x0800_0022, "not in this state of the device";
    NoDictionary = 0x0800_0023, "there is no object dictionary";
    NoData = 0x0800_0024, "no data is available";
}

impl From<Abort> for u32 {
    fn from(abort: Abort) -> Self {
        abort.code()
    }
}

impl core::fmt::Display for Abort {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "SDO abort {:08X}h: {}", self.code(), self.meaning())
    }
}

impl core::error::Error for Abort {}
