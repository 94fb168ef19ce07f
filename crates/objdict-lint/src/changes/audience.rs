//! The audiences of a change, and its effects on them.

use objdict_model::named;

use super::Side;
use crate::model::{Access, Entry, Object};

/// The title of an audience, for a text that is concatenated at compile time.
macro_rules! title {
    (Configurations) => {
        "stored configurations"
    };
    (PdoConsumers) => {
        "PDO consumers"
    };
    (SdoClients) => {
        "SDO clients"
    };
    (Firmware) => {
        "firmware source"
    };
    (StoredValues) => {
        "values in non-volatile memory"
    };
}
pub(super) use title;

named! {
    /// The rating of a change, for an audience or as a whole.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum ChangeVerdict {
        /// Existing use still works.
        Compatible = "compatible",
        /// Existing use may behave differently and must be reviewed.
        Risky = "risky",
        /// Existing use no longer works.
        Breaking = "breaking",
    }
}

named! {
    /// The users of a device, who can be affected by a change.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Audience {
        /// Stored configurations of nodes: DCF and concise DCF.
        Configurations = "configurations",
        /// Receivers and senders of the device's PDOs.
        PdoConsumers = "pdo-consumers",
        /// Programs that read and write entries.
        SdoClients = "sdo-clients",
        /// Sources that use the names of generated C and Rust.
        Firmware = "firmware",
        /// Values that devices in the field have stored.
        StoredValues = "stored-values",
    }
}

impl Audience {
    /// The audience as text.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Configurations => title!(Configurations),
            Self::PdoConsumers => title!(PdoConsumers),
            Self::SdoClients => title!(SdoClients),
            Self::Firmware => title!(Firmware),
            Self::StoredValues => title!(StoredValues),
        }
    }
}

/// A set of audiences.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Affected(u8);

impl Affected {
    pub(super) const ALL: Self = Self(u8::MAX);

    pub(super) const fn has(self, audience: Audience) -> bool {
        self.0 & (1 << audience as u8) != 0
    }

    /// The set, without an audience unless it is affected.
    pub(super) const fn without(self, audience: Audience, is_affected: bool) -> Self {
        if is_affected { self } else { Self(self.0 & !(1 << audience as u8)) }
    }

    pub(super) const fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The audiences of an entry: a configuration only if it may write the entry, PDO consumers only if a PDO
    /// can carry it, and non-volatile memory only if it is stored.
    pub(super) fn by_entry(side: &Side<'_>, at: (u16, u8), object: &Object, entry: &Entry) -> Self {
        let is_written = is_writable(entry) || entry.configured_value().is_some();
        let is_carried = entry.is_mappable() || side.mapped.contains(&at);
        Self::ALL
            .without(Audience::Configurations, is_written)
            .without(Audience::PdoConsumers, is_carried)
            .without(Audience::StoredValues, is_stored(object, entry))
    }

    /// Who uses an object of a device.
    pub(super) fn by_object(side: &Side<'_>, index: u16, object: &Object) -> Self {
        let start = Self::ALL
            .without(Audience::Configurations, false)
            .without(Audience::PdoConsumers, false)
            .without(Audience::StoredValues, false);
        object
            .entries()
            .fold(start, |all, (sub, entry)| all.or(Self::by_entry(side, (index, sub), object, &entry)))
    }
}

/// Whether an SDO may write an entry, according to the description.
pub(super) fn is_writable(entry: &Entry) -> bool {
    entry.implied_access().is_none_or(Access::is_writable)
}

/// The storage group of an object that keeps its values without power.
pub(super) fn group(object: &Object) -> Option<&str> {
    let group = object.main.stack.as_ref()?.storage_group.as_deref()?.trim();
    let is_volatile = group.is_empty() || ["RAM", "ROM"].iter().any(|name| name.eq_ignore_ascii_case(group));
    (!is_volatile).then_some(group)
}

/// Whether the value of an entry survives power-off by its parameter.
pub(super) fn is_persistent(entry: &Entry) -> bool {
    entry.parameter.as_ref().is_some_and(|parameter| parameter.persistent == Some(true))
}

fn is_stored(object: &Object, entry: &Entry) -> bool {
    let is_constant = entry.implied_access() == Some(Access::Const);
    (group(object).is_some() && !is_constant) || is_persistent(entry)
}
