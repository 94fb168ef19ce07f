//! Reads profiles from TOML. Built-in documents and custom profiles use the same format, described
//! in `docs/reference/profile.md`.

mod fields;
mod pack;

use std::ops::RangeInclusive;

use self::fields::{
    BitRange, ConditionText, NeedText, NumberOrPair, ValueMeanings, number, ranges, word, words,
};
use self::pack::Packer;
use super::tables::{BitRow, CommandRow, EntryRow, MachineRow, NeedRow, ObjectRow, Tables, TransitionRow};
use super::{Confidence, Mapping, Profile};
use crate::diagnostic::nearest;
use crate::model::{Access, DataType, ObjectType, TypeKind, Value};
use crate::source::Span;
use serde::Deserialize;
use toml::Spanned;

/// The reason why a text is not a valid profile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProfileError {
    /// The message.
    pub message: String,
    /// The byte position in the text.
    pub span: Option<Span>,
    /// A suggestion or an instruction.
    pub help: Option<String>,
}

objdict_model::error_messages! { ProfileError: { Self { message, .. } => "{message}"; } }

impl ProfileError {
    fn new(message: String, span: Option<Span>) -> Self {
        let help = meant(&message).map(|word| format!("did you mean `{word}`?"));
        Self { message, span, help }
    }
}

/// A suggestion for an unknown word: one of the words listed in the message, or the name of a data type.
fn meant(message: &str) -> Option<&str> {
    let mut words = message.split('`').skip(1).step_by(2);
    let unknown = words.next().filter(|_| message.contains("unknown"))?;
    let types = (1..0x20).filter_map(|index| DataType(index).name());
    nearest(unknown, words.chain(types).filter(|&word| word != unknown))
}

impl Profile {
    /// Parses a profile in TOML for rules of the group `custom`.
    ///
    /// # Errors
    /// Fails on invalid TOML, unknown keys and invalid values.
    pub fn from_toml(text: &str) -> Result<Self, ProfileError> {
        let file: ProfileFile = toml::from_str(text)
            .map_err(|error| ProfileError::new(error.message().to_owned(), error.span().map(span)))?;
        let mut packer = Packer::default();
        let mut objects = Vec::with_capacity(file.object.len());
        for object in file.object {
            let at = span(object.span());
            let row = object.into_inner().row(file.confidence.unwrap_or_default(), &mut packer);
            objects.push((row.map_err(|message| ProfileError::new(message, Some(at)))?, at));
        }
        objects.sort_by_key(|(row, _)| row.first);
        let twice = objects.windows(2).find(|pair| pair[0].0.last >= pair[1].0.first);
        if let Some((row, at)) = twice.map(|pair| &pair[1]) {
            let message = format!("{:04X}h is defined twice", row.first);
            return Err(ProfileError::new(message, Some(*at)));
        }
        let errors = packer.meanings(&file.errors.0);
        let (machine, commands, transitions) =
            file.state_machine.map(|machine| machine.rows(&mut packer)).unwrap_or_default();
        Ok(Self {
            group: "custom",
            document: file.document.into(),
            title: file.title.into(),
            version: file.version.map(Into::into),
            number: file.number,
            repeats: file.repeats,
            tables: Tables {
                objects: objects.into_iter().map(|(row, _)| row).collect(),
                errors,
                machine,
                commands: commands.into(),
                transitions: transitions.into(),
                ..packer.tables()
            },
        })
    }
}

/// Converts a byte range of toml; offsets beyond 4 GB are cut, but such a text is rejected long before.
fn span(range: std::ops::Range<usize>) -> Span {
    let offset = |offset: usize| u32::try_from(offset).unwrap_or(u32::MAX);
    Span::new(offset(range.start), offset(range.end))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct ProfileFile {
    document: String,
    title: String,
    version: Option<String>,
    number: Option<u16>,
    #[serde(default)]
    repeats: bool,
    #[serde(default, deserialize_with = "word")]
    confidence: Option<Confidence>,
    #[serde(default)]
    object: Vec<Spanned<ObjectTable>>,
    #[serde(default)]
    errors: ValueMeanings,
    state_machine: Option<MachineTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct ObjectTable {
    index: u16,
    last: Option<u16>,
    name: String,
    #[serde(default, deserialize_with = "words")]
    object_type: Vec<ObjectType>,
    need: Option<NeedText>,
    only: Option<ConditionText>,
    source: Option<String>,
    #[serde(default, deserialize_with = "word")]
    confidence: Option<Confidence>,
    about: Option<String>,
    #[serde(default)]
    as_many_as: Vec<u16>,
    entries: Option<Vec<EntryTable>>,
    elements: Option<NumberOrPair>,
    // applies to the value of a VAR
    #[serde(default, deserialize_with = "words")]
    data_type: Vec<DataType>,
    #[serde(default, deserialize_with = "words")]
    access: Vec<Access>,
    #[serde(default, deserialize_with = "word")]
    mapping: Option<Mapping>,
    #[serde(default, deserialize_with = "ranges")]
    values: Vec<RangeInclusive<i128>>,
    default: Option<toml::Value>,
    unit: Option<String>,
    #[serde(default)]
    bits: Vec<BitTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct EntryTable {
    sub: u8,
    last: Option<u8>,
    #[serde(default)]
    name: String,
    need: Option<NeedText>,
    #[serde(default, deserialize_with = "words")]
    data_type: Vec<DataType>,
    #[serde(default, deserialize_with = "words")]
    access: Vec<Access>,
    #[serde(default, deserialize_with = "word")]
    mapping: Option<Mapping>,
    #[serde(default, deserialize_with = "ranges")]
    values: Vec<RangeInclusive<i128>>,
    default: Option<toml::Value>,
    unit: Option<String>,
    #[serde(default)]
    bits: Vec<BitTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct BitTable {
    at: BitRange,
    name: String,
    #[serde(default)]
    values: ValueMeanings,
}

impl ObjectTable {
    fn row(self, of_document: Confidence, packer: &mut Packer) -> Result<ObjectRow, String> {
        let last = self.last.unwrap_or(self.index);
        if last < self.index {
            return Err(format!("`last` {last:04X}h is below `index` {:04X}h", self.index));
        }
        let mut object_types = self.object_type;
        let has_value = !self.data_type.is_empty() || !self.access.is_empty() || self.mapping.is_some();
        let has_value = has_value || !self.values.is_empty() || self.default.is_some();
        let has_value = has_value || self.unit.is_some() || !self.bits.is_empty();
        let value = EntryTable {
            sub: 0,
            last: None,
            name: String::new(),
            need: Some(NeedText::Mandatory),
            data_type: self.data_type,
            access: self.access,
            mapping: self.mapping,
            values: self.values,
            default: self.default,
            unit: self.unit,
            bits: self.bits,
        };
        let entries = match (self.entries, self.elements) {
            (Some(_), Some(_)) => {
                return Err("an object cannot have both `entries` and `elements`".to_owned());
            }
            (Some(_), None) if has_value => {
                return Err(
                    "an object with `entries` must state data type, access and values in them".to_owned()
                );
            }
            (Some(entries), None) => {
                entries.into_iter().map(|entry| entry.row(packer)).collect::<Result<Vec<_>, _>>()?
            }
            (None, Some(number)) => {
                if object_types.is_empty() {
                    object_types.extend([ObjectType::Array, ObjectType::Record]);
                }
                let element = EntryRow { name: packer.text(&self.name), ..value.row(packer)? };
                elements(number.0, element, packer)?
            }
            (None, None) if has_value => {
                if object_types.is_empty() {
                    object_types.push(ObjectType::Var);
                }
                vec![value.row(packer)?]
            }
            (None, None) => Vec::new(),
        };
        if let Some(pair) = entries.windows(2).find(|pair| pair[0].last >= pair[1].first) {
            return Err(format!("sub-index {} must not follow {}", pair[1].first, pair[0].last));
        }
        Ok(ObjectRow {
            first: self.index,
            last,
            name: packer.text(&self.name),
            object_types: packer.object_types.part(&object_types),
            need: packer.need(self.need),
            only: self.only.map(|only| packer.condition(only.0)),
            as_many_as: packer.indexes.part(&self.as_many_as),
            entries: packer.entries.part(&entries),
            source: packer.text(self.source.as_deref().unwrap_or_default()),
            about: packer.text(self.about.as_deref().unwrap_or_default()),
            confidence: self.confidence.unwrap_or(of_document),
        })
    }
}

impl EntryTable {
    fn row(self, packer: &mut Packer) -> Result<EntryRow, String> {
        let last = self.last.unwrap_or(self.sub);
        if last < self.sub {
            return Err(format!("`last` {last} is below `sub` {}", self.sub));
        }
        let data_type = self.data_type.first().copied();
        let default = self.default.map(|figure| value(&figure, data_type)).transpose()?;
        let bits = self.bits.iter().map(|bits| BitRow {
            first: *bits.at.0.start(),
            last: *bits.at.0.end(),
            name: packer.text(&bits.name),
            values: packer.meanings(&bits.values.0),
        });
        let bits: Vec<BitRow> = bits.collect();
        Ok(EntryRow {
            first: self.sub,
            last,
            name: packer.text(&self.name),
            data_types: packer.data_types.part(&self.data_type),
            access: packer.access.part(&self.access),
            need: packer.need(self.need),
            mapping: self.mapping,
            values: packer.values.part(&self.values),
            default: default.map(|default| packer.default_value(default)),
            unit: packer.text(self.unit.as_deref().unwrap_or_default()),
            bits: packer.bits.part(&bits),
        })
    }
}

/// The entries of an ARRAY with similar elements: their number in sub-index 0, the first one, which is
/// mandatory, and the others, which are mandatory if the number is fixed.
fn elements(
    number: RangeInclusive<i128>,
    element: EntryRow,
    packer: &mut Packer,
) -> Result<Vec<EntryRow>, String> {
    let sub = |number: &i128| u8::try_from(*number).ok().filter(|&number| number < 0xFF);
    let (Some(least), Some(most @ 1..)) = (sub(number.start()), sub(number.end())) else {
        return Err("`elements` must be a number from 1 to 254, or a minimum and a maximum".to_owned());
    };
    let count = EntryRow {
        first: 0,
        last: 0,
        name: packer.text("Highest sub-index supported"),
        data_types: packer.data_types.part(&[DataType::UNSIGNED8]),
        access: packer.access.part(&[Access::Ro]),
        need: NeedRow::Mandatory,
        mapping: Some(Mapping::No),
        values: packer.values.part(&[number]),
        default: None,
        unit: packer.text(""),
        bits: packer.bits.part(&[]),
    };
    let first = EntryRow { first: 1, last: 1, ..element };
    if least == most {
        return Ok(vec![count, EntryRow { last: most, ..first }]);
    }
    let need = if least == 0 { NeedRow::Optional } else { NeedRow::Mandatory };
    let others = EntryRow { first: 2, last: most, need: NeedRow::Optional, ..first };
    let others = (most > 1).then_some(others);
    Ok([count, EntryRow { need, ..first }].into_iter().chain(others).collect())
}

/// A default value of a data type, or an integer without a data type.
fn value(figure: &toml::Value, data_type: Option<DataType>) -> Result<Value, String> {
    let wrong = || {
        let of = data_type.map_or_else(|| "a number".to_owned(), |data_type| data_type.to_string());
        let figure = match figure {
            toml::Value::String(text) => text.clone(),
            toml::Value::Integer(number) => number.to_string(),
            toml::Value::Float(number) => number.to_string(),
            other => other.type_str().to_owned(),
        };
        format!("the default `{figure}` is not a valid {of}")
    };
    let integer_type = data_type.unwrap_or(match figure {
        toml::Value::Integer(number) if *number >= 0 => DataType::UNSIGNED64,
        _ => DataType::INTEGER64,
    });
    let value = match figure {
        toml::Value::Integer(number) => match integer_type.kind() {
            TypeKind::Real32 => Some(Value::Real32(*number as f32)),
            TypeKind::Real64 => Some(Value::Real64(*number as f64)),
            _ => Value::from_integer(i128::from(*number), integer_type),
        },
        toml::Value::Boolean(flag) => Some(Value::Boolean(*flag)),
        toml::Value::Float(number) => match integer_type.kind() {
            TypeKind::Real32 => Some(Value::Real32(*number as f32)),
            TypeKind::Real64 => Some(Value::Real64(*number)),
            _ => None,
        },
        toml::Value::String(text) => match text.strip_prefix("$NODEID") {
            Some("") => Some(Value::NodeId(0)),
            Some(offset) => offset.strip_prefix('+').and_then(number).map(Value::NodeId),
            None => Some(Value::Text(text.as_str().into())),
        },
        _ => None,
    };
    value.filter(|value| value.is_of(data_type)).ok_or_else(wrong)
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MachineTable {
    status: u16,
    command: u16,
    commands: Vec<CommandTable>,
    transitions: Vec<TransitionTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CommandTable {
    name: String,
    mask: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TransitionTable {
    number: u8,
    from: String,
    to: String,
    by: String,
}

impl MachineTable {
    fn rows(&self, packer: &mut Packer) -> (Option<MachineRow>, Vec<CommandRow>, Vec<TransitionRow>) {
        let command =
            |row: &CommandTable| CommandRow { name: packer.text(&row.name), mask: packer.text(&row.mask) };
        let commands = self.commands.iter().map(command).collect();
        let transition = |row: &TransitionTable| TransitionRow {
            number: row.number,
            from: packer.text(&row.from),
            to: packer.text(&row.to),
            by: packer.text(&row.by),
        };
        let transitions = self.transitions.iter().map(transition).collect();
        (Some(MachineRow { status: self.status, command: self.command }), commands, transitions)
    }
}
