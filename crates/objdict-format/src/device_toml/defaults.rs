//! The implications of missing keys of an entry, for the reader and for the writer.

use objdict_keyed::rules::WRONG_TYPE;
use objdict_keyed::section::KeyedTable;
use objdict_model::diagnostic::{Diagnostic, Findings, say};
use objdict_model::model::{Access, DataType, Entry, ObjectType, PdoMapping, Value};

/// The role of an entry in its object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EntryRole {
    /// The value of an object without sub-indexes, or all elements of a compactly stored one.
    Value,
    /// An object with separately described entries.
    Whole,
    /// A sub-index.
    Sub,
    /// Sub-index 0.
    First,
}

/// A property that a description may lack although a missing key implies it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OmittedFact {
    ObjectType,
    Access,
    Map,
    Default,
    SubNumber,
    Sub0,
}

impl OmittedFact {
    pub(super) const ALL: [(Self, &'static str); 6] = [
        (Self::ObjectType, "object-type"),
        (Self::Access, "access"),
        (Self::Map, "map"),
        (Self::Default, "default"),
        (Self::SubNumber, "sub-number"),
        (Self::Sub0, "sub0"),
    ];
}

/// A set of omitted properties.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Omissions(u8);

impl Omissions {
    pub(super) const fn has(self, omission: OmittedFact) -> bool {
        self.0 & 1 << omission as u8 != 0
    }

    pub(super) fn add(&mut self, omission: OmittedFact) {
        self.0 |= 1 << omission as u8;
    }

    /// The omissions of a role without its own list: most descriptions state the types of objects.
    pub(super) const fn of_role(self, role: EntryRole) -> Self {
        match role {
            EntryRole::Value | EntryRole::Whole => Self(self.0 & !(1 << OmittedFact::ObjectType as u8)),
            EntryRole::Sub => self,
            EntryRole::First => Self(0),
        }
    }

    pub(super) const fn is_within(self, other: Self) -> bool {
        self.0 & !other.0 == 0
    }

    pub(super) fn words(self) -> Vec<&'static str> {
        let there = OmittedFact::ALL.into_iter().filter(|(omission, _)| self.has(*omission));
        there.map(|(_, word)| word).collect()
    }

    /// The omissions in the key `unstated`; `None` without it.
    pub(super) fn read(section: &KeyedTable<'_>, findings: &mut Findings) -> Option<Self> {
        section.get("unstated")?;
        let mut omissions = Self::default();
        for text in section.texts("unstated", findings) {
            match OmittedFact::ALL.into_iter().find(|(_, word)| *word == text.value) {
                Some((omission, _)) => omissions.add(omission),
                None => {
                    let message = say!("`{}` is not a value that a missing key implies", text.value);
                    let words = OmittedFact::ALL.map(|(_, word)| format!("`{word}`")).join(", ");
                    let finding = Diagnostic::new(&WRONG_TYPE, text.at, message);
                    findings.push(finding.help(say!("write one of {}", words)));
                }
            }
        }
        Some(omissions)
    }
}

/// The defaults of entries.
#[derive(Clone, Debug)]
pub(super) struct Defaults {
    pub(super) access: Access,
    pub(super) map: PdoMapping,
    pub(super) unstated: Omissions,
    /// Sub-index 0, without its value.
    pub(super) sub0: Entry,
}

impl Default for Defaults {
    fn default() -> Self {
        let sub0 = Entry {
            name: "Highest sub-index supported".into(),
            object_type: Some(ObjectType::Var),
            data_type: Some(DataType::UNSIGNED8),
            access: Some(Access::Const),
            pdo_mapping: Some(PdoMapping::No),
            ..Entry::default()
        };
        Self { access: Access::Rw, map: PdoMapping::No, unstated: Omissions::default(), sub0 }
    }
}

impl Defaults {
    /// The implied entry without keys, for a description with these omissions.
    pub(super) fn implied(&self, role: EntryRole, unstated: Omissions) -> Entry {
        if role == EntryRole::First {
            return self.sub0.clone();
        }
        let is_value = role != EntryRole::Whole;
        Entry {
            object_type: Some(ObjectType::Var).filter(|_| !unstated.has(OmittedFact::ObjectType)),
            access: Some(self.access).filter(|_| is_value && !unstated.has(OmittedFact::Access)),
            pdo_mapping: Some(self.map).filter(|_| is_value && !unstated.has(OmittedFact::Map)),
            ..Entry::default()
        }
    }

    /// The value of sub-index 0 that does not state it.
    pub(super) fn highest(&self, highest: Option<u8>, unstated: Omissions) -> Option<Value> {
        let number = highest.filter(|_| !unstated.has(OmittedFact::Default))?;
        let data_type = self.sub0.data_type.unwrap_or(DataType::UNSIGNED8);
        Value::from_integer(number.into(), data_type)
    }
}
