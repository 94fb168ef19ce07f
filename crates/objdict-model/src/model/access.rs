//! Access types and PDO mapping (CiA 306-1 §4.6.3.2, CiA 301 §7.4.5).

named! {
    /// The access of the network to an entry.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
    pub enum Access {
        /// Read only; the device may change the value.
        Ro = "ro",
        /// Write only.
        Wo = "wo",
        /// Read and write.
        Rw = "rw",
        /// Read and write; a process input, which a TPDO can carry.
        Rwr = "rwr",
        /// Read and write; a process output, which an RPDO can carry.
        Rww = "rww",
        /// Read only, and the value never changes.
        Const = "const",
    }
}

impl Access {
    /// The access type with this name, ignoring case.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|access| access.name().eq_ignore_ascii_case(name))
    }

    /// Whether an SDO upload may read the value.
    pub const fn is_readable(self) -> bool {
        !matches!(self, Self::Wo)
    }

    /// Whether an SDO download may write the value.
    pub const fn is_writable(self) -> bool {
        !matches!(self, Self::Ro | Self::Const)
    }

    /// Whether a TPDO may carry the value.
    pub const fn fits_tpdo(self) -> bool {
        matches!(self, Self::Ro | Self::Rw | Self::Rwr | Self::Const)
    }

    /// Whether an RPDO may write the value.
    pub const fn fits_rpdo(self) -> bool {
        matches!(self, Self::Wo | Self::Rw | Self::Rww)
    }
}

named! {
    /// Whether a PDO may carry an entry. An EDS has only [`No`](Self::No) and [`Optional`](Self::Optional).
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
    pub enum PdoMapping {
        /// Never.
        #[default]
        No = "no",
        /// In every direction that the access type allows.
        Optional = "optional",
        /// Mapped by default.
        Default = "default",
        /// Only in a TPDO.
        Tpdo = "TPDO",
        /// Only in an RPDO.
        Rpdo = "RPDO",
    }
}

impl PdoMapping {
    /// Whether any PDO may carry the entry.
    pub const fn is_mappable(self) -> bool {
        !matches!(self, Self::No)
    }
}
