//! The kinds of contents that can be distinguished.

use crate::Format;

const ASK: &str = "ask the vendor for an EDS or XDD, if the device speaks CANopen too";

/// What a kind of content is to this crate.
enum KindRole {
    /// The description of a device, which is read in this format.
    Read(Format),
    /// Another file of classic CANopen, readable or not.
    Canopen,
    /// A file of another technology.
    Foreign,
}

/// Declares the kinds of contents, each with what it is called without the technology, its role, and what to do about a file
/// that no device can be read from.
macro_rules! content_kinds {
    ($( $(#[$doc:meta])+ $kind:ident $name:literal $role:expr, $advice:expr; )+) => {
        /// What a file holds.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "full", derive(serde::Serialize))]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[cfg_attr(feature = "full", serde(rename_all = "kebab-case"))]
        #[non_exhaustive]
        pub enum ContentKind {
            $( $(#[$doc])+ $kind, )+
        }

        impl ContentKind {
            /// What it is called, without the technology.
            pub const fn name(self) -> &'static str {
                match self { $( Self::$kind => $name ),+ }
            }

            const fn role(self) -> KindRole {
                match self { $( Self::$kind => $role ),+ }
            }

            /// What to do about a file that no device can be read from.
            pub const fn advice(self) -> Option<&'static str> {
                match self { $( Self::$kind => $advice ),+ }
            }
        }
    };
}

content_kinds! {
    /// Electronic data sheet (CiA 306-1).
    Eds "EDS" KindRole::Read(Format::Eds), None;
    /// Device configuration file (CiA 306-1).
    Dcf "DCF" KindRole::Read(Format::Dcf), None;
    /// XML device description (CiA 311).
    Xdd "XDD" KindRole::Read(Format::Xdd), None;
    /// XML device configuration (CiA 311).
    Xdc "XDC" KindRole::Read(Format::Xdc), None;
    /// Profile database: the XML of an XDD, with the objects of a profile instead of those of a device.
    Xpd "XPD" KindRole::Read(Format::Xdd), None;
    /// Several XDD in one file, as CANopenEditor saves a network (`.nxdd`).
    NetworkXdd "network of XDD" KindRole::Read(Format::Xdd), None;
    /// Several XDC in one file, as CANopenEditor saves a network (`.nxdc`).
    NetworkXdc "network of XDC" KindRole::Read(Format::Xdc), None;
    /// Project of the object dictionary editors of CANopenNode before they used XDD.
    CanopenNodeProject "CANopenNode project" KindRole::Read(Format::Xdd), None;
    /// Project of objdictgen, the generator of CanFestival (`.od`).
    ObjdictgenProject "objdictgen project" KindRole::Read(Format::Xdd), None;
    /// Project of objdictgen in the JSON of its newer versions.
    ObjdictgenJson "objdictgen project as JSON" KindRole::Canopen, Some("`odg convert device.json device.od` makes a project that is read");
    /// Project of CANopenEditor in the JSON of protobuf.
    CanopenEditorJson "CANopenEditor project as JSON" KindRole::Canopen, Some("convert it to an XDD");
    /// The short source of a device (docs/device.md).
    DeviceToml "device.toml" KindRole::Read(Format::Toml), None;
    /// Node list (CiA 306-3).
    NodeList "node list" KindRole::Canopen, Some("`objdict network check` checks it; its keys `Node…DCFName` name the descriptions");
    /// Concise DCF (CiA 302-3).
    ConciseDcf "concise DCF" KindRole::Canopen, Some("name the DCF that it was made of");
    /// Concise DCF as a text of one download a line (docs/dcf.md).
    ConciseText "concise DCF as text" KindRole::Canopen, Some("name the DCF that it was made of");
    /// A device in the JSON of this crate.
    JsonDevice "device as JSON" KindRole::Canopen, Some("convert it to an EDS or DCF");
    /// A concise DCF in the JSON of this crate.
    JsonConciseDcf "concise DCF as JSON" KindRole::Canopen, Some("name the DCF that it was made of");
    /// Bus configuration in YAML, from which Lely's dcfgen and `ros2_canopen` make DCF and concise DCF.
    BusConfiguration "bus configuration" KindRole::Canopen, Some("`objdict network check` checks it; its keys `dcf` name the descriptions");
    /// Network of this crate: its nodes and links in TOML (docs/network.md).
    Network "network" KindRole::Canopen, Some("`objdict network check` checks it; its keys `file` name the descriptions");
    /// Patch of descriptions (docs/patches.md).
    Patch "patch" KindRole::Canopen, Some("`objdict patch check` compares it with descriptions, and `--patch` applies it to them");
    /// EDS of Ethernet POWERLINK, which has the layout of that of CANopen.
    PowerlinkEds "EDS" KindRole::Foreign, Some("ask the vendor for the CANopen EDS or XDD");
    /// XML device description of Ethernet POWERLINK (EPSG 311).
    PowerlinkXdd "XDD" KindRole::Foreign, Some("ask the vendor for the CANopen EDS or XDD");
    /// XML device configuration of Ethernet POWERLINK (EPSG 311).
    PowerlinkXdc "XDC" KindRole::Foreign, Some("ask the vendor for the CANopen EDS or XDD");
    /// What the managing node of an Ethernet POWERLINK network is configured with, in the layout of a concise DCF.
    PowerlinkConcise "CDC" KindRole::Foreign, Some("its layout is that of a concise DCF, so `--from cdcf` shows what is in it");
    /// XML device description of CANopen FD (CiA 1311).
    CanopenFdXdd "XDD" KindRole::Foreign, Some("ask the vendor for the EDS or XDD of classic CANopen, if the device speaks it too");
    /// EtherCAT slave information.
    EthercatEsi "ESI" KindRole::Foreign, Some(ASK);
    /// EDS of DeviceNet, EtherNet/IP, ControlNet or CompoNet (CIP).
    CipEds "EDS" KindRole::Foreign, Some("CANopen and CIP both call their files EDS; ask the vendor for the one of CANopen (CiA 306)");
    /// Constraints of an FPGA design in Tcl, which Vivado keeps in files called `.xdc`.
    FpgaConstraints "FPGA constraints" KindRole::Foreign, Some("an XDC of CANopen is XML; this one belongs to an FPGA design");
    /// IO-Link device description.
    Iodd "IODD" KindRole::Foreign, Some(ASK);
    /// PROFINET device description.
    Gsdml "GSDML" KindRole::Foreign, Some(ASK);
    /// PROFIBUS device description.
    Gsd "GSD" KindRole::Foreign, Some(ASK);
    /// CAN database: messages and signals, as of J1939.
    Dbc "CAN database" KindRole::Foreign, Some("an EDS or DCF has the objects behind the messages; ask the vendor for it");
    /// A device profile by ISO 15745 for a technology that has no kind of its own here.
    OtherProfile "device profile" KindRole::Foreign, Some(ASK);
    /// Other XML.
    OtherXml "XML" KindRole::Foreign, Some("XDD and XDC have the root element `ISO15745ProfileContainer`; EDS and DCF are INI files");
    /// Nothing that is known.
    Unknown "unknown" KindRole::Foreign, None;
}

impl ContentKind {
    /// The format to read it in, where it is a description of a device that this crate reads.
    pub const fn format(self) -> Option<Format> {
        match self.role() {
            KindRole::Read(format) => Some(format),
            _ => None,
        }
    }

    /// Whether it belongs to classic CANopen, readable or not.
    pub const fn is_canopen(self) -> bool {
        !matches!(self.role(), KindRole::Foreign)
    }

    /// Whether it names the descriptions of several nodes, in place of describing a device.
    pub const fn is_network(self) -> bool {
        matches!(self, Self::NodeList | Self::BusConfiguration | Self::Network)
    }
}
