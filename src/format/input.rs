//! Any file that commands and build scripts read: what it is, and what is in it.

use std::error::Error;
use std::fs::File;
use std::io::{self, Read};
use std::num::NonZeroUsize;
use std::path::Path;

use super::identify::{ContentKind, Identification, identify};
use super::json::Kind;
use super::{Description, Format, concise, json, nodelist};
use crate::diagnostic::counted;
use crate::download::ConciseDcf;
use crate::model::{Device, NodeList};
use crate::source::{DEFAULT_MAX_SIZE, Encoding, SourceError, SourceFile, SourceOptions};

/// A kind of file that commands and build scripts read or write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[non_exhaustive]
pub enum FileKind {
    /// Electronic data sheet (CiA 306-1)
    Eds,
    /// Device configuration file (CiA 306-1)
    Dcf,
    /// XML device description (CiA 311)
    Xdd,
    /// XML device configuration (CiA 311)
    Xdc,
    /// The model of a device, or the downloads of a concise DCF, as JSON
    Json,
    /// Concise DCF (CiA 302-3)
    Cdcf,
    /// Concise DCF as a text of one download a line (docs/dcf.md)
    #[cfg_attr(feature = "cli", value(name = "cdcf.txt"))]
    CdcfText,
    /// Node list (CiA 306-3)
    Cpj,
}

impl FileKind {
    /// What the last known ending of a name says, so `drive.eds.txt` is an EDS.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy();
        if name.to_ascii_lowercase().ends_with(".cdcf.txt") {
            return Some(Self::CdcfText);
        }
        name.rsplit('.').find_map(|ending| match ending.to_ascii_lowercase().as_str() {
            "json" => Some(Self::Json),
            "cdcf" => Some(Self::Cdcf),
            "cpj" => Some(Self::Cpj),
            ending => Format::from_name(ending).map(Self::from),
        })
    }

    /// The kind of a content that commands read.
    fn of_content(kind: ContentKind) -> Option<Self> {
        match kind {
            ContentKind::NodeList => Some(Self::Cpj),
            ContentKind::ConciseDcf => Some(Self::Cdcf),
            ContentKind::ConciseText => Some(Self::CdcfText),
            ContentKind::JsonDevice | ContentKind::JsonConciseDcf => Some(Self::Json),
            kind => kind.format().map(Self::from),
        }
    }

    /// The ending of its files.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Eds => "eds",
            Self::Dcf => "dcf",
            Self::Xdd => "xdd",
            Self::Xdc => "xdc",
            Self::Json => "json",
            Self::Cdcf => "cdcf",
            Self::CdcfText => "cdcf.txt",
            Self::Cpj => "cpj",
        }
    }

    /// The format, where it is a description with its text.
    pub const fn format(self) -> Option<Format> {
        match self {
            Self::Eds => Some(Format::Eds),
            Self::Dcf => Some(Format::Dcf),
            Self::Xdd => Some(Format::Xdd),
            Self::Xdc => Some(Format::Xdc),
            Self::Json | Self::Cdcf | Self::CdcfText | Self::Cpj => None,
        }
    }

    /// What people call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eds => "EDS",
            Self::Dcf => "DCF",
            Self::Xdd => "XDD",
            Self::Xdc => "XDC",
            Self::Json => "JSON",
            Self::Cdcf => "concise DCF",
            Self::CdcfText => "concise DCF as text",
            Self::Cpj => "node list",
        }
    }
}

impl From<Format> for FileKind {
    fn from(format: Format) -> Self {
        match format {
            Format::Eds => Self::Eds,
            Format::Dcf => Self::Dcf,
            Format::Xdd => Self::Xdd,
            Format::Xdc => Self::Xdc,
        }
    }
}

/// What was in a file.
#[derive(Debug)]
pub enum Input {
    /// A device as text: EDS, DCF, XDD or XDC.
    Description(Box<Description>),
    /// A device as JSON.
    Device(Box<Device>),
    /// The downloads of a concise DCF, as such or as JSON.
    Concise(ConciseDcf),
    /// The nodes of networks.
    NodeList(NodeList),
}

/// How a file is read.
#[derive(Clone, Debug)]
pub struct Reading {
    /// What it is, whatever its content shows; `None` finds it out.
    pub from: Option<FileKind>,
    /// Which device of a network file (`.nxdd`, `.nxdc`), counted from 1.
    pub device: Option<NonZeroUsize>,
    /// The encoding; `None` finds it out.
    pub encoding: Option<Encoding>,
    /// The largest size in bytes that is read. More than 1 GiB is never read.
    pub max_size: u64,
    /// The node that formulas in the text of a concise DCF are worked out for.
    pub node_id: Option<u8>,
}

impl Default for Reading {
    fn default() -> Self {
        Self { from: None, device: None, encoding: None, max_size: DEFAULT_MAX_SIZE, node_id: None }
    }
}

/// Why there is nothing to be had of a file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum InputError {
    /// It could not be opened.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// It is a directory.
    #[error("`{path}` is a directory")]
    Directory {
        /// The directory.
        path: String,
    },
    /// It is a look-alike of another technology, or a file of CANopen that nothing here reads.
    #[error("`{name}` {}", .found.verdict())]
    Foreign {
        /// The file.
        name: String,
        /// What it is.
        found: Box<Identification>,
    },
    /// Its content is damaged where that cannot be passed over: JSON, concise DCF, a node list.
    #[error("cannot read `{name}`: {error}")]
    Content {
        /// The file.
        name: String,
        /// What is wrong.
        error: Box<dyn Error + Send + Sync>,
    },
    /// It describes several devices, and nobody says which one is meant.
    #[error("`{name}` describes {count} devices")]
    SeveralDevices {
        /// The file.
        name: String,
        /// How many.
        count: usize,
    },
    /// It describes fewer devices than the number of the one that is meant.
    #[error("`{name}` has no device {number}, it describes {}", counted(*count, "device", "devices"))]
    NoSuchDevice {
        /// The file.
        name: String,
        /// The number, counted from 1.
        number: NonZeroUsize,
        /// How many it describes.
        count: usize,
    },
    /// It is a file of CANopen that describes no device.
    #[error("`{name}` is read as {} and describes no device", kind.name())]
    NoDevice {
        /// The file.
        name: String,
        /// What it was read as.
        kind: FileKind,
    },
}

impl InputError {
    /// What to do about it, where that is known; options are those of the command line.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Directory { path } => Some(format!("name files, such as `{path}/*.eds`")),
            Self::Foreign { found, .. } => found.advice().map(str::to_owned),
            Self::SeveralDevices { .. } => Some("say which one with `--device`, counted from 1".to_owned()),
            Self::NoDevice { .. } => Some("name an EDS or DCF".to_owned()),
            Self::Source(_) | Self::Content { .. } | Self::NoSuchDevice { .. } => None,
        }
    }
}

impl Reading {
    /// What is in a file, and as what kind it was read.
    ///
    /// # Errors
    /// When there is nothing to be had of it, see [`InputError`]. What is wrong in a description is among its findings.
    pub fn open(&self, path: &Path) -> Result<(FileKind, Input), InputError> {
        let bytes = bytes_of(path, self.max_size)?;
        self.read(&path.display().to_string(), bytes)
    }

    /// What is in the bytes of a file of this name, and as what kind they were read.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn read(&self, name: &str, bytes: Vec<u8>) -> Result<(FileKind, Input), InputError> {
        let kind = self.kind(name, &bytes)?;
        let damaged =
            |error: Box<dyn Error + Send + Sync>| InputError::Content { name: name.to_owned(), error };
        let input = match kind {
            FileKind::Eds | FileKind::Dcf | FileKind::Xdd | FileKind::Xdc => {
                let format = kind.format().unwrap_or(Format::Eds);
                Input::Description(Box::new(super::read(self.source(name, bytes)?, format)))
            }
            FileKind::Json => {
                let source = self.source(name, bytes)?;
                let text = source.text();
                match json::kind(text).map_err(|error| damaged(error.into()))? {
                    Kind::Device => json::read_device(text).map(|device| Input::Device(Box::new(device))),
                    Kind::ConciseDcf => json::read_configuration(text).map(Input::Concise),
                }
                .map_err(|error| damaged(error.into()))?
            }
            FileKind::Cdcf => {
                let configuration = ConciseDcf::parse(&bytes).map_err(|error| damaged(error.into()))?;
                Input::Concise(configuration)
            }
            FileKind::CdcfText => {
                let source = self.source(name, bytes)?;
                let configuration = concise::parse(source.text(), self.node_id);
                Input::Concise(configuration.map_err(|error| damaged(error.into()))?)
            }
            FileKind::Cpj => {
                let source = self.source(name, bytes)?;
                Input::NodeList(nodelist::read(&source).map_err(|error| damaged(error.into()))?)
            }
        };
        Ok((kind, input))
    }

    /// As [`read`](Self::read), of several devices the one that was asked for.
    ///
    /// # Errors
    /// As [`open`](Self::open), and when there is no such device, or several and none was asked for.
    pub fn read_one(&self, name: &str, bytes: Vec<u8>) -> Result<(FileKind, Input), InputError> {
        let (kind, input) = self.read(name, bytes)?;
        Ok(match input {
            Input::Description(description) => {
                (kind, Input::Description(Box::new(self.select(name, *description)?)))
            }
            input => (kind, input),
        })
    }

    /// The device of a file that was asked for: the only one, or the one of a number.
    ///
    /// # Errors
    /// When there is no such device, or several and none was asked for.
    pub fn select(&self, name: &str, description: Description) -> Result<Description, InputError> {
        let count = description.device_count();
        let name = name.to_owned();
        match self.device {
            None if count == 1 => Ok(description),
            None => Err(InputError::SeveralDevices { name, count }),
            Some(number) => {
                description.select(number.get() - 1).ok_or(InputError::NoSuchDevice { name, number, count })
            }
        }
    }

    /// What a file is: what the user says, else what its content shows, else its name, else an EDS.
    ///
    /// # Errors
    /// When it is something that nothing here reads: [`InputError::Foreign`].
    pub fn kind(&self, name: &str, bytes: &[u8]) -> Result<FileKind, InputError> {
        if let Some(kind) = self.from {
            return Ok(kind);
        }
        let found = identify(name, bytes);
        match FileKind::of_content(found.kind) {
            Some(kind) => Ok(kind),
            None if found.kind == ContentKind::Unknown => {
                Ok(FileKind::of(Path::new(name)).unwrap_or(FileKind::Eds))
            }
            None => Err(InputError::Foreign { name: name.to_owned(), found: Box::new(found) }),
        }
    }

    /// The text in the bytes of a file of this name.
    ///
    /// # Errors
    /// When there are too many.
    pub fn source(&self, name: &str, bytes: Vec<u8>) -> Result<SourceFile, SourceError> {
        let options = SourceOptions { encoding: self.encoding, max_size: self.max_size };
        SourceFile::from_bytes(name.to_owned(), bytes, &options)
    }
}

/// The bytes of a file as they are, not more than `limit`.
pub(crate) fn bytes_of(path: &Path, limit: u64) -> Result<Vec<u8>, InputError> {
    let name = || path.display().to_string();
    let unreadable = |error: io::Error| match path.is_dir() {
        true => InputError::Directory { path: name() },
        false => SourceError::Io { path: name(), error }.into(),
    };
    let file = File::open(path).map_err(unreadable)?;
    let size = file.metadata().map_err(unreadable)?.len();
    if size > limit {
        return Err(SourceError::TooLarge { path: name(), size, limit }.into());
    }
    let mut bytes = Vec::new();
    bytes.reserve_exact(usize::try_from(size).unwrap_or_default());
    read_bounded(file, &name(), limit, bytes).map_err(|error| match error {
        SourceError::Io { error, .. } => unreadable(error),
        error => error.into(),
    })
}

/// The rest of a stream, not more than `limit` bytes.
pub(crate) fn read_bounded(
    stream: impl Read,
    name: &str,
    limit: u64,
    mut bytes: Vec<u8>,
) -> Result<Vec<u8>, SourceError> {
    let mut stream = stream.take(limit.saturating_add(1));
    stream.read_to_end(&mut bytes).map_err(|error| SourceError::Io { path: name.to_owned(), error })?;
    let size = bytes.len() as u64;
    if size > limit { Err(SourceError::TooLarge { path: name.to_owned(), size, limit }) } else { Ok(bytes) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_known_ending_counts() {
        let kind = |name| FileKind::of(Path::new(name));
        assert_eq!(kind("a/drive.EDS"), Some(FileKind::Eds));
        assert_eq!(kind("drive.dcf.txt"), Some(FileKind::Dcf));
        assert_eq!(kind("drive.eds.json"), Some(FileKind::Json));
        assert_eq!(kind("json"), Some(FileKind::Json));
        assert_eq!(kind("drive.xml"), None);
    }
}
