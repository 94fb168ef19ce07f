//! Code and data for products, generated from a [`Device`]: tables in Rust and C, concise DCF.
//!
//! A *target* has a name such as `rust`; its backend converts a device to files. Backends depend on the
//! model and not on the input format. To add one, write a folder next to this file and declare it in the
//! registry below.
//!
//! ```
//! use objdict_generate::{generate, Options, Target};
//! # use objdict_model::model::{Access, DataType, Device, Entry, Object, Value};
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
//! # Ok::<(), objdict_generate::GenerateError>(())
//! ```

// no feature combination uses all shared code
#![cfg_attr(
    not(all(feature = "rust", feature = "c", feature = "stacks", feature = "template")),
    allow(dead_code, unused_macros)
)]

/// A statement of an expanded template.
macro_rules! put {
    ($out:ident, $($text:tt)+) => {
        let _ = std::fmt::Write::write_fmt(&mut $out, format_args!($($text)+)); // writing to a String cannot fail
    };
}

#[cfg(feature = "c")]
mod c;
mod c_code;
#[cfg(feature = "canopennode")]
mod c_words;
#[cfg(feature = "stacks")]
mod canfestival;
#[cfg(feature = "stacks")]
mod canopen_rs;
#[cfg(feature = "stacks")]
mod canopen_stack;
#[cfg(feature = "canopennode")]
mod canopennode;
#[cfg(feature = "stacks")]
mod canopennode_v1;
#[cfg(feature = "stacks")]
mod concise;
mod defaults;
mod dictionary;
mod escape;
mod existing;
mod frames;
mod gaps;
mod head;
mod hooks;
#[cfg(feature = "stacks")]
mod lely;
mod live;
mod meanings;
mod memory;
#[cfg(feature = "stacks")]
mod microcanopen;
mod names;
mod notes;
#[cfg(feature = "stacks")]
mod objdict_macros;
mod options;
mod renames;
mod resolve;
#[cfg(feature = "rust")]
mod rust;
mod size;
#[cfg(feature = "canopennode")]
mod startup;
mod stored;
mod table;
mod table_build;
mod table_size;
#[cfg(feature = "template")]
mod template;
mod unserved;
mod variables;
#[cfg(feature = "stacks")]
mod zencan;

use std::borrow::Cow;
use std::fmt;

pub use existing::{TableAspect, TableDifference, compare_tables};
pub use live::{LiveEntry, live_entries};
pub use options::{
    CTable, Choice, Derive, Names, OptionField, OptionValue, Options, PdoMappings, SharedCell, StackLayout,
    StorageGroup,
};
pub use renames::ChoiceError;
#[cfg(feature = "toml")]
pub use renames::renames;
pub use size::{ObjectSize, Size, SizeReport, Sizes};
pub use unserved::{UNSERVED, Unserved};

use objdict_model::{diagnostic, literal, model};

use crate::diagnostic::{Severity, counted};
use crate::model::{Device, Place};

macro_rules! make {
    ($module:ident) => {
        Make::Measured($module::make)
    };
    ($module:ident $why:literal) => {
        Make::Unmeasured($module::make, $why)
    };
}

/// All targets in the order of help: the name of the [`Target`] constant, the module, the name on the command line, the
/// summary (lower case, no full stop), the options that affect the files, and the reason if the size of its tables is
/// unknown. The module has the function `make`.
macro_rules! targets {
    ($($(#[$condition:meta])? $constant:ident $module:ident $name:literal
        $summary:literal
        [$($choice:ident)*]
        $(unmeasured $why:literal)?
        $(compared $compare:ident)?;
    )+) => {
        static BACKENDS: &[&Backend] = &[$($(#[$condition])? Target::$constant.0),+];

        impl Target {
            $($(#[$condition])?
            #[doc = concat!("The target `", $name, "`: ", $summary, ".")]
            pub const $constant: Self = Self(&Backend {
                name: $name,
                summary: $summary,
                uses: &[$(Choice::$choice),*],
                make: make!($module $($why)?),
                compare: [$($module::$compare as Compare)?].first().copied(),
            });)+
        }
    };
}

targets! {
    #[cfg(feature = "rust")]
    RUST rust "rust"
        "one Rust file (no_std, no unsafe, no dependencies): dictionary, values, SDO access by index and sub-index"
        [Names Renamed Module Groups Hooks StringCapacity DomainCapacity EntryNames FeatureGates Derives Runtime Cell];
    #[cfg(feature = "c")]
    C c "c"
        "`od.h` and `od.c` in C99 (no malloc): dictionary, values, SDO access by index and sub-index"
        [Names Renamed Prefix Groups Hooks StringCapacity DomainCapacity Table EntryNames PdoMappings];
    #[cfg(feature = "stacks")]
    CONCISE concise "concise"
        "one concise DCF (.cdcf): the SDO downloads that configure a node with default values"
        []
        unmeasured "a concise DCF is not part of the firmware, but data for a manager";
    #[cfg(feature = "stacks")]
    CANOPEN_RS canopen_rs "canopen-rs"
        "one Rust file for the crate canopen-rs 0.6: a function that creates the ObjectDictionary for a node-ID"
        [Names Renamed Module]
        unmeasured "the crate canopen-rs builds the tables while the firmware runs";
    #[cfg(feature = "stacks")]
    CANOPEN_STACK canopen_stack "canopen-stack"
        "`CO_OBJ` table for canopen-stack 4.4 (embedded-office), its values and a node specification"
        [Names Renamed Prefix Groups Hooks StringCapacity DomainCapacity]
        compared compare;
    #[cfg(feature = "stacks")]
    ZENCAN zencan "zencan"
        "one device configuration (.toml) for the crate zencan-build 0.0.5"
        [Names Renamed Groups StringCapacity]
        unmeasured "the crate zencan-build generates the tables from the file";
    #[cfg(feature = "canopennode")]
    CANOPENNODE canopennode "canopennode"
        "`OD.h` and `OD.c` for CANopenNode 4"
        [Names Renamed Prefix Groups StringCapacity Hooks Limits Layout]
        compared compare;
    #[cfg(feature = "template")]
    TEMPLATE template "template"
        "one file rendered from a custom Jinja template (`--template`)"
        [Template Names Renamed StringCapacity DomainCapacity]
        unmeasured "the template decides what the file contains";
    #[cfg(feature = "stacks")]
    MICROCANOPEN microcanopen "microcanopen"
        "tables for MicroCANopen: SDO replies, process image, calls that initialise PDOs"
        [Names Renamed Prefix StringCapacity];
    #[cfg(feature = "stacks")]
    OBJDICT_MACROS objdict_macros "objdict-macros"
        "`objdict.c` and `mapping.c` with the macros from the embedded CANopen book (SINGLE_OBJ, MAP_ENTRY)"
        [Names Renamed Prefix StringCapacity DomainCapacity];
    #[cfg(feature = "stacks")]
    LELY lely "lely"
        "static device (`co_sdev`) for Lely core 2.4"
        [Prefix Hooks EntryNames]
        unmeasured "the library copies the table, and its configuration decides what a row contains";
    #[cfg(feature = "stacks")]
    CANFESTIVAL canfestival "canfestival"
        "dictionary for CanFestival 3, in the layout of objdictgen"
        [Names Renamed Prefix Groups Hooks StringCapacity DomainCapacity]
        compared compare;
    #[cfg(feature = "stacks")]
    CANOPENNODE_V1 canopennode_v1 "canopennode-v1"
        "`CO_OD.h` and `CO_OD.c` for CANopenNode 1.3"
        [Names Renamed Groups Hooks StringCapacity DomainCapacity Layout]
        compared compare;
}

/// Maximum size of a string, octet string or DOMAIN value in a table, in bytes.
pub const LONGEST_VALUE: usize = u16::MAX as usize;

/// A target as declared.
struct Backend {
    name: &'static str,
    summary: &'static str,
    /// The options that affect the files.
    uses: &'static [Choice],
    make: Make,
    /// The comparison of existing tables with generated ones.
    compare: Option<Compare>,
}

/// Compares a header and its source with files; `None` if they are not tables of the target.
type Compare = fn(&str, &str, &[OutputFile]) -> Option<Vec<TableDifference>>;

/// The function of a target.
enum Make {
    Measured(fn(&Device, &Options) -> Result<BackendOutput, GenerateError>),
    /// With the reason why the size of its tables is unknown.
    Unmeasured(fn(&Device, &Options) -> Result<Generated, GenerateError>, &'static str),
}

/// The output of a backend for a device, and the size of its tables.
struct BackendOutput {
    files: Vec<OutputFile>,
    /// Content that the files cannot express.
    notes: Vec<Note>,
    size: Sizes,
}

/// A target of the registry.
#[derive(Clone, Copy)]
pub struct Target(&'static Backend);

impl Target {
    /// All targets.
    pub fn all() -> impl Iterator<Item = Self> {
        BACKENDS.iter().map(|&backend| Self(backend))
    }

    /// Looks up a target by name.
    ///
    /// # Errors
    /// [`GenerateError::UnknownTarget`] for an unknown name.
    pub fn named(name: &str) -> Result<Self, GenerateError> {
        Self::all()
            .find(|target| target.name() == name)
            .ok_or_else(|| GenerateError::UnknownTarget { name: name.to_owned() })
    }

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// A one-line summary.
    pub fn summary(self) -> &'static str {
        self.0.summary
    }
}

impl fmt::Debug for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Target({})", self.name())
    }
}

/// One file of the output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// The path relative to the output folder, with `/` as separator.
    pub path: String,
    /// Its content.
    pub contents: Vec<u8>,
}

/// The output of a backend.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Generated {
    /// The files, in the order of the backend.
    pub files: Vec<OutputFile>,
    /// Omissions and assumptions, in ascending order of places.
    pub notes: Vec<Note>,
}

/// A part of the description that a target cannot express.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Its place.
    pub place: Place,
    /// The deviation: lower case, offending text in backticks, no full stop.
    pub message: String,
    /// How to fix it.
    pub help: Option<Cow<'static, str>>,
    /// Further places of this note in ascending order; the message states their number.
    pub also: Vec<Place>,
    /// The severity: an error means that the stack does not start with the files, a warning that they do not work unchanged, a note
    /// that something is omitted.
    pub severity: Severity,
}

impl Note {
    /// Creates a note without help.
    pub fn new(place: impl Into<Place>, message: impl Into<String>) -> Self {
        Self {
            place: place.into(),
            message: message.into(),
            help: None,
            also: Vec::new(),
            severity: Severity::Note,
        }
    }

    /// Adds help.
    pub fn help(mut self, help: impl Into<Cow<'static, str>>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Raises the severity to a warning.
    pub(crate) fn warning(mut self) -> Self {
        self.severity = Severity::Warning;
        self
    }

    /// Raises it to an error: the stack does not start with the files.
    pub(crate) fn error(mut self) -> Self {
        self.severity = Severity::Error;
        self
    }

    /// All places of this note.
    pub fn places(&self) -> impl Iterator<Item = &Place> {
        std::iter::once(&self.place).chain(&self.also)
    }
}

objdict_model::messages! { Note: { Self { place, message, .. } => "{place}: {message}"; } }

/// The reason why nothing was generated.
#[derive(Debug)]
#[non_exhaustive]
pub enum GenerateError {
    /// There is no target with this name.
    UnknownTarget {
        /// The name.
        name: String,
    },
    /// The node-ID is not valid.
    NodeId {
        /// The value.
        node_id: u8,
    },
    /// The prefix is not a valid identifier.
    Identifier {
        /// The option name after `--` on the command line.
        option: &'static str,
        /// The text.
        text: String,
    },
    /// A prefix or module has the name of a standard module, file or header.
    Hides {
        /// The option name after `--` on the command line.
        option: &'static str,
        /// The name.
        word: String,
    },
    /// The device has no entry for which code can be generated.
    NoEntries {
        /// Why its entries cannot be used.
        notes: Vec<Note>,
    },
    /// Values that cannot be represented.
    Inexpressible(
        /// The places with the problems; at least one.
        Vec<Note>,
    ),
    /// Shared values were requested without the crate for them, or without their initial node-ID.
    NoCell,
    /// The target `template` was requested without a template.
    NoTemplate,
    /// A custom template cannot be read or rendered.
    UserTemplate {
        /// The template file.
        file: String,
        /// The line, counted from 1; `None` for the whole file.
        line: Option<usize>,
        /// The error.
        message: String,
    },
}

objdict_model::error_messages! { GenerateError: {
    Self::UnknownTarget { name } => "unknown target `{name}`; the targets are {}", known_targets();
    Self::NodeId { node_id } => "`{node_id}` is not a valid node-ID (1 to 127)";
    Self::Identifier { option, text } =>
        "`{text}` is not an identifier of at most 16 characters for `{option}`: use letters, digits and single `_`";
    Self::Hides { option, word } =>
        "`{word}` for `{option}` hides a standard module or header: choose a different name";
    Self::NoEntries { .. } => "the device has no entries";
    Self::Inexpressible(notes) => "{}", list(notes);
    Self::NoCell => "`--cell` needs `--runtime` and a node-ID (`--node-id N`)";
    Self::NoTemplate => "the target `template` needs a template (`--template FILE`)";
    Self::UserTemplate { file, line, message } =>
        "{file}{}: {message}", line.map(|line| format!(":{line}")).unwrap_or_default();
} }

fn known_targets() -> String {
    Target::all().map(|target| format!("`{}`", target.name())).collect::<Vec<_>>().join(", ")
}

fn list(notes: &[Note]) -> String {
    notes.iter().map(Note::to_string).collect::<Vec<_>>().join("\n")
}

/// Generates the files of `target` for `device`.
///
/// # Errors
/// If a value cannot be represented; see [`GenerateError`].
pub fn generate(device: &Device, target: Target, options: &Options) -> Result<Generated, GenerateError> {
    let mut generated = files_of(device, target, options)?;
    generated.notes.splice(0..0, general_notes(device, &[target], options));
    Ok(generated)
}

/// Generates the files of one target, without the notes that belong to no target.
pub fn files_of(device: &Device, target: Target, options: &Options) -> Result<Generated, GenerateError> {
    let (device, notes) = gaps::filled(device);
    let mut generated = match target.0.make {
        Make::Unmeasured(make, _) => make(&device, options)?,
        Make::Measured(make) => {
            let BackendOutput { files, notes, .. } = make(&device, options)?;
            Generated { files, notes }
        }
    };
    generated.notes.splice(0..0, notes);
    Ok(generated)
}

/// Notes that belong to no target: options without an effect on any of them, and PDOs that are only implied.
pub fn general_notes(device: &Device, targets: &[Target], options: &Options) -> Vec<Note> {
    let has_effect = |choice: &Choice| targets.iter().any(|target| target.0.uses.contains(choice));
    let without = options.chosen().filter(|choice| !has_effect(choice));
    let note = |choice: Choice| {
        Note::new(Place::device(), format!("the option `{}` has no effect on this target", choice.name()))
    };
    let implied = device.implicit_pdos().len();
    let implied = (implied > 0).then(|| {
        let (pdos, add) = (counted(implied, "PDO", "PDOs"), "`--implicit-pdos` adds the objects");
        Note::new(
            Place::device(),
            format!("`CompactPDO` implies {pdos} without objects, so no table has them; {add}"),
        )
    });
    without.map(note).chain(implied).collect()
}

/// The identifiers of an object or an entry in generated code.
#[cfg(all(feature = "c", feature = "rust"))]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identifier {
    /// The index.
    pub index: u16,
    /// The sub-index; `None` for the index of an object.
    pub sub: Option<u8>,
    /// The constant in Rust: `od::identity_object::VENDOR_ID`, `od::DEVICE_TYPE` for an object with one value.
    pub rust: String,
    /// The macro in C: `OD_IDENTITY_OBJECT_VENDOR_ID`.
    pub c: String,
}

/// The identifiers of objects and entries in the targets `rust` and `c`, without options that change them. An object
/// with a single value has only its index.
///
/// # Errors
/// Same as [`generate`].
#[cfg(all(feature = "c", feature = "rust"))]
pub fn identifiers(device: &Device) -> Result<Vec<Identifier>, GenerateError> {
    c::identifiers(&gaps::filled(device).0)
}

/// Computes the size of the tables of `target` in flash and RAM, without the code that uses them, or states
/// why it is unknown.
///
/// # Errors
/// Same as [`generate`].
pub fn size(device: &Device, target: Target, options: &Options) -> Result<Sizes, GenerateError> {
    match target.0.make {
        Make::Unmeasured(_, why) => Ok(Sizes::Unknown(why)),
        Make::Measured(make) => Ok(make(&gaps::filled(device).0, options)?.size),
    }
}

/// Renders a template to a file that ends with one line feed.
fn render(path: impl Into<String>, text: String) -> OutputFile {
    OutputFile { path: path.into(), contents: (text + "\n").into_bytes() } // templates drop the last line feed
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
        let expected = "unknown target `cobol`; the targets are `rust`, `c`";
        assert!(error.is_err_and(|error| error.starts_with(expected)));
    }
}
