//! The files that a command reads.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use clap::{Args, ValueEnum};

use super::Failure;
use crate::download::Configuration;
use crate::format::identify::{ContentKind, Identification, identify};
use crate::format::json::Kind;
use crate::format::{self, Description, Format, concise, json};
use crate::model::{Device, NodeList};
use crate::source::{DEFAULT_MAX_SIZE, Encoding, SourceError, SourceFile, SourceOptions};

/// What reports call the standard input.
const STDIN: &str = "<stdin>";

/// How files are read.
#[derive(Debug, Args)]
pub(super) struct InputArgs {
    /// What the files are, whatever their content shows
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub from: Option<FileKind>,
    /// Which device of a network file (.nxdd, .nxdc), counted from 1
    #[arg(long, value_name = "NUMBER")]
    pub device: Option<std::num::NonZeroUsize>,
    /// The encoding of the files, where it cannot be found out: utf-8, windows-1252, cp850, utf-16le …
    #[arg(long, value_name = "ENCODING")]
    pub encoding: Option<Encoding>,
    #[command(flatten)]
    pub size: SizeArgs,
}

/// How much of a file is read.
#[derive(Debug, Args)]
pub(super) struct SizeArgs {
    /// The largest file that is read, in bytes or with K, M or G behind the number; without it 64M
    #[arg(long, value_name = "SIZE", default_value_t = DEFAULT_MAX_SIZE, hide_default_value = true, value_parser = parse_size)]
    pub max_size: u64,
}

/// A kind of file that commands read or write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum FileKind {
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
    /// Node list (CiA 306-3)
    Cpj,
}

impl FileKind {
    /// What the last known ending of a name says, so `drive.eds.txt` is an EDS.
    pub(super) fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy();
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
            ContentKind::JsonDevice | ContentKind::JsonConciseDcf => Some(Self::Json),
            kind => kind.format().map(Self::from),
        }
    }

    /// The ending of its files.
    pub(super) const fn ending(self) -> &'static str {
        match self {
            Self::Eds => "eds",
            Self::Dcf => "dcf",
            Self::Xdd => "xdd",
            Self::Xdc => "xdc",
            Self::Json => "json",
            Self::Cdcf => "cdcf",
            Self::Cpj => "cpj",
        }
    }

    /// The format of a description.
    pub(super) const fn format(self) -> Option<Format> {
        match self {
            Self::Eds => Some(Format::Eds),
            Self::Dcf => Some(Format::Dcf),
            Self::Xdd => Some(Format::Xdd),
            Self::Xdc => Some(Format::Xdc),
            Self::Json | Self::Cdcf | Self::Cpj => None,
        }
    }

    /// What people call it.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Eds => "EDS",
            Self::Dcf => "DCF",
            Self::Xdd => "XDD",
            Self::Xdc => "XDC",
            Self::Json => "JSON",
            Self::Cdcf => "concise DCF",
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
pub(super) enum Input {
    /// A device as text: EDS, DCF, XDD or XDC.
    Description(Box<Description>),
    /// A device as JSON.
    Device(Box<Device>),
    /// The downloads of a concise DCF, as such or as JSON.
    Configuration(Configuration),
    /// The nodes of networks.
    NodeList(NodeList),
}

/// What a file is that is to be checked.
pub(super) enum Candidate {
    /// A description with its text.
    Description(Box<Description>),
    /// Something else: what it is called, and why it cannot be checked.
    Foreign(String, Failure),
}

impl InputArgs {
    /// What is in a file, and as what kind it was read; `-` is the standard input.
    pub(super) fn read(&self, path: &Path) -> Result<(FileKind, Input), Failure> {
        let unreadable = |error: &dyn std::fmt::Display| {
            Failure::new(format_args!("cannot read `{}`: {error}", name_of(path)))
        };
        let bytes = self.size.bytes(path)?;
        let kind = self.kind(path, &bytes)?;
        let input = match kind {
            FileKind::Eds | FileKind::Dcf | FileKind::Xdd | FileKind::Xdc => {
                let format = kind.format().unwrap_or(Format::Eds);
                Input::Description(Box::new(format::read(self.source(path, bytes)?, format)))
            }
            FileKind::Json => {
                let source = self.source(path, bytes)?;
                let text = source.text();
                match json::kind(text).map_err(|error| unreadable(&error))? {
                    Kind::Device => json::read_device(text).map(|device| Input::Device(Box::new(device))),
                    Kind::ConciseDcf => json::read_configuration(text).map(Input::Configuration),
                }
                .map_err(|error| unreadable(&error))?
            }
            FileKind::Cdcf => {
                concise::read(&bytes).map(Input::Configuration).map_err(|error| unreadable(&error))?
            }
            FileKind::Cpj => {
                let source = self.source(path, bytes)?;
                format::nodelist::read(&source).map(Input::NodeList).map_err(|error| unreadable(&error))?
            }
        };
        Ok((kind, input))
    }

    /// What is in a file, and as what kind it was read; of several devices the one that was asked for.
    pub(super) fn read_one(&self, path: &Path) -> Result<(FileKind, Input), Failure> {
        let (kind, input) = self.read(path)?;
        Ok(match input {
            Input::Description(description) => {
                (kind, Input::Description(Box::new(self.selected(path, *description)?)))
            }
            input => (kind, input),
        })
    }

    /// The device of a file that was asked for: the only one, or the one of a number.
    pub(super) fn selected(&self, path: &Path, description: Description) -> Result<Description, Failure> {
        let count = description.device_count();
        let name = name_of(path);
        match self.device {
            None if count == 1 => Ok(description),
            None => {
                let failure = Failure::new(format_args!("`{name}` describes {count} devices"));
                Err(failure.help("say which one with `--device`, counted from 1"))
            }
            Some(number) => description.select(number.get() - 1).ok_or_else(|| {
                let devices = if count == 1 { "device" } else { "devices" };
                Failure::new(format_args!("`{name}` has no device {number}, it describes {count} {devices}"))
            }),
        }
    }

    /// A file that is to be checked.
    pub(super) fn candidate(&self, path: &Path) -> Result<Candidate, Failure> {
        let bytes = self.size.bytes(path)?;
        let kind = match self.found(path, &bytes) {
            Ok(kind) => kind,
            Err(found) => {
                let technology = found.technology.as_ref().map(|name| format!(" ({name})"));
                let called = format!("{}{}", found.kind.name(), technology.unwrap_or_default());
                return Ok(Candidate::Foreign(called, foreign(path, &found)));
            }
        };
        match kind.format() {
            Some(format) => {
                let description = format::read(self.source(path, bytes)?, format);
                Ok(Candidate::Description(Box::new(description)))
            }
            None => {
                let name = name_of(path);
                let message = format!(
                    "only EDS, DCF, XDD and XDC can be checked, and `{name}` is read as {}",
                    kind.name()
                );
                let help = format!("`objdict show {name}` shows what is in it");
                Ok(Candidate::Foreign(kind.name().to_owned(), Failure::new(message).help(help)))
            }
        }
    }

    /// What a file is: what the user says, else what its content shows, else its name, else an EDS.
    fn kind(&self, path: &Path, bytes: &[u8]) -> Result<FileKind, Failure> {
        self.found(path, bytes).map_err(|found| foreign(path, &found))
    }

    /// As [`kind`](Self::kind); what no command reads, as it was identified.
    fn found(&self, path: &Path, bytes: &[u8]) -> Result<FileKind, Identification> {
        if let Some(kind) = self.from {
            return Ok(kind);
        }
        let found = identify(&name_of(path), bytes);
        match FileKind::of_content(found.kind) {
            Some(kind) => Ok(kind),
            None if found.kind == ContentKind::Unknown => Ok(FileKind::of(path).unwrap_or(FileKind::Eds)),
            None => Err(found),
        }
    }

    fn source(&self, path: &Path, bytes: Vec<u8>) -> Result<SourceFile, Failure> {
        let options = SourceOptions { encoding: self.encoding, max_size: self.size.max_size };
        SourceFile::from_bytes(name_of(path), bytes, &options).map_err(Failure::new)
    }
}

impl SizeArgs {
    /// The bytes of a file as they are.
    pub(super) fn bytes(&self, path: &Path) -> Result<Vec<u8>, Failure> {
        let unreadable = |error: io::Error| match path.is_dir() {
            true => directory(path),
            false => Failure::new(SourceError::Io { path: name_of(path), error }),
        };
        let mut bytes = Vec::new();
        let limit = self.max_size.saturating_add(1);
        if path == Path::new("-") {
            io::stdin().lock().take(limit).read_to_end(&mut bytes).map_err(unreadable)?;
        } else {
            let file = File::open(path).map_err(unreadable)?;
            let size = file.metadata().map_err(unreadable)?.len();
            if size > self.max_size {
                return Err(self.too_large(path, size));
            }
            bytes.reserve_exact(usize::try_from(size).unwrap_or_default());
            file.take(limit).read_to_end(&mut bytes).map_err(unreadable)?;
        }
        let size = bytes.len() as u64;
        if size > self.max_size { Err(self.too_large(path, size)) } else { Ok(bytes) }
    }

    fn too_large(&self, path: &Path, size: u64) -> Failure {
        Failure::new(SourceError::TooLarge { path: name_of(path), size, limit: self.max_size })
    }
}

/// What reports call a file.
pub(super) fn name_of(path: &Path) -> String {
    if path == Path::new("-") { STDIN.to_owned() } else { path.display().to_string() }
}

/// Why a file cannot be read that is something else.
fn foreign(path: &Path, found: &Identification) -> Failure {
    let failure = Failure::new(format_args!("`{}` {}", name_of(path), found.verdict()));
    match found.advice() {
        Some(advice) => failure.help(advice),
        None => failure,
    }
}

fn directory(path: &Path) -> Failure {
    let path = path.display();
    let failure = Failure::new(format_args!("`{path}` is a directory"));
    failure.help(format!("name files, such as `{path}/*.eds`"))
}

/// `1000`, `64M`.
fn parse_size(text: &str) -> Result<u64, String> {
    let (digits, factor) = match text.trim_end_matches(['i', 'B', 'b']) {
        rest if rest.ends_with(['K', 'k']) => (&rest[..rest.len() - 1], 1 << 10),
        rest if rest.ends_with(['M', 'm']) => (&rest[..rest.len() - 1], 1 << 20),
        rest if rest.ends_with(['G', 'g']) => (&rest[..rest.len() - 1], 1 << 30),
        rest => (rest, 1u64),
    };
    digits
        .parse::<u64>()
        .ok()
        .and_then(|number| number.checked_mul(factor))
        .ok_or_else(|| "expected a number of bytes such as `1000000` or `64M`".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_units() {
        assert_eq!(parse_size("1000"), Ok(1000));
        assert_eq!(parse_size("64M"), Ok(64 << 20));
        assert_eq!(parse_size("2KiB"), Ok(2048));
        assert!(parse_size("99999999999G").is_err());
        assert!(parse_size("much").is_err());
    }

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
