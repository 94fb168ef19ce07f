//! The files that a command reads.

use std::borrow::Cow;
use std::fs::File;
use std::io;
use std::path::Path;
use std::sync::Arc;

use clap::Args;

use super::ending::Failure;
use super::ending::detail;
use super::patch_option::PatchArgs;
use super::settings::{ConfigFileArgs, reading};
use super::written_files::keep;
use objdict_format::identify::ContentKind;
use objdict_format::input::{DEFAULT_MAX_ENTRIES, Reading};
pub(super) use objdict_format::input::{FileKind, Input};
use objdict_format::patch::Patch;
use objdict_format::{Description, EditError, ReadError, WriteOptions};
use objdict_model::diagnostic::{listing_or, one_line};
use objdict_model::model::Device;
use objdict_model::source;
use objdict_model::source::{DEFAULT_MAX_SIZE, Encoding, SourceError};

/// The extensions of kinds of files, for a message: "`.eds` or `.dcf`".
pub(super) fn extensions(kinds: impl IntoIterator<Item = FileKind>) -> String {
    let mut endings: Vec<String> = kinds.into_iter().map(|kind| format!(".{}", kind.ending())).collect();
    endings.dedup();
    listing_or(endings).to_string()
}

/// What reports call the standard input.
const STDIN: &str = "<stdin>";

// How files are read.
#[derive(Debug, Args)]
#[command(next_help_heading = "Input")]
pub(super) struct InputArgs {
    /// Input format [default: detected]
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub from: Option<FileKind>,
    /// Number of the device in a network file (.nxdd, .nxdc) or ESI, starting at 1
    #[arg(long, value_name = "NUMBER")]
    pub device: Option<std::num::NonZeroUsize>,
    /// Variant of a `device.toml` [default: the device without variants]
    #[arg(long, value_name = "NAME")]
    pub variant: Option<String>,
    /// Input encoding if it cannot be detected: utf-8, windows-1252, cp850, utf-16le …
    #[arg(long, value_name = "ENCODING")]
    pub encoding: Option<Encoding>,
    #[command(flatten)]
    pub entries: EntriesArgs,
    #[command(flatten)]
    pub size: SizeArgs,
    #[command(flatten)]
    pub patch: PatchArgs,
}

// How large a device may become. What only looks at the text of a file does without.
#[derive(Debug, Args)]
#[command(next_help_heading = "Input")]
pub(super) struct EntriesArgs {
    /// Maximum number of entries in compact storage; other limits grow with it (docs/reference/limits.md) [default: 25000]
    #[arg(long, value_name = "NUMBER", default_value_t = DEFAULT_MAX_ENTRIES, hide_default_value = true)]
    pub max_entries: usize,
}

// How much of a file is read.
#[derive(Debug, Args)]
#[command(next_help_heading = "Input")]
pub(super) struct SizeArgs {
    /// Maximum file size, in bytes or with K, M or G [default: 64M]
    #[arg(long, value_name = "SIZE", default_value_t = DEFAULT_MAX_SIZE, hide_default_value = true, value_parser = parse_size)]
    pub max_size: u64,
}

/// What a file is that is to be checked.
pub(super) enum CheckedInput {
    /// A description with its text.
    Description(Box<Description>),
    /// Something else: what it is called, and why it cannot be checked.
    Foreign(String, Failure),
}

impl InputArgs {
    /// How a file is read.
    pub(super) fn reading(&self) -> Reading {
        let (from, device, variant, encoding) = (self.from, self.device, self.variant.clone(), self.encoding);
        let (max_size, max_entries) = (self.size.max_size, self.entries.max_entries);
        let patches = self.patch.patches.clone();
        Reading { from, device, variant, encoding, max_size, max_entries, patches, ..reading() }
    }

    /// How a file is read that has further patches.
    pub(super) fn reading_with(&self, patches: &[Arc<Patch>]) -> Reading {
        let mut reading = self.reading();
        reading.patches.extend_from_slice(patches);
        reading
    }

    /// How much of a text of so many bytes a conversion may lose or embed.
    pub(super) fn max_losses(&self, bytes: usize) -> usize {
        WriteOptions::max_losses_of(bytes, self.entries.max_entries)
    }

    /// What is in a file, and as what kind it was read; `-` is standard input. Of several devices it is the one that was asked for.
    /// It has the patches of its configuration, as for `objdict check`.
    pub(super) fn read_one(
        &self,
        path: &Path,
        config: &ConfigFileArgs,
    ) -> Result<(FileKind, Input), Failure> {
        self.read_as(path, config, false)
    }

    /// As [`read_one`](Self::read_one); a device that is no CANopen node is refused.
    pub(super) fn read_node(
        &self,
        path: &Path,
        config: &ConfigFileArgs,
    ) -> Result<(FileKind, Input), Failure> {
        self.read_as(path, config, true)
    }

    fn read_as(
        &self,
        path: &Path,
        config: &ConfigFileArgs,
        is_node: bool,
    ) -> Result<(FileKind, Input), Failure> {
        let bytes = self.size.read(path)?;
        let reading = Reading { is_node, ..self.reading_with(&config.patches_of(path)?) };
        Ok(reading.read_one(&source_name(path), bytes)?)
    }

    /// The device of a file that was asked for: the only one, or the one of a number.
    pub(super) fn selected(&self, path: &Path, description: Description) -> Result<Description, Failure> {
        Ok(self.reading().select(&source_name(path), description)?)
    }

    /// A file with these bytes, which is to be checked.
    pub(super) fn candidate(
        &self,
        path: &Path,
        bytes: Vec<u8>,
        patches: &[Arc<Patch>],
    ) -> Result<CheckedInput, Failure> {
        let name = source_name(path);
        let reading = self.reading_with(patches);
        let (kind, source) = match reading.recognised(&name, bytes) {
            Ok(recognised) => recognised,
            // what is called a description and shows nothing of one is no other file that happens to be there
            Err(ReadError::Foreign { name, found }) if found.kind != ContentKind::Unknown => {
                let other = found.technology.as_ref().filter(|name| *name != "CANopen");
                let technology = other.map(|name| format!(" ({name})"));
                let called = format!("{}{}", found.kind.name(), technology.unwrap_or_default());
                return Ok(CheckedInput::Foreign(called, ReadError::Foreign { name, found }.into()));
            }
            Err(error) => return Err(error.into()),
        };
        match kind.format() {
            Some(format) => Ok(CheckedInput::Description(Box::new(reading.described(source, format)?))),
            None => {
                let message = format!(
                    "only EDS, DCF, XDD and XDC can be checked, but `{name}` is read as {}",
                    kind.name()
                );
                let help = format!("`objdict show {name}` prints its contents");
                Ok(CheckedInput::Foreign(kind.name().to_owned(), Failure::new(message).help(help)))
            }
        }
    }
}

impl SizeArgs {
    /// The same, with a line for `--verbose`; not for files that are read in parallel.
    pub(super) fn read(&self, path: &Path) -> Result<Vec<u8>, Failure> {
        detail(&source_name(path));
        self.bytes(path)
    }

    /// The bytes of a file as they are.
    pub(super) fn bytes(&self, path: &Path) -> Result<Vec<u8>, Failure> {
        if path == Path::new("-") {
            keep(Path::new("/dev/stdin"));
            let bytes = source::read_stream(io::stdin().lock(), STDIN, self.max_size, Vec::new());
            return Ok(bytes.map_err(ReadError::from)?);
        }
        keep(path);
        let bytes = match path.metadata() {
            // one that is named may be a pipe, as in `objdict check <(unzip -p device.zip)`
            Ok(found) if !found.is_file() && !found.is_dir() => File::open(path)
                .map_err(|error| SourceError::Io { path: source_name(path), error })
                .and_then(|file| source::read_stream(file, &source_name(path), self.max_size, Vec::new())),
            _ => source::read(path, self.max_size),
        };
        Ok(bytes.map_err(ReadError::from)?)
    }
}

// What is added to the device that a file describes.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Input")]
pub(super) struct ExpandArgs {
    /// Add the PDO objects implied by CompactPDO, up to NrOfRXPDO and NrOfTXPDO
    #[arg(long)]
    pub implicit_pdos: bool,
}

impl ExpandArgs {
    /// The device with what was asked for.
    pub(super) fn device<'a>(&self, device: &'a Device) -> Cow<'a, Device> {
        if self.implicit_pdos { device.with_implicit_pdos() } else { Cow::Borrowed(device) }
    }
}

/// What the source of a file is called, as it is: in JSON, and where the name decides.
pub(super) fn source_name(path: &Path) -> String {
    if path == Path::new("-") { STDIN.to_owned() } else { source::shown(path) }
}

/// A path as it is printed.
pub(super) fn name_of(path: &Path) -> String {
    one_line(&source_name(path))
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        let help = match &error {
            ReadError::Source(SourceError::TooLarge { .. }) => {
                Some("increase the limit with `--max-size`".to_owned())
            }
            ReadError::TooManyEntries { .. } | ReadError::TooManyParts { .. } => {
                Some("increase the limit with `--max-entries`".to_owned())
            }
            ReadError::Foreign { found, .. } if found.kind == ContentKind::Unknown => {
                Some("read it nevertheless by naming its format with `--from`".to_owned())
            }
            ReadError::SeveralDevices { .. } => Some("choose one with `--device`, counted from 1".to_owned()),
            error => error.help(),
        };
        match &error {
            // there may be several mistakes in it
            ReadError::NotPatched { .. } | ReadError::Faulty { .. } => {
                Self::of_lines(error.to_string().lines()).maybe_help(help)
            }
            ReadError::Content { name, error } => {
                let text = format!("cannot read `{}`: {error}", one_line(name));
                Self::of_lines(text.lines()).maybe_help(help)
            }
            _ => Self::new(&error).maybe_help(help),
        }
    }
}

impl From<EditError> for Failure {
    fn from(error: EditError) -> Self {
        let help = matches!(error, EditError::TooMuchLost { .. })
            .then(|| "increase the limit with `--max-entries`".to_owned());
        Self::new(&error).maybe_help(help)
    }
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
}
