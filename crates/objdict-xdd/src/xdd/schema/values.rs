//! The kinds of values of attributes and texts.

/// The kind of a text.
#[derive(Clone, Copy, Debug)]
pub(crate) enum TextKind {
    /// Any text.
    Text,
    /// `true`, `false`, `1` or `0`.
    Boolean,
    /// A whole number in decimal, from the first to the second.
    Number(i128, i128),
    /// A number with or without a fraction. The standard declares a string.
    Decimal,
    /// Hex digits: the minimum and maximum number.
    Hex(usize, usize),
    /// `yyyy-mm-dd`, with or without a time zone.
    Date,
    /// `hh:mm:ss`, with or without a fraction and a time zone.
    Time,
    /// One of these words.
    Word(&'static [&'static str]),
    /// Some of these words, separated by blanks.
    Words(&'static [&'static str]),
    /// A bit rate of the list.
    BaudRate,
    /// A bit rate in any spelling.
    Rate,
    /// `Dummy0001=0` to `Dummy0007=1`.
    Dummy,
    /// An id that is unique in the file.
    Id,
    /// The id of another element.
    Reference(ReferenceTarget),
    /// An XML name.
    Name,
    /// A language such as `en` or `de-at`.
    Language,
    /// Languages, separated by blanks.
    Languages,
    /// Names, separated by blanks.
    Names,
}

/// The possible target of a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ReferenceTarget {
    /// The counterpart of an object of the dictionary in the application.
    Application,
    Parameter,
    DataType,
    ParameterTemplate,
    AllowedValuesTemplate,
    LedState,
    FunctionType,
    FunctionInstance,
    Variable,
    ModuleInterface,
}

impl TextKind {
    pub(super) const BYTE: Self = Self::Number(0, 0xFF);
    pub(super) const SHORT: Self = Self::Number(0, 0xFFFF);
    pub(super) const INT: Self = Self::Number(0, 0xFFFF_FFFF);
    pub(super) const UNSIGNED_LONG: Self = Self::Number(0, u64::MAX as i128);
    pub(super) const LONG: Self = Self::Number(i64::MIN as i128, i64::MAX as i128);
    pub(super) const POSITIVE: Self = Self::Number(1, i128::MAX);
    pub(super) const NATURAL: Self = Self::Number(0, i128::MAX);
}

/// The bit rates that `supportedBaudRate` allows.
pub(crate) const BAUD_RATES: [&str; 10] = [
    "10 Kbps",
    "20 Kbps",
    "50 Kbps",
    "100 Kbps",
    "125 Kbps",
    "250 Kbps",
    "500 Kbps",
    "800 Kbps",
    "1000 Kbps",
    "auto-baudRate",
];
