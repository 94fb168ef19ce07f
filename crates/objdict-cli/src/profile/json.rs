//! Profiles as JSON; `docs/reference/json.md` describes it.

use std::io::{self, Write};

use serde::Serialize;

use objdict_model::json;
use objdict_model::model::{Access, DataType, HexText, ObjectType, Plain};
use objdict_profile::{BitFieldFacts, EntryFacts, Mapping, Need, ObjectFacts, Profile};

/// The version of the documents. It changes when a field is removed or means something else, not when one is added.
const VERSION: u32 = 1;

/// The list of documents, which is written document by document.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[allow(dead_code, reason = "its schema is all that is made of it")]
pub(crate) struct ListDocument<'a> {
    /// The version of the document.
    version: json::Version<VERSION>,
    /// The documents.
    profiles: Vec<DemandingDocument<'a>>,
}

/// A profile, which is written object by object.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[allow(dead_code, reason = "its schema is all that is made of it")]
pub(crate) struct ProfileDocument<'a> {
    /// The version of the document.
    version: json::Version<VERSION>,
    /// The document.
    profile: DemandingDocument<'a>,
    /// Its objects, or the one that was asked for.
    objects: Vec<ObjectJson<'a>>,
}

/// A document that demands something of a device.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Profile"))]
struct DemandingDocument<'a> {
    /// The number of objects.
    count: usize,
    /// The usual name.
    document: &'a str,
    /// The version of the document.
    #[serde(skip_serializing_if = "Option::is_none")]
    edition: Option<&'a str>,
    /// The name for `--profile`; absent for a custom profile.
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    /// The device profile number; absent for documents about devices of any profile.
    #[serde(skip_serializing_if = "Option::is_none")]
    number: Option<u16>,
    /// Whether a device may have its objects several times, 800h indexes apart.
    repeats: bool,
    /// The subject.
    title: &'a str,
}

/// An object, or a range of equal objects.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Object"))]
struct ObjectJson<'a> {
    /// The first of these objects that the device has determines the number of elements.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    as_many_as: Vec<HexText<u16>>,
    /// The sub-indexes; for a VAR one with sub-index 0.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    entries: Vec<EntryJson<'a>>,
    /// The index, for a range the first one.
    index: HexText<u16>,
    /// The last index of a range.
    #[serde(skip_serializing_if = "Option::is_none")]
    last: Option<HexText<u16>>,
    /// The name.
    name: &'a str,
    /// `mandatory`, `optional`, or `if` with a condition.
    need: String,
    /// The object type, then others that are accepted.
    #[serde(skip_serializing_if = "Option::is_none")]
    object_types: Option<&'a [ObjectType]>,
    /// The condition under which the object is allowed.
    #[serde(skip_serializing_if = "Option::is_none")]
    only: Option<String>,
    /// The place in the document.
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<&'a str>,
}

/// An entry, or a range of equal entries.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Entry"))]
struct EntryJson<'a> {
    /// The access types that are accepted.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    access: &'a [Access],
    /// The bits and bit fields.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bits: Vec<BitJson<'a>>,
    /// The data types that are accepted.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    data_types: Vec<String>,
    /// The default value.
    #[serde(skip_serializing_if = "Option::is_none")]
    default: Option<Plain<'a>>,
    /// The last sub-index of a range.
    #[serde(skip_serializing_if = "Option::is_none")]
    last: Option<HexText<u8>>,
    /// Whether PDOs carry it: `no`, `tpdo`, `rpdo` or `any`.
    #[serde(skip_serializing_if = "Option::is_none")]
    mapping: Option<&'static str>,
    /// The name.
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    /// `mandatory`, `optional`, or `if` with a condition.
    need: String,
    /// The sub-index, for a range the first one.
    sub: HexText<u8>,
    /// Pairs of the smallest and the largest value.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    values: Vec<[Plain<'a>; 2]>,
}

/// A bit or bit field of a value.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Bits"))]
struct BitJson<'a> {
    /// The first bit.
    first: u8,
    /// The last bit.
    last: u8,
    /// The name.
    name: &'a str,
    /// The values that have a meaning.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    values: Vec<BitValue<'a>>,
}

/// Values of a bit field with one meaning.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct BitValue<'a> {
    /// The smallest value.
    first: u64,
    /// The largest value.
    last: u64,
    /// The meaning.
    meaning: &'a str,
}

/// The documents, one a line.
pub(super) fn list<'a>(profiles: impl Iterator<Item = &'a Profile>, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "{{\"version\":{VERSION},\"profiles\":[")?;
    lines(profiles.map(head), out)
}

/// A profile, one object a line.
pub(super) fn profile<'a>(
    profile: &Profile,
    objects: impl Iterator<Item = ObjectFacts<'a>>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let head = json::text(&head(profile))?;
    write!(out, "{{\"version\":{VERSION},\"profile\":{head},\"objects\":[")?;
    lines(objects.map(object), out)
}

fn lines(items: impl Iterator<Item = impl Serialize>, out: &mut dyn Write) -> io::Result<()> {
    let mut separator = "\n";
    for item in items {
        write!(out, "{separator}{}", json::text(&item)?)?;
        separator = ",\n";
    }
    out.write_all(b"\n]}\n")
}

fn head(profile: &Profile) -> DemandingDocument<'_> {
    DemandingDocument {
        count: profile.objects().len(),
        document: &profile.document,
        edition: profile.version.as_deref(),
        name: (profile.group != "custom").then(|| profile.document_number()),
        number: profile.number,
        repeats: profile.repeats,
        title: &profile.title,
    }
}

fn object(facts: ObjectFacts<'_>) -> ObjectJson<'_> {
    ObjectJson {
        as_many_as: facts.as_many_as.iter().copied().map(HexText).collect(),
        entries: facts.entries().map(entry).collect(),
        index: HexText(facts.first),
        last: (facts.last > facts.first).then_some(HexText(facts.last)),
        name: facts.name,
        need: need(facts.need),
        object_types: facts.states_type().then_some(facts.object_types),
        only: facts.only.map(ToString::to_string),
        source: facts.source,
    }
}

fn entry(facts: EntryFacts<'_>) -> EntryJson<'_> {
    let bound = |number: i128| {
        i64::try_from(number).map_or_else(|_| Plain::Text(number.to_string().into()), Plain::Signed)
    };
    EntryJson {
        access: facts.access,
        bits: facts.bits().map(bits).collect(),
        data_types: facts.data_types.iter().map(DataType::to_string).collect(),
        default: facts.default.map(|value| value.plain().into_owned()),
        last: (facts.last > facts.first).then_some(HexText(facts.last)),
        mapping: facts.mapping.map(Mapping::name),
        name: Some(facts.name).filter(|name| !name.is_empty()),
        need: need(facts.need),
        sub: HexText(facts.first),
        values: facts.values.iter().map(|range| [bound(*range.start()), bound(*range.end())]).collect(),
    }
}

fn bits(field: BitFieldFacts<'_>) -> BitJson<'_> {
    let value = |(range, meaning): (std::ops::RangeInclusive<u64>, _)| BitValue {
        first: *range.start(),
        last: *range.end(),
        meaning,
    };
    BitJson {
        first: field.first,
        last: field.last,
        name: field.name,
        values: field.meanings().map(value).collect(),
    }
}

fn need(need: Need<'_>) -> String {
    match need {
        Need::Optional => "optional".to_owned(),
        Need::Mandatory => "mandatory".to_owned(),
        Need::When(condition) => format!("if {condition}"),
    }
}
