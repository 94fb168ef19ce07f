//! What a product compiles or downloads, made from a [`Device`]: tables in Rust and C, concise DCF.
//!
//! A *target* is a name such as `rust`; the [`Backend`] behind it turns a device into files. Backends see the model and
//! nothing of the format that it came from. To add one, write a folder beside this file and a line in the registry
//! below.
//!
//! ```
//! use objdict::generate::{generate, Options, Target};
//! # use objdict::model::{Access, DataType, Device, Entry, Object, Value};
//! # let mut device = Device::default();
//! # let main = Entry {
//! #     name: "Producer heartbeat time".into(),
//! #     data_type: Some(DataType::UNSIGNED16),
//! #     access: Some(Access::Rw),
//! #     default: Some(Value::Unsigned(1000)),
//! #     ..Entry::default()
//! # };
//! # device.objects.insert(0x1017, Object { main, ..Object::default() });
//! let generated = generate(&device, Target::named("rust")?, &Options::default())?;
//! assert_eq!(generated.files[0].path, "od.rs");
//! # Ok::<(), objdict::generate::GenerateError>(())
//! ```

mod c;
mod concise;
mod dictionary;
mod escape;
mod names;
mod notes;
mod resolve;
mod rom;
mod rust;
mod table;

use std::borrow::Cow;
use std::fmt;

use crate::model::{Device, Place};

/// Every backend, one line each, in the order in which help lists them.
static BACKENDS: &[&dyn Backend] = &[&rust::Rust, &c::C, &concise::Concise];

/// The largest value of a string, octet string or DOMAIN in bytes that a table can hold.
pub const LONGEST_VALUE: usize = u16::MAX as usize;

/// Turns a device into files for one purpose.
pub trait Backend: Sync {
    /// The name of the target, as the command line takes it.
    fn name(&self) -> &'static str;

    /// What the target is, in a line: lower case, no full stop.
    fn summary(&self) -> &'static str;

    /// The files for `device`, and what they cannot express.
    ///
    /// # Errors
    /// When the device asks for something that would come out wrong, see [`GenerateError`].
    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError>;
}

/// A target of the registry.
#[derive(Clone, Copy)]
pub struct Target(&'static dyn Backend);

impl Target {
    /// All targets.
    pub fn all() -> impl Iterator<Item = Self> {
        BACKENDS.iter().map(|&backend| Self(backend))
    }

    /// The target of a name.
    ///
    /// # Errors
    /// [`GenerateError::UnknownTarget`] when there is none.
    pub fn named(name: &str) -> Result<Self, GenerateError> {
        Self::all()
            .find(|target| target.name() == name)
            .ok_or_else(|| GenerateError::UnknownTarget { name: name.to_owned() })
    }

    /// The name, as the command line takes it.
    pub fn name(self) -> &'static str {
        self.0.name()
    }

    /// What the target is, in a line.
    pub fn summary(self) -> &'static str {
        self.0.summary()
    }
}

impl fmt::Debug for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Target({})", self.name())
    }
}

/// What the user may decide.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Options {
    /// The node-ID, 1 to 127, of the node that is generated for. Formulas stay formulas all the same, the node-ID is only
    /// named as the default. `None`: the one of the description, where it is a DCF.
    pub node_id: Option<u8>,
    /// The stem of the output's name, for targets whose files have no fixed names (`rust` and `c` have: `od`).
    pub file_stem: String,
    /// Room in bytes, 1 to 65535, for a VISIBLE_STRING, OCTET_STRING or UNICODE_STRING that can be written and has a
    /// shorter default, or that has none.
    pub string_capacity: u16,
    /// Room in bytes for a DOMAIN; 0: only for the default, and none where there is no default, so that the application
    /// has to transfer the data itself.
    pub domain_capacity: u16,
}

impl Default for Options {
    fn default() -> Self {
        Self { node_id: None, file_stem: "od".to_owned(), string_capacity: 32, domain_capacity: 0 }
    }
}

impl Options {
    /// The node-ID of these options, else of the device.
    pub(crate) fn node_id_of(&self, device: &Device) -> Result<Option<u8>, GenerateError> {
        match self.node_id {
            Some(node_id) if !(1..=127).contains(&node_id) => Err(GenerateError::NodeId { node_id }),
            Some(node_id) => Ok(Some(node_id)),
            None => Ok(device.node_id()),
        }
    }
}

/// One file of the output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// The path below the output folder, with `/` between folders.
    pub path: String,
    /// What stands in it.
    pub contents: Vec<u8>,
}

/// The output of a backend.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Generated {
    /// The files, in the order of the backend.
    pub files: Vec<OutputFile>,
    /// What the files leave out or had to assume, in ascending order of places.
    pub notes: Vec<Note>,
}

/// Something of the description that a target cannot express.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Where it stands.
    pub place: Place,
    /// What happened to it: lower case, offending text in backticks, no full stop.
    pub message: String,
    /// What to do.
    pub help: Option<Cow<'static, str>>,
}

impl Note {
    /// A note without advice.
    pub(crate) fn new(place: impl Into<Place>, message: impl Into<String>) -> Self {
        Self { place: place.into(), message: message.into(), help: None }
    }

    /// With advice.
    pub(crate) fn help(mut self, help: impl Into<Cow<'static, str>>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}

/// Why nothing was generated.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GenerateError {
    /// No target has this name.
    #[error("`{name}` is no target; known are {}", known_targets())]
    UnknownTarget {
        /// The name.
        name: String,
    },
    /// The node-ID is none.
    #[error("`{node_id}` is no node-ID; node-IDs are 1 to 127")]
    NodeId {
        /// The number.
        node_id: u8,
    },
    /// The device has no entry that could be generated.
    #[error("the device has no entries")]
    NoEntries {
        /// Why the entries that it has could not be used.
        notes: Vec<Note>,
    },
    /// Values that would come out wrong.
    #[error("{}", list(.0))]
    Inexpressible(
        /// The places and what is wrong with them; at least one.
        Vec<Note>,
    ),
    /// A template could not be rendered, which is a defect of this crate.
    #[error("cannot render the template of `{file}`: {source}")]
    Template {
        /// The file that it is for.
        file: &'static str,
        /// What the template engine says.
        source: askama::Error,
    },
}

fn known_targets() -> String {
    Target::all().map(|target| format!("`{}`", target.name())).collect::<Vec<_>>().join(", ")
}

fn list(notes: &[Note]) -> String {
    notes.iter().map(Note::to_string).collect::<Vec<_>>().join("\n")
}

/// The files of `target` for `device`.
///
/// # Errors
/// When the device asks for something that would come out wrong, see [`GenerateError`].
pub fn generate(device: &Device, target: Target, options: &Options) -> Result<Generated, GenerateError> {
    target.0.generate(device, options)
}

/// A rendered template as a file, with one line feed at its end.
fn render(file: &'static str, template: &impl askama::Template) -> Result<OutputFile, GenerateError> {
    let mut text = template.render().map_err(|source| GenerateError::Template { file, source })?;
    text.push('\n'); // askama drops the last one of a template
    Ok(OutputFile { path: file.to_owned(), contents: text.into_bytes() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_found_by_name_and_no_name_repeats() {
        let names: Vec<&str> = Target::all().map(Target::name).collect();
        for name in &names {
            assert_eq!(Target::named(name).map(Target::name).ok(), Some(*name));
            assert_eq!(names.iter().filter(|other| *other == name).count(), 1, "{name}");
        }
        let error = Target::named("cobol").map(Target::name).map_err(|error| error.to_string());
        let expected = "`cobol` is no target; known are `rust`, `c`";
        assert!(error.is_err_and(|error| error.starts_with(expected)));
    }

    #[test]
    fn a_node_id_is_checked() {
        let device = Device::default();
        let options = |node_id| Options { node_id, ..Options::default() };
        assert_eq!(options(Some(127)).node_id_of(&device).ok(), Some(Some(127)));
        for node_id in [0, 128, 255] {
            let error = options(Some(node_id)).node_id_of(&device);
            assert!(matches!(error, Err(GenerateError::NodeId { .. })), "{node_id}");
        }
    }
}
