//! Options of generated code. Each option is declared once, in `with_options` below.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;
use std::path::PathBuf;

use super::GenerateError;
use crate::model::{Address, Device};

/// Passes the declarations of all options to a macro. Each becomes four things: a field of [`Options`] and a
/// [`Choice`] in this file, an argument of `objdict generate`, and a method of the build script's builder.
///
/// * The first paragraph is the text of `--help`; the others appear only in the documentation of the library.
/// * The name of its [`Choice`], and the name of the command-line option after `--`.
/// * `field`: the field in [`Options`], its type, and its default.
/// * `argument`: the type of the command-line value, which [`OptionField::put`] takes one by one (a `bool`
///   inverts the field), and the attributes for clap.
/// * `method`: the builder method, with the value that [`OptionField::put`] takes.
/// * `needs`: the feature of the package `objdict` required for the builder method.
#[doc(hidden)]
#[macro_export]
macro_rules! with_options {
    ($make:ident) => {
        $make! {
            /// Node-ID (`$NODEID` in formulas) [default: from the DCF]
            ///
            /// 1 to 127. Formulas are kept; the node-ID is only their default.
            NodeId "node-id" {
                field: node_id: Option<u8> = None,
                argument: Option<u8> [value_name = "N", value_parser = node_id],
                method: node_id(node_id: u8) => Ok(node_id),
            }
            /// Capacity of writable strings with a shorter default or none [default: 32]
            ///
            /// 1 to 65535 bytes for a VISIBLE_STRING, OCTET_STRING or UNICODE_STRING (default: 32).
            StringCapacity "string-capacity" {
                field: string_capacity: u16 = 32,
                argument: Option<u16> [help_heading = "Storage", value_name = "BYTES", value_parser = clap::value_parser!(u16).range(1..)],
                method: string_capacity(bytes: u16) => Ok(bytes),
            }
            /// Capacity of writable DOMAINs [default: size of the default value]
            ///
            /// In bytes. 0 reserves space only for the default value; without a default value the application has to provide the data.
            DomainCapacity "domain-capacity" {
                field: domain_capacity: u16 = 0,
                argument: Option<u16> [help_heading = "Storage", value_name = "BYTES"],
                method: domain_capacity(bytes: u16) => Ok(bytes),
            }
            /// Source of identifiers
            ///
            /// Default: [`Names::Words`].
            Names "names" {
                field: names: Names = Names::default(),
                argument: Option<Names> [help_heading = "Names", value_name = "SOURCE", value_parser = one_of::<Names>(), default_value = "words"],
                method: names(names: Names) => Ok(names),
            }
            /// File with new names for identifiers, in lines such as `"2000sub1" = "target speed"`
            ///
            /// The caller reads the file; `generate::renames` parses its text.
            Renamed "rename" {
                field: rename: Option<PathBuf> = None,
                argument: Option<PathBuf> [help_heading = "Names", value_name = "FILE"],
                method: rename(file: impl AsRef<Path>) => Ok(file.as_ref().to_owned()),
                needs: "lint",
            }
            /// Prefix of C identifiers and files [default: od]
            ///
            /// A letter, and up to 15 more letters, digits and `_`. Files have its case, each identifier its own.
            Prefix "prefix" {
                field: prefix: Option<String> = None,
                argument: Option<String> [help_heading = "Names", value_name = "WORD"],
                method: prefix(word: impl Into<String>) => Ok(word.into()),
            }
            /// Name of the Rust module and its file [default: od]
            ///
            /// Same syntax as a prefix.
            Module "module" {
                field: module: Option<String> = None,
                argument: Option<String> [help_heading = "Names", value_name = "WORD"],
                method: module(word: impl Into<String>) => Ok(word.into()),
            }
            /// Storage group of objects, such as `2000-2FFF=PERSIST_APP`; repeatable
            ///
            /// If several groups contain an index, the last one applies; a group stated in the description
            /// takes precedence. A name is a letter followed by letters, digits and `_`.
            Groups "group" {
                field: groups: Vec<StorageGroup> = Vec::new(),
                argument: Vec<StorageGroup> [help_heading = "Storage", value_name = "INDEXES=NAME"],
                method: group(objects: RangeInclusive<u16>, name: &str) => StorageGroup::new(objects, name),
            }
            /// Object or entry for which the application is called before reads and after writes, such as `6000` or `6000:1`; repeatable
            /// or comma-separated
            ///
            /// An object includes all its entries. In a build script `0x6000`, `(0x6000, 1)` or an `Address`.
            Hooks "hook" {
                field: hooks: BTreeSet<Address> = BTreeSet::new(),
                argument: Vec<Address> [help_heading = "Stacks", value_name = "ADDRESS", value_delimiter = ','],
                method: hook(at: impl Into<Address>) => Ok(at.into()),
            }
            /// Generate checks of `LowLimit` and `HighLimit` if the stack has none
            Limits "limits" {
                field: limits: bool = false,
                argument: bool [help_heading = "Stacks"],
                method: limits(keep: bool) => Ok(keep),
            }
            /// Template for the target `template`; the output has its name without `.j2`
            ///
            /// Requires the feature `template`.
            Template "template" {
                field: template: Option<PathBuf> = None,
                argument: Option<PathBuf> [help_heading = "Output", value_name = "FILE"],
                method: template(file: impl AsRef<Path>) => Ok(file.as_ref().to_owned()),
            }
            /// Table layout of the target `c`
            ///
            /// Default: [`CTable::Compact`].
            Table "table" {
                field: table: CTable = CTable::default(),
                argument: Option<CTable> [help_heading = "Size", value_name = "LAYOUT", value_parser = one_of::<CTable>(), default_value = "compact"],
                method: table(table: CTable) => Ok(table),
            }
            /// Write access to PDO mappings in the target `c`
            ///
            /// Default: [`PdoMappings::Fixed`]. An entry with a hook can be written with either.
            PdoMappings "pdo-mapping" {
                field: pdo_mappings: PdoMappings = PdoMappings::default(),
                argument: Option<PdoMappings> [help_heading = "Stacks", value_name = "KIND", value_parser = one_of::<PdoMappings>(), default_value = "fixed"],
                method: pdo_mappings(kind: PdoMappings) => Ok(kind),
            }
            /// Entries with storage in the target `canopennode`, and names in both CANopenNode targets
            ///
            /// Default: [`StackLayout::Complete`].
            Layout "layout" {
                field: layout: StackLayout = StackLayout::default(),
                argument: Option<StackLayout> [help_heading = "Storage", value_name = "LAYOUT", value_parser = one_of::<StackLayout>(), default_value = "complete"],
                method: layout(layout: StackLayout) => Ok(layout),
            }
            /// Omit entry names
            ///
            /// Names help to read the table on the device. Layouts without room for names ignore this option.
            EntryNames "no-names" {
                field: entry_names: bool = true,
                argument: bool [help_heading = "Size"],
                method: no_names() => Ok(false),
            }
            /// Gate names, PDOs and limits in Rust with the features `od-names`, `od-pdo` and `od-limits`
            ///
            /// These are features of the crate that includes the file.
            FeatureGates "feature-gates" {
                field: feature_gates: bool = false,
                argument: bool [help_heading = "Size"],
                method: feature_gates(gates: bool) => Ok(gates),
            }
            /// Use the crate `objdict-device` in Rust, so that SDOs can change PDO mappings
            ///
            /// The crate then contains the code of the table, and the values implement its `Dictionary`. Without it the file has no
            /// dependency, and mappings are read-only, because the structs of PDOs have the described mappings.
            Runtime "runtime" {
                field: runtime: bool = false,
                argument: bool [help_heading = "Stacks"],
                method: runtime(is_used: bool) => Ok(is_used),
            }
            /// Rust `static` with the values, for interrupts and the main program; requires `--runtime`
            ///
            /// The values start with the defaults of the node-ID, which must be known.
            Cell "cell" {
                field: cell: Option<SharedCell> = None,
                argument: Option<SharedCell> [help_heading = "Stacks", value_name = "KIND", value_parser = one_of::<SharedCell>(), requires = "runtime"],
                method: cell(kind: SharedCell) => Ok(kind),
            }
            /// Crate whose traits to derive for the Rust types; repeatable or comma-separated
            ///
            /// Can be called several times.
            Derives "derive" {
                field: derives: Vec<Derive> = Vec::new(),
                argument: Vec<Derive> [help_heading = "Stacks", value_name = "CRATE", value_parser = one_of::<Derive>(), value_delimiter = ','],
                method: derive(derive: Derive) => Ok(derive),
            }
        }
    };
}

macro_rules! declare {
    ($(
        $(#[doc = $doc:tt])+
        $choice:ident $name:literal {
            field: $field:ident: $type:ty = $default:expr,
            argument: $argument:ty [$($clap:tt)*],
            method: $method:ident($($parameter:ident: $of:ty),*) => $value:expr,
            $(needs: $feature:tt,)?
        }
    )+) => {
        /// User options of code generation. [`super::generate`] reports each option that the target ignores.
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub struct Options {
            $(
                $(#[doc = $doc])+
                pub $field: $type,
            )+
            /// Replacement names for objects (`None`) and entries, from which identifiers are derived.
            pub renamed: BTreeMap<Address, String>,
            /// The stem of output files for targets without fixed names (`rust` and `c` always use `od`).
            pub file_stem: String,
            /// The hash of the input for the header of each file; see `source::hash`.
            pub source_hash: Option<u64>,
        }

        impl Default for Options {
            fn default() -> Self {
                Self {
                    $($field: $default,)+
                    renamed: BTreeMap::new(),
                    file_stem: "od".to_owned(),
                    source_hash: None,
                }
            }
        }

        /// An option that a target may ignore.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Choice {
            $(
                #[doc = concat!("[`Options::", stringify!($field), "`].")]
                $choice,
            )+
        }

        impl Choice {
            /// The name on the command line after `--`.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$choice => $name,)+
                }
            }
        }

        impl Options {
            /// The options that differ from their defaults.
            pub(super) fn chosen(&self) -> impl Iterator<Item = Choice> {
                let default = Self::default();
                let choices = [$((Choice::$choice, self.$field != default.$field),)+];
                let is_chosen = |choice, is_changed| match choice {
                    Choice::NodeId => false, // used by every target
                    Choice::Renamed => is_changed || !self.renamed.is_empty(),
                    _ => is_changed,
                };
                choices.into_iter().filter_map(move |(choice, is_changed)| is_chosen(choice, is_changed).then_some(choice))
            }
        }
    };
}

with_options!(declare);

/// A field of [`Options`] that accepts values. A field for a single value keeps the last one.
pub trait OptionField {
    /// The type of a value.
    type Value;

    /// Stores a value.
    fn put(&mut self, value: Self::Value);
}

macro_rules! single_values {
    ($($type:ty)+) => {
        $(impl OptionField for $type {
            type Value = Self;

            fn put(&mut self, value: Self) {
                *self = value;
            }
        })+
    };
}

single_values!(bool u16 Names CTable PdoMappings StackLayout);

impl<T> OptionField for Option<T> {
    type Value = T;

    fn put(&mut self, value: T) {
        *self = Some(value);
    }
}

impl<T> OptionField for Vec<T> {
    type Value = T;

    fn put(&mut self, value: T) {
        self.push(value);
    }
}

impl<T: Ord> OptionField for BTreeSet<T> {
    type Value = T;

    fn put(&mut self, value: T) {
        self.insert(value);
    }
}

/// A choice between a few values.
pub trait OptionValue: Copy + Send + Sync + 'static {
    /// All values, each with its command-line name and its description.
    const ALL: &'static [(Self, &'static str, &'static str)];
}

/// Declares choices: each value with its name on the command line and its description there.
macro_rules! choices {
    ($(
        $(#[$of_type:meta])+
        $type:ident {
            $($(#[$of_value:meta])+ $value:ident $name:literal $description:literal)+
        }
    )+) => {$(
        $(#[$of_type])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $type {
            $($(#[$of_value])+ $value,)+
        }

        impl OptionValue for $type {
            const ALL: &'static [(Self, &'static str, &'static str)] =
                &[$((Self::$value, $name, $description)),+];
        }
    )+};
}

choices! {
    /// The source of identifiers.
    #[derive(Default)]
    Names {
        /// `ParameterName`.
        #[default]
        Words "words" "`ParameterName`"
        /// Index and sub-index: renaming an entry in the description does not affect the application.
        Index "index" "Index and sub-index"
    }

    /// The dictionary layout of the target `c`.
    #[derive(Default)]
    CTable {
        /// Short rows with offsets into RAM and flash, and functions that implement the answers of an SDO server.
        #[default]
        Compact "compact" "Short rows, with functions that respond like an SDO server"
        /// An array of structures with pointers to value, limits and default, for custom stacks.
        Structs "structs" "Array of structures with pointers, for custom stacks"
    }

    /// Whether SDOs can write PDO mappings.
    #[derive(Default)]
    PdoMappings {
        /// No: they are those of the description, as in the structs of PDOs.
        #[default]
        Fixed "fixed" "As in the description: SDOs cannot write them"
        /// As the description allows it; the application applies them, and the structs of PDOs keep those of the description.
        Dynamic "dynamic" "SDOs write them as described; the application applies them"
    }

    /// Which entries have storage in the table of the target `canopennode`, and under which names. In `canopennode-v1` only
    /// [`StackLayout::CanOpenEditor2020`] has an effect: the hex digits of macros are in lower case.
    #[derive(Default)]
    StackLayout {
        /// Every value that the stack has a type for.
        #[default]
        Complete "complete" "Every value for which the stack has a type"
        /// As CANopenEditor generates it, so that stored images of devices in the field still fit: only what has a default or a
        /// stated length has storage, and groups are those that the description states.
        CanOpenEditor "canopeneditor" "As in CANopenEditor: only entries with a default or a specified length"
        /// The same with the names that CANopenEditor made before July 2021: `cell_1_Temp` instead of `cell1Temp`. For CANopenNode 1.3
        /// those of libEDSsharp before November 2019: `OD_1a00_…` instead of `OD_1A00_…`.
        CanOpenEditor2020 "canopeneditor-2020" "The same, with CANopenEditor's names before July 2021: `cell_1_Temp`; canopennode-v1: `OD_1a00_…`"
    }

    /// What protects values that interrupts and the main program share.
    SharedCell {
        /// `Shared` of the crate `objdict-device`, with its feature `critical-section`.
        CriticalSection "critical-section" "`SHARED`, a `Shared<Data>` of `objdict-device` with its feature `critical-section`"
    }

    /// Traits of other crates derived for generated Rust types.
    Derive {
        /// `Format` of the crate `defmt`.
        Defmt "defmt" "`defmt::Format`"
        /// `Serialize` and `Deserialize` of the crate `serde`.
        Serde "serde" "`serde::Serialize` and `serde::Deserialize`"
    }
}

/// A storage group: objects with values stored together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StorageGroup {
    /// Its indexes.
    pub objects: RangeInclusive<u16>,
    /// Its name in the application.
    pub name: String,
}

impl Options {
    /// The node-ID of the options, else of the device.
    pub(crate) fn node_id_of(&self, device: &Device) -> Result<Option<u8>, GenerateError> {
        match self.node_id {
            Some(node_id) if !(1..=127).contains(&node_id) => Err(GenerateError::NodeId { node_id }),
            Some(node_id) => Ok(Some(node_id)),
            None => Ok(device.node_id()),
        }
    }

    /// The prefix of C identifiers in lower case.
    pub(crate) fn prefix_or(&self, default: &str) -> Result<String, GenerateError> {
        identifier(Choice::Prefix, self.prefix.as_deref().unwrap_or(default))
    }

    /// The name of the Rust module.
    pub(crate) fn module_or(&self, default: &str) -> Result<String, GenerateError> {
        identifier(Choice::Module, self.module.as_deref().unwrap_or(default))
    }

    /// The source of identifiers for an object or entry; empty to use index and sub-index.
    pub(crate) fn name_of<'a>(&'a self, at: Address, described: &'a str) -> Cow<'a, str> {
        match self.renamed.get(&at) {
            Some(name) => Cow::Borrowed(name),
            None if self.names == Names::Index => Cow::Borrowed(""),
            None => Cow::Borrowed(described),
        }
    }

    /// The storage group of an object according to the options.
    pub fn group_of(&self, index: u16) -> Option<&str> {
        let group = self.groups.iter().rev().find(|group| group.objects.contains(&index));
        group.map(|group| group.name.as_str())
    }

    /// Generator and source: the first line of each file, without date and path.
    pub(crate) fn made_by(&self) -> String {
        let version = env!("CARGO_PKG_VERSION");
        match self.source_hash {
            Some(hash) => format!("Made by objdict {version} from the file with the hash {hash:016x}"),
            None => format!("Made by objdict {version}"),
        }
    }
}

/// Maximum length of a prefix; leaves room for a name of 48 letters in an identifier.
const LONGEST_PREFIX: usize = 16;

/// Modules and files of Rust packages and headers of C, which a module or file with the same name would hide.
const FILES: &str = "
    self super crate build lib main mod core std alloc assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign
    stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
";

fn identifier(choice: Choice, text: &str) -> Result<String, GenerateError> {
    let is_word = text.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let starts = text.starts_with(|c: char| c.is_ascii_alphabetic());
    if is_word && starts && text.len() <= LONGEST_PREFIX && !text.contains("__") && !text.ends_with('_') {
        let word = text.to_ascii_lowercase();
        let hides = FILES.split_ascii_whitespace().any(|file| file == word);
        return if hides { Err(GenerateError::Hides { option: choice.name(), word }) } else { Ok(word) };
    }
    Err(GenerateError::Identifier { option: choice.name(), text: text.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn a_prefix_is_an_identifier() {
        let options = |prefix: &str| Options { prefix: Some(prefix.to_owned()), ..Options::default() };
        assert_eq!(options("Motor_2").prefix_or("od").ok().as_deref(), Some("motor_2"));
        for text in ["self", "mod", "stdint", "String", "assert"] {
            let error = options(text).prefix_or("od");
            assert!(matches!(error, Err(GenerateError::Hides { option: "prefix", .. })), "{text}");
        }
        for text in ["", "2nd", "a b", "ä", "a__b", "a_", "abcdefghijklmnopq"] {
            let error = options(text).prefix_or("od");
            assert!(matches!(error, Err(GenerateError::Identifier { option: "prefix", .. })), "{text}");
        }
    }

    #[test]
    fn the_last_group_that_has_an_index_counts() {
        let group = |objects, name: &str| StorageGroup { objects, name: name.to_owned() };
        let groups = vec![group(0x1000..=0x1FFF, "COMM"), group(0x1010..=0x1011, "RAM")];
        let options = Options { groups, ..Options::default() };
        assert_eq!(options.group_of(0x1011), Some("RAM"));
        assert_eq!(options.group_of(0x1012), Some("COMM"));
        assert_eq!(options.group_of(0x2000), None);
    }
}
