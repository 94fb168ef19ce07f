//! The numbers of an identity that a manager checks.

/// The numbers of 1000h and 1018h that the manager checks before it boots a node; each level includes the
/// previous ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum IdentityLevel {
    /// No number.
    None,
    /// Device type and vendor-ID (1F84h, 1F85h).
    Vendor,
    /// The product code (1F86h).
    Product,
    /// The revision number (1F87h).
    Revision,
    /// The serial number (1F88h), if a configured node states it.
    #[default]
    Serial,
}

impl IdentityLevel {
    /// All levels.
    pub const ALL: [Self; 5] = [Self::None, Self::Vendor, Self::Product, Self::Revision, Self::Serial];

    /// The word in `network.toml`.
    pub const fn word(self) -> &'static str {
        ["none", "vendor", "product", "revision", "serial"][self as usize]
    }

    /// The level of each number of an identity.
    pub(crate) const OF_NUMBERS: [Self; 5] =
        [Self::Vendor, Self::Vendor, Self::Product, Self::Revision, Self::Serial];
}
