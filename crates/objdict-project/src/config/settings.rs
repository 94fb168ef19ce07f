//! The settings of a configuration.

use super::path::PathPattern;
use objdict_lint::Level;
use objdict_model::diagnostic::{Selection, Severity, Tool};
use objdict_model::source::Span;

/// The valid settings of a configuration.
#[derive(Debug, Default)]
pub(super) struct Settings {
    pub(super) levels: Vec<(Selection, Level)>,
    pub(super) ignored: Vec<(PathPattern, Vec<Selection>)>,
    pub(super) excluded: Vec<PathPattern>,
    pub(super) profiles: Vec<WantedProfile>,
    pub(super) patches: Vec<WantedFiles>,
    pub(super) node_id: Option<u8>,
    pub(super) tools: Vec<Tool>,
    pub(super) deny: Option<Severity>,
}

/// A profile in a configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct WantedProfile {
    /// The number of the profile, or the path of a file.
    pub name: String,
    /// Its place.
    pub span: Span,
}

/// A file pattern in a configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct WantedFiles {
    /// The pattern, as of a shell.
    pub pattern: String,
    /// Its place.
    pub span: Span,
}
