//! The formats of description files.

use crate::model::DeviceKind;

named! {
    /// The format of a file.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Format {
        /// Electronic data sheet: a type of device (CiA 306-1).
        Eds = "EDS",
        /// Device configuration file: a node (CiA 306-1).
        Dcf = "DCF",
        /// XML device description: a type of device (CiA 311).
        Xdd = "XDD",
        /// XML device configuration: a node (CiA 311).
        Xdc = "XDC",
        /// The short source of a device, of either kind (docs/reference/device.md).
        Toml = "device.toml",
    }
}

impl Format {
    /// The format for a file name, by its last known extension: `drive.eds.txt` is an EDS.
    pub fn from_name(name: &str) -> Option<Self> {
        name.rsplit('.').find_map(|ending| match ending.to_ascii_lowercase().as_str() {
            "eds" => Some(Self::Eds),
            "dcf" => Some(Self::Dcf),
            "xdd" | "nxdd" | "xpd" => Some(Self::Xdd),
            "xdc" | "nxdc" => Some(Self::Xdc),
            "toml" => Some(Self::Toml),
            _ => None,
        })
    }

    /// The format with this syntax for this kind of device.
    pub const fn of(syntax: Syntax, kind: DeviceKind) -> Self {
        match (syntax, kind) {
            (Syntax::Ini, DeviceKind::Type) => Self::Eds,
            (Syntax::Ini, DeviceKind::Node) => Self::Dcf,
            (Syntax::Xml, DeviceKind::Type) => Self::Xdd,
            (Syntax::Xml, DeviceKind::Node) => Self::Xdc,
            (Syntax::Toml, _) => Self::Toml,
        }
    }

    /// The kind of device that a file of this format describes; of one that describes both, a type.
    pub const fn kind(self) -> DeviceKind {
        match self {
            Self::Eds | Self::Xdd | Self::Toml => DeviceKind::Type,
            Self::Dcf | Self::Xdc => DeviceKind::Node,
        }
    }

    /// The syntax of the format.
    pub const fn syntax(self) -> Syntax {
        match self {
            Self::Eds | Self::Dcf => Syntax::Ini,
            Self::Xdd | Self::Xdc => Syntax::Xml,
            Self::Toml => Syntax::Toml,
        }
    }
}

/// The syntax of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Syntax {
    /// Sections and keys.
    Ini,
    /// Elements and attributes.
    Xml,
    /// Tables of keys.
    Toml,
}
