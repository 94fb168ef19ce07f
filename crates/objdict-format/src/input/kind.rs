//! The kinds of files that commands and build scripts read or write.

use std::path::Path;

use crate::Format;

/// The description of writing for formats whose texts are edited.
#[cfg(feature = "clap")]
const EDITED: &str = "by edits of the text, or in the canonical style";

/// Declares the kinds of files, each with its keyword on the command line, its file extensions, its common name, the
/// crate feature for reading it, its format if it is a description with text, how it is written, and its row in
/// docs/reference/formats.md.
macro_rules! file_kinds {
    ($( $(#[$doc:meta])+ $kind:ident $word:literal $endings:expr, $name:literal $feature:expr, $format:expr, $written:expr, $about:literal; )+) => {
        /// A kind of file that commands and build scripts read or write.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
        #[non_exhaustive]
        pub enum FileKind {
            $( $(#[$doc])+ #[cfg_attr(feature = "clap", value(name = $word))] $kind, )+
        }

        impl FileKind {
            const ALL: &[Self] = &[$( Self::$kind ),+];

            /// Its word on the command line.
            #[cfg(feature = "clap")]
            pub const fn word(self) -> &'static str {
                match self { $( Self::$kind => $word ),+ }
            }

            /// Its file extensions, the usual one first.
            pub const fn endings(self) -> &'static [&'static str] {
                match self { $( Self::$kind => &$endings ),+ }
            }

            /// Its common name.
            pub const fn name(self) -> &'static str {
                match self { $( Self::$kind => $name ),+ }
            }

            /// The crate feature for reading it; `None` if it cannot be read.
            pub(super) const fn feature(self) -> Option<&'static str> {
                match self { $( Self::$kind => $feature ),+ }
            }

            /// The format, if it is a description with text.
            pub const fn format(self) -> Option<Format> {
                match self { $( Self::$kind => $format ),+ }
            }

            /// How it is written from a description; `None` if it cannot be written.
            #[cfg(feature = "clap")]
            const fn writing(self) -> Option<&'static str> {
                match self { $( Self::$kind => $written ),+ }
            }

            /// Its description in docs/reference/formats.md.
            #[cfg(feature = "clap")]
            const fn about(self) -> &'static str {
                match self { $( Self::$kind => $about ),+ }
            }
        }
    };
}

file_kinds! {
    /// Electronic data sheet (CiA 306-1)
    Eds "eds" ["eds"], "EDS" Some("default"), Some(Format::Eds), Some(EDITED),
        "electronic data sheet: a type of device (CiA 306-1)";
    /// Device configuration file (CiA 306-1)
    Dcf "dcf" ["dcf"], "DCF" Some("default"), Some(Format::Dcf), Some(EDITED),
        "device configuration file: one node (CiA 306-1)";
    /// XML device description (CiA 311)
    Xdd "xdd" ["xdd", "nxdd", "xpd"], "XDD" Some("xdd"), Some(Format::Xdd), Some(EDITED),
        "XML device description: a type of device (CiA 311, versions 1.0 and 1.1); networks (`.nxdd`) and profile databases (`.xpd`) of CANopenEditor are only read";
    /// XML device configuration (CiA 311)
    Xdc "xdc" ["xdc", "nxdc"], "XDC" Some("xdd"), Some(Format::Xdc), Some(EDITED),
        "XML device configuration: one node (CiA 311); networks (`.nxdc`) of CANopenEditor are only read";
    /// Compact device source (docs/reference/device.md)
    Toml "toml" ["toml"], "device.toml" Some("toml"), Some(Format::Toml), Some(EDITED),
        "compact device source ([device.md](device.md))";
    /// Project of the editors for CANopenNode from before XDD (input only)
    // its objects are like those of an XDD
    CanopenNode "canopennode" ["xml"], "CANopenNode project" Some("xdd"), Some(Format::Xdd), None,
        "project of the editors for CANopenNode from before XDD, root element `device` ([projects](projects.md#editors-for-canopennode))";
    /// Project of objdictgen, the generator of CanFestival (input only)
    Objdictgen "od" ["od"], "objdictgen project" Some("xdd"), Some(Format::Xdd), None,
        "project of objdictgen, the generator of CanFestival ([projects](projects.md#objdictgen))";
    /// EtherCAT slave information, ESI (input only)
    Esi "esi" ["xml"], "ESI" Some("esi"), Some(Format::Xdd), None,
        "EtherCAT slave information, root element `EtherCATInfo` ([esi](esi.md))";
    /// Device model, or downloads of a concise DCF, as JSON
    Json "json" ["json"], "JSON" Some("toml"), None, Some("yes"),
        "the whole model of a device, or the downloads of a concise DCF ([below](#json))";
    /// Project of CANopenEditor as JSON, with the settings for CANopenNode
    CanopenEditorJson "canopeneditor-json" ["json"], "CANopenEditor project" Some("toml"), None, Some("yes, with `--to canopeneditor-json`"),
        "project of CANopenEditor, as its JSON (protobuf) ([projects](projects.md#canopeneditor))";
    /// Concise DCF (CiA 302-3)
    Cdcf "cdcf" ["cdcf"], "concise DCF" Some("toml"), None, Some("yes"),
        "concise DCF: the stream that a CANopen manager keeps in 1F22h (CiA 302-3)";
    /// Concise DCF as text with one download per line (docs/guides/concise-dcf.md)
    CdcfText "cdcf.txt" ["cdcf.txt"], "concise DCF as text" Some("toml"), None, Some("yes"),
        "concise DCF as a text with one download per line ([concise-dcf.md](../guides/concise-dcf.md))";
    /// Node list (CiA 306-3)
    Cpj "cpj" ["cpj"], "node list" Some("full"), None, None,
        "node list of a network (CiA 306-3)";
    /// Messages of nodes on the CAN bus (output only)
    #[cfg_attr(feature = "clap", value(skip))]
    Dbc "dbc" ["dbc"], "DBC" None, None, Some("[yes](dbc.md)"),
        "database of the CAN bus: the messages and signals of nodes";
}

impl FileKind {
    /// The kinds that a description is converted to.
    #[cfg(feature = "clap")]
    pub fn written() -> impl Iterator<Item = Self> {
        Self::ALL.iter().copied().filter(|kind| kind.writing().is_some())
    }

    /// The kinds that can be read.
    #[cfg(feature = "clap")]
    pub fn read() -> impl Iterator<Item = Self> {
        Self::ALL.iter().copied().filter(|kind| kind.feature().is_some())
    }

    /// The table of formats in docs/reference/formats.md.
    #[cfg(feature = "clap")]
    pub fn table() -> String {
        let row = |kind: &Self| {
            let endings: Vec<_> = kind.endings().iter().map(|ending| format!("`.{ending}`")).collect();
            let read = if kind.feature().is_some() { "yes" } else { "no" };
            let (endings, written) = (endings.join(", "), kind.writing().unwrap_or("no"));
            format!("| {endings} | {} | {read} | {written} |\n", kind.about())
        };
        let rows: String = Self::ALL.iter().map(row).collect();
        format!("| extension | format | read | written |\n|---|---|---|---|\n{rows}")
    }

    /// Its usual file extension.
    pub const fn ending(self) -> &'static str {
        match self.endings() {
            [usual, ..] => usual,
            [] => "",
        }
    }

    /// The kind for the last known extension in a name, so `drive.eds.txt` is an EDS.
    pub fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy();
        if name.to_ascii_lowercase().ends_with(".cdcf.txt") {
            return Some(Self::CdcfText);
        }
        // an extension shared by several kinds means the first one, and many other files are XML
        let kinds = Self::ALL.iter().copied().filter(|kind| !matches!(kind, Self::CanopenNode | Self::Esi));
        let is =
            |kind: &Self, part: &str| kind.endings().iter().any(|known| known.eq_ignore_ascii_case(part));
        name.rsplit('.').find_map(|part| kinds.clone().find(|kind| is(kind, part)))
    }
}

impl From<Format> for FileKind {
    fn from(format: Format) -> Self {
        match format {
            Format::Eds => Self::Eds,
            Format::Dcf => Self::Dcf,
            Format::Xdd => Self::Xdd,
            Format::Xdc => Self::Xdc,
            Format::Toml => Self::Toml,
        }
    }
}
