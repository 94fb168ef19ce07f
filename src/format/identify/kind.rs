//! The kinds of contents that can be distinguished.

use crate::format::Format;

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum ContentKind {
    /// Electronic data sheet (CiA 306-1).
    Eds,
    /// Device configuration file (CiA 306-1).
    Dcf,
    /// XML device description (CiA 311).
    Xdd,
    /// XML device configuration (CiA 311).
    Xdc,
    /// Profile database: the XML of an XDD, with the objects of a profile instead of those of a device.
    Xpd,
    /// Several XDD in one file, as CANopenEditor saves a network (`.nxdd`).
    NetworkXdd,
    /// Several XDC in one file, as CANopenEditor saves a network (`.nxdc`).
    NetworkXdc,
    /// Project of the object dictionary editors of CANopenNode before they used XDD.
    CanopenNodeProject,
    /// Node list (CiA 306-3).
    NodeList,
    /// Concise DCF (CiA 302-3).
    ConciseDcf,
    /// Concise DCF as a text of one download a line (docs/dcf.md).
    ConciseText,
    /// A device in the JSON of this crate.
    JsonDevice,
    /// A concise DCF in the JSON of this crate.
    JsonConciseDcf,
    /// Bus configuration in YAML, from which Lely's dcfgen and `ros2_canopen` make DCF and concise DCF.
    BusConfiguration,
    /// Network of this crate: its nodes and links in TOML (docs/network.md).
    Network,
    /// XML device description of Ethernet POWERLINK (EPSG 311).
    PowerlinkXdd,
    /// XML device configuration of Ethernet POWERLINK (EPSG 311).
    PowerlinkXdc,
    /// What the managing node of an Ethernet POWERLINK network is configured with, in the layout of a concise DCF.
    PowerlinkConcise,
    /// XML device description of CANopen FD (CiA 1311).
    CanopenFdXdd,
    /// EtherCAT slave information.
    EthercatEsi,
    /// EDS of DeviceNet, EtherNet/IP, ControlNet or CompoNet (CIP).
    CipEds,
    /// Constraints of an FPGA design in Tcl, which Vivado keeps in files called `.xdc`.
    FpgaConstraints,
    /// IO-Link device description.
    Iodd,
    /// PROFINET device description.
    Gsdml,
    /// PROFIBUS device description.
    Gsd,
    /// CAN database: messages and signals, as of J1939.
    Dbc,
    /// A device profile by ISO 15745 for a technology that has no kind of its own here.
    OtherProfile,
    /// Other XML.
    OtherXml,
    /// Nothing that is known.
    Unknown,
}

impl ContentKind {
    /// What it is called, without the technology.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eds | Self::CipEds => "EDS",
            Self::Dcf => "DCF",
            Self::Xdd | Self::PowerlinkXdd | Self::CanopenFdXdd => "XDD",
            Self::Xdc | Self::PowerlinkXdc => "XDC",
            Self::Xpd => "XPD",
            Self::NetworkXdd => "network of XDD",
            Self::NetworkXdc => "network of XDC",
            Self::CanopenNodeProject => "CANopenNode project",
            Self::NodeList => "node list",
            Self::ConciseDcf => "concise DCF",
            Self::ConciseText => "concise DCF as text",
            Self::JsonDevice => "device as JSON",
            Self::JsonConciseDcf => "concise DCF as JSON",
            Self::BusConfiguration => "bus configuration",
            Self::Network => "network",
            Self::PowerlinkConcise => "CDC",
            Self::EthercatEsi => "ESI",
            Self::FpgaConstraints => "FPGA constraints",
            Self::Iodd => "IODD",
            Self::Gsdml => "GSDML",
            Self::Gsd => "GSD",
            Self::Dbc => "CAN database",
            Self::OtherProfile => "device profile",
            Self::OtherXml => "XML",
            Self::Unknown => "unknown",
        }
    }

    /// The format to read it in, where it is a description of a device that this crate reads.
    pub const fn format(self) -> Option<Format> {
        match self {
            Self::Eds => Some(Format::Eds),
            Self::Dcf => Some(Format::Dcf),
            Self::Xdd | Self::Xpd | Self::NetworkXdd | Self::CanopenNodeProject => Some(Format::Xdd),
            Self::Xdc | Self::NetworkXdc => Some(Format::Xdc),
            _ => None,
        }
    }

    /// Whether it belongs to classic CANopen, readable or not.
    pub const fn is_canopen(self) -> bool {
        matches!(
            self,
            Self::Eds
                | Self::Dcf
                | Self::Xdd
                | Self::Xdc
                | Self::Xpd
                | Self::NetworkXdd
                | Self::NetworkXdc
                | Self::CanopenNodeProject
                | Self::NodeList
                | Self::ConciseDcf
                | Self::ConciseText
                | Self::JsonDevice
                | Self::JsonConciseDcf
                | Self::BusConfiguration
                | Self::Network
        )
    }

    /// Whether it names the descriptions of several nodes, in place of describing a device.
    pub const fn is_network(self) -> bool {
        matches!(self, Self::NodeList | Self::BusConfiguration | Self::Network)
    }

    /// What to do about a file that no device can be read from.
    pub const fn advice(self) -> Option<&'static str> {
        match self {
            Self::Eds
            | Self::Dcf
            | Self::Xdd
            | Self::Xdc
            | Self::Xpd
            | Self::NetworkXdd
            | Self::NetworkXdc
            | Self::CanopenNodeProject
            | Self::Unknown => None,
            Self::NodeList => Some("its keys `Node…DCFName` name the descriptions"),
            Self::ConciseDcf | Self::ConciseText | Self::JsonConciseDcf => {
                Some("name the DCF that it was made of")
            }
            Self::JsonDevice => Some("convert it to an EDS or DCF"),
            Self::BusConfiguration => Some("its keys `dcf` name the descriptions"),
            Self::Network => Some("its keys `file` name the descriptions"),
            Self::PowerlinkXdd | Self::PowerlinkXdc => Some("ask the vendor for the CANopen EDS or XDD"),
            Self::PowerlinkConcise => {
                Some("its layout is that of a concise DCF, so `--from cdcf` shows what is in it")
            }
            Self::CanopenFdXdd => {
                Some("ask the vendor for the EDS or XDD of classic CANopen, if the device speaks it too")
            }
            Self::EthercatEsi | Self::Iodd | Self::Gsdml | Self::Gsd | Self::OtherProfile => {
                Some("ask the vendor for an EDS or XDD, if the device speaks CANopen too")
            }
            Self::CipEds => Some(
                "CANopen and CIP both call their files EDS; ask the vendor for the one of CANopen (CiA 306)",
            ),
            Self::FpgaConstraints => Some("an XDC of CANopen is XML; this one belongs to an FPGA design"),
            Self::Dbc => Some("an EDS or DCF has the objects behind the messages; ask the vendor for it"),
            Self::OtherXml => Some(
                "XDD and XDC have the root element `ISO15745ProfileContainer`; EDS and DCF are INI files",
            ),
        }
    }
}
