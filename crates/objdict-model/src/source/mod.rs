//! From bytes to text and positions: the first stage of the pipeline.

mod edit;
mod encoding;
mod file_name;
mod folder;
mod hash;
mod line_index;
mod span;

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::OnceLock;

pub use edit::{EditError, Edits};
pub use encoding::{Encoding, Unencodable, UnknownEncoding, transliterate};
pub use file_name::{is_device_name, portable, unportable};
pub use folder::{Buffers, CONFIG_FILE, Folder, FolderError, absolute, is_file, with_buffers};
pub use hash::{Fnv, hash};
pub use line_index::{LineColumn, LineIndex};
pub use span::{Said, Span};

/// The default size limit of files: 64 MiB.
pub const DEFAULT_MAX_SIZE: u64 = 64 << 20;

/// The maximum size of TOML files that users write (configuration, profiles, settings and names): 1 MiB. A TOML parser
/// needs up to 200 times the size of the text.
pub const MAX_TOML_SIZE: u64 = 1 << 20;

/// The hard size limit: decoding may triple the size, and a [`Span`] has four-byte offsets.
const HARD_LIMIT: u64 = 1 << 30;

/// The options for opening a file.
#[derive(Clone, Debug)]
pub struct SourceOptions {
    /// The encoding of the file; `None` detects it.
    pub encoding: Option<Encoding>,
    /// The maximum size in bytes. More than 1 GiB is never read.
    pub max_size: u64,
}

impl Default for SourceOptions {
    fn default() -> Self {
        Self { encoding: None, max_size: DEFAULT_MAX_SIZE }
    }
}

/// Why a file could not be opened.
#[derive(Debug)]
#[non_exhaustive]
pub enum SourceError {
    /// The operating system reported an error.
    Io {
        /// The file.
        path: String,
        /// The error of the operating system.
        error: io::Error,
    },
    /// The path is a directory.
    Directory {
        /// The directory.
        path: String,
    },
    /// The path is a pipe, a socket or a device, which need not end.
    Special {
        /// The path.
        path: String,
    },
    /// The file is larger than allowed.
    TooLarge {
        /// The file.
        path: String,
        /// Its size in bytes.
        size: u64,
        /// The limit in bytes.
        limit: u64,
    },
}

crate::error_messages! { SourceError: {
    Self::Io { path, error } => "cannot read `{path}`: {error}";
    Self::Directory { path } => "`{path}` is a directory";
    Self::Special { path } => "`{path}` is a pipe or a device, not a file";
    Self::TooLarge { path, size, limit } => "`{path}` has {size} bytes, more than the limit of {limit}";
} }

/// Reads the bytes of the file at `path`, at most `limit` and never more than 1 GiB, or of its
/// [buffer](with_buffers) if there is one. Pipes and devices are rejected before opening, because opening
/// one can block indefinitely.
///
/// # Errors
/// If the system cannot read the file, it is too large, or it is not a regular file.
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, SourceError> {
    let name = shown(path);
    let unreadable = |error| match path.is_dir() {
        true => SourceError::Directory { path: name.clone() },
        false => SourceError::Io { path: name.clone(), error },
    };
    let limit = limit.min(HARD_LIMIT);
    if let Some(bytes) = folder::buffered(path) {
        let size = bytes.len() as u64;
        return if size > limit { Err(SourceError::TooLarge { path: name, size, limit }) } else { Ok(bytes) };
    }
    let metadata = path.metadata().map_err(unreadable)?;
    if !metadata.is_file() && !metadata.is_dir() {
        return Err(SourceError::Special { path: name });
    }
    let file = File::open(path).map_err(unreadable)?;
    let size = metadata.len();
    if size > limit {
        return Err(SourceError::TooLarge { path: name, size, limit });
    }
    let mut bytes = Vec::new();
    bytes.reserve_exact(usize::try_from(size).unwrap_or_default());
    read_stream(file, &name, limit, bytes).map_err(|error| match error {
        SourceError::Io { error, .. } => unreadable(error),
        error => error,
    })
}

/// Reads a UTF-8 file of at most `limit` bytes.
///
/// # Errors
/// Like [`read`], and if it is not UTF-8.
pub fn read_text(path: &Path, limit: u64) -> Result<String, SourceError> {
    String::from_utf8(read(path, limit)?).map_err(|error| {
        let error = io::Error::new(io::ErrorKind::InvalidData, error.utf8_error());
        SourceError::Io { path: shown(path), error }
    })
}

/// A path for output: with the separators of the system, regardless of the input.
pub fn shown(path: &Path) -> String {
    let path = path.display().to_string();
    if cfg!(windows) { path.replace('/', "\\") } else { path }
}

/// Reads the rest of a stream after `bytes`, at most `limit`; `name` is its name in errors.
///
/// # Errors
/// Like [`read`].
pub fn read_stream(
    stream: impl Read,
    name: &str,
    limit: u64,
    mut bytes: Vec<u8>,
) -> Result<Vec<u8>, SourceError> {
    let limit = limit.min(HARD_LIMIT);
    let mut stream = stream.take(limit.saturating_add(1));
    stream.read_to_end(&mut bytes).map_err(|error| SourceError::Io { path: name.to_owned(), error })?;
    let size = bytes.len() as u64;
    if size > limit { Err(SourceError::TooLarge { path: name.to_owned(), size, limit }) } else { Ok(bytes) }
}

/// The text of a file with its name, its encoding and its line table.
#[derive(Debug)]
pub struct SourceFile {
    name: String,
    text: String,
    encoding: Encoding,
    /// The bytes of a file that cannot be restored from `text` and `encoding`.
    original: Option<Vec<u8>>,
    lines: OnceLock<LineIndex>,
}

impl SourceFile {
    /// Reads the file at `path`.
    ///
    /// # Errors
    /// If the system cannot read the file, or it is larger than `options.max_size`.
    pub fn open(path: &Path, options: &SourceOptions) -> Result<Self, SourceError> {
        Self::from_bytes(shown(path), read(path, options.max_size)?, options)
    }

    /// The same file with new bytes in the same encoding.
    ///
    /// # Errors
    /// If the bytes exceed the maximum file size.
    pub fn with_bytes(&self, bytes: Vec<u8>) -> Result<Self, SourceError> {
        let options = SourceOptions { encoding: Some(self.encoding()), max_size: u64::MAX };
        Self::from_bytes(self.name(), bytes, &options)
    }

    /// A source of the given bytes; `name` is its name in reports.
    ///
    /// # Errors
    /// If there are more bytes than `options.max_size`.
    pub fn from_bytes(
        name: impl Into<String>,
        bytes: Vec<u8>,
        options: &SourceOptions,
    ) -> Result<Self, SourceError> {
        let name = name.into();
        let limit = options.max_size.min(HARD_LIMIT);
        let size = bytes.len() as u64;
        if size > limit {
            return Err(SourceError::TooLarge { path: name, size, limit });
        }
        let encoding = options.encoding.unwrap_or_else(|| Encoding::detect(&bytes));
        if encoding == Encoding::Utf8 {
            return Ok(Self::from_utf8(name, bytes));
        }
        let text = encoding.decode(bytes.clone());
        let restored = encoding.encode(&text).is_ok_and(|again| again == bytes);
        let original = if restored { None } else { Some(bytes) };
        Ok(Self { name, text, encoding, original, lines: OnceLock::new() })
    }

    fn from_utf8(name: String, bytes: Vec<u8>) -> Self {
        let (text, original) = match String::from_utf8(bytes) {
            Ok(text) => (text, None),
            Err(error) => {
                let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
                (text, Some(error.into_bytes()))
            }
        };
        Self { name, text, encoding: Encoding::Utf8, original, lines: OnceLock::new() }
    }

    /// A source of a text in UTF-8.
    pub fn from_text(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            text: text.into(),
            encoding: Encoding::Utf8,
            original: None,
            lines: OnceLock::new(),
        }
    }

    /// A source with some lines of a text that is too long to keep, each with its number, from 1.
    pub fn from_lines<'l>(name: impl Into<String>, lines: impl IntoIterator<Item = (u64, &'l str)>) -> Self {
        let (mut text, mut numbers) = (String::new(), Vec::new());
        for (number, line) in lines {
            // a line end in the text would shift the numbers of the following lines
            text.extend(
                line.chars().map(|character| if matches!(character, '\n' | '\r') { ' ' } else { character }),
            );
            text.push('\n');
            numbers.push(u32::try_from(number).unwrap_or(u32::MAX));
        }
        let lines = OnceLock::from(LineIndex::with_numbers(&text, numbers));
        Self { lines, ..Self::from_text(name, text) }
    }

    /// The name of this source in reports: the path under which it was opened.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The decoded text, without byte order mark.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The encoding, detected or requested.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// Whether the text cannot be written back because decoding lost something, so that only the original
    /// bytes are safe.
    pub fn is_read_only(&self) -> bool {
        self.original.is_some()
    }

    /// The original bytes of the file.
    pub fn to_bytes(&self) -> Vec<u8> {
        match &self.original {
            Some(bytes) => bytes.clone(),
            None => self.encode(&self.text).unwrap_or_else(|_| self.text.clone().into_bytes()),
        }
    }

    /// The original bytes of the file, moved instead of copied if possible.
    pub fn into_bytes(self) -> Vec<u8> {
        match self {
            Self { original: Some(bytes), .. } => bytes,
            Self { encoding: Encoding::Utf8, text, .. } => text.into_bytes(),
            source => source.to_bytes(),
        }
    }

    /// The bytes of an edited `text` in the encoding of the file.
    ///
    /// # Errors
    /// If the text has a character that the encoding lacks.
    pub fn encode(&self, text: &str) -> Result<Vec<u8>, Unencodable> {
        self.encoding.encode(text)
    }

    /// The line table, created on first use.
    pub fn lines(&self) -> &LineIndex {
        self.lines.get_or_init(|| LineIndex::new(&self.text))
    }

    /// The line and column of a byte offset.
    pub fn line_column(&self, offset: u32) -> LineColumn {
        self.lines().line_column(&self.text, offset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_device_is_no_file() {
        let error = read(Path::new("/dev/zero"), DEFAULT_MAX_SIZE).unwrap_err();
        assert_eq!(error.to_string(), "`/dev/zero` is a pipe or a device, not a file");
    }

    #[test]
    fn bytes_that_decoding_damages_are_kept() {
        // an odd number of bytes after a UTF-16 mark
        let bytes = b"\xFF\xFE[\0A".to_vec();
        let source = SourceFile::from_bytes("x", bytes.clone(), &SourceOptions::default()).unwrap();
        assert!(source.is_read_only());
        assert_eq!(source.to_bytes(), bytes);
    }

    #[test]
    fn a_large_file_is_refused_by_name() {
        let options = SourceOptions { max_size: 3, ..SourceOptions::default() };
        let error = SourceFile::from_bytes("big.eds", b"1234".to_vec(), &options).unwrap_err();
        assert!(error.to_string().contains("`big.eds` has 4 bytes"), "{error}");
    }
}
