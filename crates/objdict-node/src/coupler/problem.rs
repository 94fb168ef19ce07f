//! Why modules cannot be connected.

/// Why modules cannot be connected.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ModuleProblem {
    /// The description has no modules.
    NotModular,
    /// The coupler does not support a module with this number.
    Unknown {
        /// The requested number.
        number: u16,
        /// The supported numbers.
        known: Vec<u16>,
    },
    /// An object that the module adds already exists in the coupler.
    Taken {
        /// The module.
        number: u16,
        /// The object.
        index: u16,
    },
    /// Two modules describe the same fixed or shared object differently.
    Conflict {
        /// The modules.
        numbers: (u16, u16),
        /// The object.
        index: u16,
    },
    /// A module lists an object without describing it.
    NotDescribed {
        /// The module.
        number: u16,
        /// The object.
        index: u16,
    },
    /// An extension lacks the number of sub-indexes or the data type.
    Incomplete {
        /// The module.
        number: u16,
        /// The object.
        index: u16,
    },
    /// The extension continues at the next index, which is already in use.
    NoRoom {
        /// The module.
        number: u16,
        /// The extended object.
        index: u16,
        /// The index in use.
        next: u16,
    },
}

objdict_model::error_messages! { ModuleProblem: {
    Self::NotModular => "the description has no modules";
    Self::Unknown { number, known } => "unknown module `{number}`; the modules are {}", listed(known);
    Self::Taken { number, index } =>
        "module {number} adds the object `{index:04X}`, which the coupler already has";
    Self::Conflict { numbers: (first, second), index } =>
        "the modules {first} and {second} describe the object `{index:04X}` differently";
    Self::NotDescribed { number, index } =>
        "module {number} lists the object `{index:04X}` but does not describe it";
    Self::Incomplete { number, index } =>
        "the extension of `{index:04X}` by module {number} is incomplete: `Count` or `DataType` is missing";
    Self::NoRoom { number, index, next } =>
        "the extension of `{index:04X}` by module {number} continues in `{next:04X}`, which is another object";
} }

fn listed(numbers: &[u16]) -> String {
    numbers.iter().map(u16::to_string).collect::<Vec<_>>().join(", ")
}
