//! The JSON of entries and of types that contain one: all fields are on one level, and unknown names are
//! errors.
//!
//! serde can write a flattened field but, reading it back, loses positions in the text and ignores unknown
//! names. Therefore reading uses separate types with the same names.

use serde::{Deserialize, Serialize};

use super::{
    Access, Compact, Configured, DataType, Entry, Extension, ExtensionCount, Extra, ExtraSection,
    InvalidValues, ObjFlags, Object, ObjectType, Parameter, PdoMapping, SafetyMapping, StackOptions, Subs,
    Value,
};

macro_rules! form {
    ($Form:ident { $($own:ident: $Type:ty $(, with $with:literal)?;)* }) => {
        #[derive(Default, Deserialize)]
        #[serde(default, deny_unknown_fields)]
        pub(super) struct $Form {
            name: Box<str>,
            object_type: Option<ObjectType>,
            data_type: Option<DataType>,
            access: Option<Access>,
            pdo_mapping: Option<PdoMapping>,
            default: Option<Value>,
            low_limit: Option<Value>,
            high_limit: Option<Value>,
            flags: Option<ObjFlags>,
            configured: Option<Box<Configured>>,
            safety: Option<Box<SafetyMapping>>,
            parameter: Option<Box<Parameter>>,
            stack: Option<Box<StackOptions>>,
            extra: Extra,
            #[serde(rename = "misfits")]
            invalid_values: InvalidValues,
            $($(#[serde(with = $with)])? $own: $Type,)*
        }

        impl $Form {
            /// The entry, if its values are valid for its data type.
            fn take_entry(&mut self) -> Result<Entry, Unfit> {
                let form = std::mem::take(self);
                $(self.$own = form.$own;)*
                let Self { name, object_type, data_type, access, pdo_mapping, flags, configured, safety, .. } = form;
                let Self { default, low_limit, high_limit, parameter, stack, extra, invalid_values, .. } = form;
                let entry = Entry {
                    name, object_type, data_type, access, pdo_mapping, default, low_limit, high_limit,
                    flags, configured, safety, parameter, stack, extra, invalid_values,
                };
                check(&entry)?;
                Ok(entry)
            }
        }
    };
}

form!(EntryForm {});

form!(ObjectForm {
    orphan: bool;
    sub_number: Option<u8>;
    compact: Option<Box<Compact>>;
    subs: Subs;
    links: Vec<u16>, with "super::index_list";
});

form!(ExtensionForm {
    count: Option<ExtensionCount>;
    obj_extend: Option<u8>;
});

/// An unknown section.
#[derive(Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct SectionForm {
    /// The name, without brackets.
    name: Box<str>,
    /// The keys with their values.
    #[serde(default, skip_serializing_if = "Extra::is_empty")]
    entries: Extra,
}

impl From<SectionForm> for ExtraSection {
    fn from(SectionForm { name, entries }: SectionForm) -> Self {
        Self::new(&name, &entries)
    }
}

impl From<ExtraSection> for SectionForm {
    fn from(section: ExtraSection) -> Self {
        Self { name: section.name().into(), entries: section.entries().collect() }
    }
}

/// Why fields are inconsistent.
#[derive(Debug)]
pub(super) enum Unfit {
    /// A value that is not valid for the data type of its entry.
    Value { field: &'static str, value: Value, data_type: DataType },
    /// A name, value or denotation of a missing entry.
    Sub { field: &'static str, sub: u8, count: u8 },
}

crate::error_messages! { Unfit: {
    Self::Value { field, value, data_type } => "{field}: `{value}` is not a valid {data_type}";
    Self::Sub { field, sub, count } =>
        "{field}: sub-index {sub:X}h is not among the {count} that are stored compactly";
} }

fn check(entry: &Entry) -> Result<(), Unfit> {
    entry.values().try_for_each(|(field, value)| fits(field, value, entry.data_type))
}

fn fits(field: &'static str, value: &Value, data_type: Option<DataType>) -> Result<(), Unfit> {
    match data_type {
        Some(data_type) if !value.is_of(Some(data_type)) => {
            Err(Unfit::Value { field, value: value.clone(), data_type })
        }
        _ => Ok(()),
    }
}

fn check_compact(compact: &Compact, data_type: Option<DataType>) -> Result<(), Unfit> {
    fn subs<T>(list: &[(u8, T)]) -> impl Iterator<Item = u8> {
        list.iter().map(|(sub, _)| *sub)
    }
    let names = subs(&compact.names).map(|sub| ("names", sub));
    let values = subs(&compact.values).map(|sub| ("values", sub));
    let denotations = subs(&compact.denotations).map(|sub| ("denotations", sub));
    let count = compact.count;
    if let Some((field, sub)) =
        names.chain(values).chain(denotations).find(|(_, sub)| !(1..=count).contains(sub))
    {
        return Err(Unfit::Sub { field, sub, count });
    }
    compact.values.iter().try_for_each(|(_, value)| fits("values", value, data_type))
}

impl TryFrom<EntryForm> for Entry {
    type Error = Unfit;

    fn try_from(mut form: EntryForm) -> Result<Self, Unfit> {
        form.take_entry()
    }
}

impl TryFrom<ObjectForm> for Object {
    type Error = Unfit;

    fn try_from(mut form: ObjectForm) -> Result<Self, Unfit> {
        let main = form.take_entry()?;
        form.compact.as_ref().map_or(Ok(()), |compact| check_compact(compact, main.data_type))?;
        let ObjectForm { orphan, sub_number, compact, subs, links, .. } = form;
        Ok(Self { orphan, main, sub_number, compact, subs, links })
    }
}

impl TryFrom<ExtensionForm> for Extension {
    type Error = Unfit;

    fn try_from(mut form: ExtensionForm) -> Result<Self, Unfit> {
        let entry = form.take_entry()?;
        Ok(Self { entry, count: form.count, obj_extend: form.obj_extend })
    }
}
