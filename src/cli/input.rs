//! The files that a command reads.

use std::io::Read;
use std::path::Path;

use clap::Args;

use super::Failure;
use crate::format::nodelist::is_node_list;
use crate::format::{self, Description, Format};
use crate::source::{DEFAULT_MAX_SIZE, Encoding, SourceFile, SourceOptions};

/// What reports call the standard input.
pub(super) const STDIN: &str = "<stdin>";

/// How files are read.
#[derive(Debug, Args)]
pub(super) struct InputArgs {
    /// The encoding of the files, where it cannot be found out: utf-8, windows-1252, cp850, utf-16le …
    #[arg(long, value_name = "ENCODING")]
    pub encoding: Option<Encoding>,
    /// The largest file that is read, in bytes or with K, M or G behind the number
    #[arg(long, value_name = "SIZE", default_value_t = DEFAULT_MAX_SIZE, hide_default_value = true, value_parser = parse_size)]
    pub max_size: u64,
}

impl InputArgs {
    /// The description in a file; `-` is the standard input.
    pub(super) fn open(&self, path: &Path) -> Result<Description, Failure> {
        let source = self.source(path)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if is_node_list(&name) {
            let path = path.display();
            let failure = Failure::new(format_args!("`{path}` is a node list, no description of a device"));
            return Err(failure.help(format!("`objdict show {path}` tells its nodes")));
        }
        Ok(format::read(source, Format::from_name(&name).unwrap_or(Format::Eds)))
    }

    /// The text of a file; `-` is the standard input.
    pub(super) fn source(&self, path: &Path) -> Result<SourceFile, Failure> {
        let options = self.options();
        if path == Path::new("-") {
            return self.stdin(&options);
        }
        if path.is_dir() {
            let path = path.display();
            let failure = Failure::new(format_args!("`{path}` is a directory"));
            return Err(failure.help(format!("name files, such as `{path}/*.eds`")));
        }
        SourceFile::open(path, &options).map_err(Failure::new)
    }

    fn options(&self) -> SourceOptions {
        SourceOptions { encoding: self.encoding, max_size: self.max_size }
    }

    fn stdin(&self, options: &SourceOptions) -> Result<SourceFile, Failure> {
        let mut bytes = Vec::new();
        let stdin = std::io::stdin().lock();
        stdin
            .take(self.max_size.saturating_add(1))
            .read_to_end(&mut bytes)
            .map_err(|error| Failure::new(format_args!("cannot read the standard input: {error}")))?;
        SourceFile::from_bytes(STDIN, bytes, options).map_err(Failure::new)
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
    use super::parse_size;

    #[test]
    fn sizes_have_units() {
        assert_eq!(parse_size("1000"), Ok(1000));
        assert_eq!(parse_size("64M"), Ok(64 << 20));
        assert_eq!(parse_size("2KiB"), Ok(2048));
        assert!(parse_size("99999999999G").is_err());
        assert!(parse_size("much").is_err());
    }
}
