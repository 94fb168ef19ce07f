//! What the user may decide about generated code.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;
use std::path::PathBuf;

use super::GenerateError;
use crate::model::{Address, Device};

/// What the user may decide. Not every target has a use for every choice; [`super::generate`] tells of each that has none.
#[derive(Clone, Debug, PartialEq, Eq)]
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
    /// What identifiers are made of.
    pub names: Names,
    /// Names that identifiers are made of instead, for objects (`None`) and for their entries.
    pub renamed: BTreeMap<Address, String>,
    /// What stands before the identifiers of C and is the name of its files, instead of `od`: a letter, and up to 15 more
    /// letters, digits and `_`. The case is that of each identifier.
    pub prefix: Option<String>,
    /// The name of the Rust module and of its file, instead of `od`; the same letters.
    pub module: Option<String>,
    /// Storage groups that objects belong to, the last one that has the index; one that the description states comes first.
    pub groups: Vec<Group>,
    /// Objects (with all their entries) and entries whose hooks are called before a read and after a write.
    pub hooks: BTreeSet<Address>,
    /// Whether write functions keep `LowLimit` and `HighLimit`, for stacks that have no place for limits.
    pub limits: bool,
    /// The file of the template that the target `template` renders: its name ends in `.j2`, and what is before that is the
    /// name of the output.
    pub template: Option<PathBuf>,
    /// How the dictionary is laid out in plain C.
    pub table: CTable,
    /// Whether the table names its entries, for people who read it on the device; what has no room for names has none
    /// anyway.
    pub entry_names: bool,
    /// Whether optional parts of the Rust file (names, PDOs, limits) are there only with the Cargo features `od-names`, `od-pdo` and
    /// `od-limits` of the crate that takes it in.
    pub feature_gates: bool,
    /// The traits of other crates that the types of the Rust file derive.
    pub derives: Vec<Derive>,
    /// The hash of what the description was read from, for the head of each file; see [`crate::source::hash`].
    pub source_hash: Option<u64>,
}

/// What identifiers are made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Names {
    /// Of `ParameterName`.
    #[default]
    Words,
    /// Of index and sub-index: a better name in the description changes no line of the application.
    Index,
}

/// How the dictionary is laid out in plain C.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CTable {
    /// Short rows with offsets into RAM and flash, and functions that answer as an SDO server does.
    #[default]
    Compact,
    /// An array of structures with pointers to value, limits and default, for a stack of one's own.
    Structs,
}

/// Traits of another crate that generated Rust types derive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derive {
    /// `Format` of the crate `defmt`.
    Defmt,
    /// `Serialize` and `Deserialize` of the crate `serde`.
    Serde,
}

/// A storage group: objects whose values are kept together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The indexes that belong to it.
    pub objects: RangeInclusive<u16>,
    /// Its name, as the application writes it.
    pub name: String,
}

/// An option that a target may have no use for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// [`Options::names`].
    Names,
    /// [`Options::renamed`].
    Renamed,
    /// [`Options::prefix`].
    Prefix,
    /// [`Options::module`].
    Module,
    /// [`Options::groups`].
    Groups,
    /// [`Options::hooks`].
    Hooks,
    /// [`Options::template`].
    Template,
    /// [`Options::table`].
    Table,
    /// [`Options::entry_names`].
    EntryNames,
    /// [`Options::feature_gates`].
    FeatureGates,
    /// [`Options::derives`].
    Derives,
    /// [`Options::string_capacity`].
    StringCapacity,
    /// [`Options::domain_capacity`].
    DomainCapacity,
    /// [`Options::limits`].
    Limits,
}

impl Choice {
    /// The name, as the command line has it behind `--`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Names => "names",
            Self::Renamed => "rename",
            Self::Prefix => "prefix",
            Self::Module => "module",
            Self::Groups => "group",
            Self::Hooks => "hook",
            Self::Template => "template",
            Self::Table => "table",
            Self::EntryNames => "no-names",
            Self::FeatureGates => "feature-gates",
            Self::Derives => "derive",
            Self::StringCapacity => "string-capacity",
            Self::DomainCapacity => "domain-capacity",
            Self::Limits => "limits",
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            node_id: None,
            file_stem: "od".to_owned(),
            string_capacity: 32,
            domain_capacity: 0,
            names: Names::default(),
            renamed: BTreeMap::new(),
            prefix: None,
            module: None,
            groups: Vec::new(),
            hooks: BTreeSet::new(),
            limits: false,
            template: None,
            table: CTable::default(),
            entry_names: true,
            feature_gates: false,
            derives: Vec::new(),
            source_hash: None,
        }
    }
}

impl Options {
    /// The options that are not as they are by default.
    pub(super) fn chosen(&self) -> impl Iterator<Item = Choice> {
        let default = Self::default();
        let choices = [
            (Choice::Names, self.names != default.names),
            (Choice::Renamed, !self.renamed.is_empty()),
            (Choice::Prefix, self.prefix.is_some()),
            (Choice::Module, self.module.is_some()),
            (Choice::Groups, !self.groups.is_empty()),
            (Choice::Hooks, !self.hooks.is_empty()),
            (Choice::Template, self.template.is_some()),
            (Choice::Table, self.table != default.table),
            (Choice::EntryNames, self.entry_names != default.entry_names),
            (Choice::FeatureGates, self.feature_gates),
            (Choice::Derives, !self.derives.is_empty()),
            (Choice::StringCapacity, self.string_capacity != default.string_capacity),
            (Choice::DomainCapacity, self.domain_capacity != default.domain_capacity),
            (Choice::Limits, self.limits),
        ];
        choices.into_iter().filter_map(|(choice, is_made)| is_made.then_some(choice))
    }

    /// The node-ID of these options, else of the device.
    pub(crate) fn node_id_of(&self, device: &Device) -> Result<Option<u8>, GenerateError> {
        match self.node_id {
            Some(node_id) if !(1..=127).contains(&node_id) => Err(GenerateError::NodeId { node_id }),
            Some(node_id) => Ok(Some(node_id)),
            None => Ok(device.node_id()),
        }
    }

    /// What stands before the identifiers of C, in lower case.
    pub(crate) fn prefix_or(&self, default: &str) -> Result<String, GenerateError> {
        identifier(Choice::Prefix, self.prefix.as_deref().unwrap_or(default))
    }

    /// The name of the Rust module.
    pub(crate) fn module_or(&self, default: &str) -> Result<String, GenerateError> {
        identifier(Choice::Module, self.module.as_deref().unwrap_or(default))
    }

    /// What the identifiers of an object or entry are made of; empty: of index and sub-index.
    pub(crate) fn name_of<'a>(&'a self, at: Address, described: &'a str) -> Cow<'a, str> {
        match self.renamed.get(&at) {
            Some(name) => Cow::Borrowed(name),
            None if self.names == Names::Index => Cow::Borrowed(""),
            None => Cow::Borrowed(described),
        }
    }

    /// The storage group of an object that the options put it into.
    pub fn group_of(&self, index: u16) -> Option<&str> {
        let group = self.groups.iter().rev().find(|group| group.objects.contains(&index));
        group.map(|group| group.name.as_str())
    }

    /// Who made a file, and of what: the first line of each file, without a date and without a path.
    pub(crate) fn made_by(&self) -> String {
        let version = env!("CARGO_PKG_VERSION");
        match self.source_hash {
            Some(hash) => format!("Made by objdict {version} from the file with the hash {hash:016x}"),
            None => format!("Made by objdict {version}"),
        }
    }
}

/// The longest prefix: a name of 48 letters behind it still fits into an identifier.
const LONGEST_PREFIX: usize = 16;

fn identifier(choice: Choice, text: &str) -> Result<String, GenerateError> {
    let is_word = text.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let starts = text.starts_with(|c: char| c.is_ascii_alphabetic());
    if is_word && starts && text.len() <= LONGEST_PREFIX && !text.contains("__") && !text.ends_with('_') {
        return Ok(text.to_ascii_lowercase());
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
        for text in ["", "2nd", "a b", "ä", "a__b", "a_", "abcdefghijklmnopq"] {
            let error = options(text).prefix_or("od");
            assert!(matches!(error, Err(GenerateError::Identifier { option: "prefix", .. })), "{text}");
        }
    }

    #[test]
    fn the_last_group_that_has_an_index_counts() {
        let group = |objects, name: &str| Group { objects, name: name.to_owned() };
        let groups = vec![group(0x1000..=0x1FFF, "COMM"), group(0x1010..=0x1011, "RAM")];
        let options = Options { groups, ..Options::default() };
        assert_eq!(options.group_of(0x1011), Some("RAM"));
        assert_eq!(options.group_of(0x1012), Some("COMM"));
        assert_eq!(options.group_of(0x2000), None);
    }
}
