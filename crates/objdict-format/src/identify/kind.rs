//! The kinds of contents that can be distinguished.

use crate::Format;
use crate::input::FileKind;

const ASK: &str = "ask the vendor for an EDS or XDD if the device also supports CANopen";

/// How objdict treats a kind of content.
enum KindRole {
    /// Read, as this kind of file.
    Read(FileKind),
    /// A different file of classic CANopen.
    Canopen,
    /// A file of a different technology.
    Foreign,
}

/// Declares the kinds of content, each with its name without the technology, its role, a description of its files, and
/// advice for files without a readable device.
macro_rules! content_kinds {
    ($( $(#[$doc:meta])+ $kind:ident $name:literal $role:expr, $verdict:literal, $advice:expr; )+) => {
        /// The content of a file.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "full", derive(serde::Serialize))]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[cfg_attr(feature = "full", serde(rename_all = "kebab-case"))]
        #[non_exhaustive]
        pub enum ContentKind {
            $( $(#[$doc])+ $kind, )+
        }

        impl ContentKind {
            /// Its name without the technology.
            pub const fn name(self) -> &'static str {
                match self { $( Self::$kind => $name ),+ }
            }

            /// A description of such a file, starting with a verb; empty if it depends on the file.
            pub(super) const fn verdict(self) -> &'static str {
                match self { $( Self::$kind => $verdict ),+ }
            }

            const fn role(self) -> KindRole {
                match self { $( Self::$kind => $role ),+ }
            }

            /// Advice for a file without a readable device.
            pub const fn advice(self) -> Option<&'static str> {
                match self { $( Self::$kind => $advice ),+ }
            }
        }
    };
}

content_kinds! {
    /// Electronic data sheet (CiA 306-1).
    Eds "EDS" KindRole::Read(FileKind::Eds), "is an EDS", None;
    /// Device configuration file (CiA 306-1).
    Dcf "DCF" KindRole::Read(FileKind::Dcf), "is a DCF", None;
    /// XML device description (CiA 311).
    Xdd "XDD" KindRole::Read(FileKind::Xdd), "is an XDD", None;
    /// XML device configuration (CiA 311).
    Xdc "XDC" KindRole::Read(FileKind::Xdc), "is an XDC", None;
    /// Profile database: the XML of an XDD, with the objects of a profile instead of a device's.
    Xpd "XPD" KindRole::Read(FileKind::Xdd), "is a profile database (XPD)", None;
    /// Several XDD in one file, as CANopenEditor saves a network (`.nxdd`).
    NetworkXdd "network of XDD" KindRole::Read(FileKind::Xdd), "", None;
    /// Several XDC in one file, as CANopenEditor saves a network (`.nxdc`).
    NetworkXdc "network of XDC" KindRole::Read(FileKind::Xdc), "", None;
    /// Project of the object dictionary editors of CANopenNode before they used XDD.
    CanopenNodeProject "CANopenNode project" KindRole::Read(FileKind::CanopenNode), "is a project of an object dictionary editor for CANopenNode from before XDD", None;
    /// Project of objdictgen, the generator of CanFestival (`.od`).
    ObjdictgenProject "objdictgen project" KindRole::Read(FileKind::Objdictgen), "is a project of objdictgen, the generator of CanFestival", None;
    /// Project of objdictgen in the JSON of its newer versions.
    ObjdictgenJson "objdictgen project as JSON" KindRole::Canopen, "is a project of objdictgen as JSON, which is not read", Some("`odg convert device.json device.od` creates a readable project");
    /// Project of CANopenEditor in the JSON of protobuf.
    CanopenEditorJson "CANopenEditor project as JSON" KindRole::Read(FileKind::CanopenEditorJson), "is a project of CANopenEditor as JSON", Some("convert it to an XDD");
    /// The short source of a device (docs/reference/device.md).
    DeviceToml "device.toml" KindRole::Read(FileKind::Toml), "is the short source of a device (device.toml)", None;
    /// Node list (CiA 306-3).
    NodeList "node list" KindRole::Read(FileKind::Cpj), "is a node list (CiA 306-3) and describes no device", Some("`objdict network check` checks it; its keys `Node…DCFName` name the descriptions");
    /// Concise DCF (CiA 302-3).
    ConciseDcf "concise DCF" KindRole::Read(FileKind::Cdcf), "is a concise DCF, which contains values but no device description", Some("name the DCF that it was created from");
    /// Concise DCF as text with one download per line (docs/guides/dcf.md).
    ConciseText "concise DCF as text" KindRole::Read(FileKind::CdcfText), "is a concise DCF, which contains values but no device description", Some("name the DCF that it was created from");
    /// A device in the JSON of this crate.
    JsonDevice "device as JSON" KindRole::Read(FileKind::Json), "is a device as JSON", Some("convert it to an EDS or DCF");
    /// A concise DCF in the JSON of this crate.
    JsonConciseDcf "concise DCF as JSON" KindRole::Read(FileKind::Json), "is a concise DCF, which contains values but no device description", Some("name the DCF that it was created from");
    /// Bus configuration in YAML, from which Lely's dcfgen and `ros2_canopen` generate DCF and concise DCF.
    BusConfiguration "bus configuration" KindRole::Canopen, "is a bus configuration for Lely's dcfgen or ros2_canopen and describes no device", Some("`objdict network check` checks it; its keys `dcf` name the descriptions");
    /// Network of this crate: its nodes and links in TOML (docs/guides/network.md).
    Network "network" KindRole::Canopen, "is a network of objdict and describes no device", Some("`objdict network check` checks it; its keys `file` name the descriptions");
    /// Patch of descriptions (docs/guides/patches.md).
    Patch "patch" KindRole::Canopen, "is a patch, which corrects descriptions and describes no device", Some("`objdict patch check` compares it with descriptions, and `--patch` applies it to them");
    /// EDS of Ethernet POWERLINK, with the layout of a CANopen EDS.
    PowerlinkEds "EDS" KindRole::Foreign, "describes an Ethernet POWERLINK device, not a CANopen one", Some("ask the vendor for the CANopen EDS or XDD");
    /// XML device description of Ethernet POWERLINK (EPSG 311).
    PowerlinkXdd "XDD" KindRole::Foreign, "describes an Ethernet POWERLINK device (EPSG 311), not a CANopen one", Some("ask the vendor for the CANopen EDS or XDD");
    /// XML device configuration of Ethernet POWERLINK (EPSG 311).
    PowerlinkXdc "XDC" KindRole::Foreign, "describes a configured Ethernet POWERLINK device (EPSG 311), not a CANopen one", Some("ask the vendor for the CANopen EDS or XDD");
    /// The configuration of the managing node of an Ethernet POWERLINK network, in the layout of a concise
    /// DCF.
    PowerlinkConcise "CDC" KindRole::Foreign, "configures an Ethernet POWERLINK network, not a CANopen one", Some("it has the layout of a concise DCF, so `--from cdcf` shows its contents");
    /// XML device description of CANopen FD (CiA 1311).
    CanopenFdXdd "XDD" KindRole::Foreign, "describes a CANopen FD device (CiA 1311), but only classic CANopen (CiA 311) is supported", Some("ask the vendor for an EDS or XDD if the device also supports classic CANopen");
    /// EtherCAT slave information.
    EthercatEsi "ESI" KindRole::Read(FileKind::Esi), "describes EtherCAT devices (ESI)", None;
    /// EDS of DeviceNet, EtherNet/IP, ControlNet or CompoNet (CIP).
    CipEds "EDS" KindRole::Foreign, "", Some("CANopen and CIP both call their files EDS; ask the vendor for the one of CANopen (CiA 306)");
    /// Constraints of an FPGA design in Tcl, stored by Vivado in files called `.xdc`.
    FpgaConstraints "FPGA constraints" KindRole::Foreign, "contains FPGA constraints (Tcl), not a CANopen device", Some("an XDC of CANopen is XML; this one belongs to an FPGA design");
    /// IO-Link device description.
    Iodd "IODD" KindRole::Foreign, "describes an IO-Link device (IODD), not a CANopen one", Some(ASK);
    /// PROFINET device description.
    Gsdml "GSDML" KindRole::Foreign, "describes a PROFINET device (GSDML), not a CANopen one", Some(ASK);
    /// PROFIBUS device description.
    Gsd "GSD" KindRole::Foreign, "describes a PROFIBUS device (GSD), not a CANopen one", Some(ASK);
    /// CAN database: messages and signals, as of J1939.
    Dbc "CAN database" KindRole::Foreign, "is a CAN database (DBC), which has messages and signals but no object dictionary", Some("ask the vendor for the EDS or DCF, which describes the objects in the messages");
    /// A device profile according to ISO 15745 for any other technology.
    OtherProfile "device profile" KindRole::Foreign, "", Some(ASK);
    /// Other XML.
    OtherXml "XML" KindRole::Foreign, "", Some("XDD and XDC have the root element `ISO15745ProfileContainer`; EDS and DCF are INI files");
    /// Unrecognised content.
    Unknown "unknown" KindRole::Foreign, "", None;
}

impl ContentKind {
    /// The kind of file as which it is read.
    pub const fn file(self) -> Option<FileKind> {
        if let KindRole::Read(kind) = self.role() { Some(kind) } else { None }
    }

    /// The format for reading it, if it is a device description that this crate can read.
    pub const fn format(self) -> Option<Format> {
        if let Some(kind) = self.file() { kind.format() } else { None }
    }

    /// Whether it belongs to classic CANopen, readable or not.
    pub const fn is_canopen(self) -> bool {
        !matches!((self, self.role()), (Self::EthercatEsi, _) | (_, KindRole::Foreign))
    }

    /// Whether it refers to the descriptions of several nodes instead of describing a device.
    pub const fn is_network(self) -> bool {
        matches!(self, Self::NodeList | Self::BusConfiguration | Self::Network)
    }
}
