//! The configuration `objdict.toml`: a project's settings for all its descriptions
//! (docs/reference/config.md).
//!
//! Errors in it are findings with spans, as in a description; an invalid setting is ignored, and the others
//! apply.
//!
//! ```
//! # mod objdict { pub use objdict_lint as lint; pub use objdict_model::source; pub use objdict_project::config; }
//! use objdict::config::Config;
//! use objdict::lint::Severities;
//! use objdict::source::SourceFile;
//!
//! let text = "node-id = 5\n[rules]\n\"cia306/file-nam\" = \"off\"\ncia301 = \"note\"\n";
//! let config = Config::read(SourceFile::from_text("objdict.toml", text), "/project");
//! let finding = config.findings().iter().next().expect("there is no such rule");
//! assert_eq!(finding.help.as_ref().map(|help| help.to_string()).as_deref(), Some("did you mean `cia306/file-name`?"));
//!
//! let options = config.options("/project/devices/door.eds", &Severities::default());
//! assert_eq!(options.node_id, Some(5));
//! ```

mod configuration;
#[cfg(feature = "full")]
mod patches;
mod path;
mod project;
mod read;
mod settings;

pub use self::configuration::Config;
pub use self::project::Project;
#[cfg(feature = "full")]
pub use self::read::SETTINGS;
pub use self::settings::{WantedFiles, WantedProfile};
