//! How an EDS or DCF is written.

use super::values::one_of;
use objdict_format::{Dialect, WriteOptions};
use objdict_model::diagnostic::{Tool, series};
use objdict_model::literal::RealSpelling;
use objdict_model::source::Encoding;

// Who reads what is written.
#[derive(Clone, Debug, Default, clap::Args)]
pub(super) struct DialectArgs {
    /// Dialect of EDS and DCF output: cia306 (default), lely, python-canopen, canopeneditor, codesys, or portable for several tools
    /// (docs/reference/canonical.md)
    #[arg(long, value_name = "DIALECT", value_parser = dialect)]
    pub dialect: Option<Dialect>,
}

fn dialect(name: &str) -> Result<Dialect, String> {
    let found = Dialect::ALL.into_iter().find(|dialect| dialect.name().eq_ignore_ascii_case(name));
    found.ok_or_else(|| format!("the dialects are {}", series(Dialect::ALL.map(Dialect::name))))
}

impl DialectArgs {
    /// The tools that read what is written.
    pub(super) fn tools(&self) -> &'static [Tool] {
        self.dialect.map_or(&[], Dialect::tools)
    }

    /// Whether it is written for another reader than any of CiA 306.
    pub(super) fn is_other(&self) -> bool {
        self.dialect.is_some_and(|dialect| dialect != Dialect::Cia306)
    }

    /// How it is written.
    pub(super) fn options(&self) -> WriteOptions {
        self.dialect.unwrap_or_default().into()
    }
}

// How an EDS or DCF is written that is no edit of a text.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Canonical EDS and DCF")]
pub(super) struct CanonicalArgs {
    /// Rewrite an EDS or DCF from scratch instead of editing its text, in the order and spelling that most tools read
    #[arg(long)]
    pub canonical: bool,
    #[command(flatten)]
    pub dialect: DialectArgs,
    /// Spelling of REAL numbers; implies --canonical
    #[arg(long, value_parser = one_of(&REALS), value_name = "SPELLING")]
    pub real: Option<RealSpelling>,
    /// Quote strings, as Lely's tools require; implies --canonical
    #[arg(long)]
    pub quote_strings: bool,
    /// Keep compact storage (CompactSubObj), which many tools do not support; implies --canonical
    #[arg(long)]
    pub compact: bool,
    /// Output encoding; implies --canonical [default: ISO 646, as CiA 306 requires, with `ü` written as `ue`]
    #[arg(long, value_name = "ENCODING")]
    pub output_encoding: Option<Encoding>,
}

/// The spellings of REAL numbers.
const REALS: [(RealSpelling, &str, &str); 2] = [
    (RealSpelling::Decimal, "decimal", "Decimal numbers"),
    (RealSpelling::Hex, "bits", "Hex digits of their bits, as Lely's tools read them"),
];

impl CanonicalArgs {
    /// Whether a new text is wanted although there is one to edit.
    pub(super) fn is_asked(&self) -> bool {
        self.canonical
            || self.dialect.is_other()
            || self.real.is_some()
            || self.quote_strings
            || self.compact
            || self.output_encoding.is_some()
    }

    /// How the text is written; an encoding that was said for reading holds for writing too.
    pub(super) fn options(&self, read_in: Option<Encoding>) -> WriteOptions {
        let mut options = self.dialect.options();
        if let Some(real) = self.real {
            options.eds.real = real;
        }
        options.eds.quote_strings |= self.quote_strings;
        options.eds.compact = self.compact;
        options.eds.encoding = self.output_encoding.or(read_in);
        options
    }
}
