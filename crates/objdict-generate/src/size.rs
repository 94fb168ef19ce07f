//! Size of a target's tables in flash and RAM: rows, defaults, limits and values, without the code that uses
//! them.

/// Sizes in bytes for a processor that aligns numbers to their size, at most to eight bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Size {
    /// In flash: rows of the table, defaults and limits.
    pub flash: usize,
    /// In RAM: the writable values.
    pub ram: usize,
}

/// The size of an object.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ObjectSize {
    /// Its index.
    pub index: u16,
    /// Its name in the description.
    pub name: String,
    /// Number of entries.
    pub entries: usize,
    /// Its size. Shared defaults and limits are attributed to the first object.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub size: Size,
}

/// The sizes of a target's tables, by object.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SizeReport {
    /// The content that the sizes include, and the processor: a line in lower case.
    pub counted: &'static str,
    /// The objects, by index.
    pub objects: Vec<ObjectSize>,
    /// Bytes without an object: the node-ID, shared parts of rows, end marks, and padding.
    pub rest: Size,
    /// Bytes of code in flash; 0 if unknown.
    pub code: usize,
    /// Bytes of the names of entries in flash, if the program uses them; 0 if they are omitted or in the rows.
    pub names: usize,
    /// The total, with the code and without the names.
    pub total: Size,
}

/// The sizes of a target's tables, if known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sizes {
    /// The sizes.
    Known(SizeReport),
    /// Why they are unknown: a line in lower case.
    Unknown(&'static str),
}

impl SizeReport {
    pub(crate) fn new(counted: &'static str, objects: Vec<ObjectSize>, rest: Size) -> Self {
        let total = objects.iter().fold(rest, |sum, object| sum + object.size);
        Self { counted, objects, rest, code: 0, names: 0, total }
    }
}

impl std::ops::Add for Size {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { flash: self.flash + other.flash, ram: self.ram + other.ram }
    }
}
