//! Tables of objects as CSV, as `objdict docs --to csv` writes them, read back as objects.

use std::collections::BTreeMap;

use crate::csv::records;
use crate::device_toml::meaning;
use objdict_model::literal::{self, Quirks};
use objdict_model::model::{
    Access, AllowedValues, ApplicationProcess, DataType, DataTypeRef, Device, Entry, EnumValue, Field,
    LANGUAGE, Label, Labels, ObjFlags, Object, ObjectLists, ObjectType, Parameter, ParameterGroup,
    PdoMapping, Property, Reason, ScaledValue, StackOptions, Support, TypeDefinition, TypeKind, TypeShape,
    Unit, Value, ValueRange,
};

/// The columns that are read. The first ones, with the address, the type and the access, are required.
const COLUMNS: &str = "index sub object_type data_type access object_name name pdo default value low_limit high_limit unit denotation \
    description object_description name_in_file object_name_in_file default_formula value_formula named_values bit_fields groups facts \
    keys object_facts object_keys links invalid_values";
const NEEDED: usize = 5;

/// The columns about the object, which are the same in all its rows; only the first row needs them.
const OF_OBJECT: &str =
    "object_type object_name object_description object_name_in_file object_facts object_keys links";

/// The columns that are computed from the others.
const COMPUTED: [&str; 5] = ["bits", "changed", "meaning", "mapped_in", "downloads"];

/// A line with the cells of the columns that it has.
struct TableLine {
    line: usize,
    cells: BTreeMap<&'static str, String>,
}

/// Reads the objects of a table, with the meanings of their values.
///
/// # Errors
/// The first invalid cell, or an unknown column.
pub fn read(text: &str) -> Result<Device, String> {
    let mut records = records(text.trim_start_matches('\u{FEFF}')).into_iter();
    let (line, headings) = records.next().unwrap_or((1, Vec::new()));
    let known = |heading: &String| COLUMNS.split_whitespace().find(|column| *column == heading.trim());
    let columns: Vec<_> = headings.iter().map(known).collect();
    let is_wrong = |(at, heading): &(usize, &String)| match columns[*at] {
        None => !COMPUTED.contains(&heading.trim()),
        known => columns[..*at].contains(&known),
    };
    if let Some((_, heading)) = headings.iter().enumerate().find(is_wrong) {
        return Err(fault(line, heading, "unknown or duplicate column"));
    }
    let mut needed = COLUMNS.split_whitespace().take(NEEDED);
    if let Some(missing) = needed.find(|column| !columns.contains(&Some(*column))) {
        return Err(fault(line, missing, "the column is missing"));
    }
    let mut objects: BTreeMap<u16, Vec<(Option<u8>, TableLine)>> = BTreeMap::new();
    for (line, record) in records {
        if let Some(cell) = record.get(columns.len()) {
            return Err(fault(line, cell, "a cell without a heading"));
        }
        let cells = columns.iter().zip(&record).filter_map(|(column, cell)| Some(((*column)?, plain(cell))));
        let row = TableLine { line, cells: cells.collect() };
        let index = row.number("index", 4)?.ok_or_else(|| row.error("index", "the index is missing"))?;
        let sub = row.number("sub", 2)?.and_then(|sub| u8::try_from(sub).ok());
        let rows = objects.entry(index).or_default();
        if rows.iter().any(|(other, _)| *other == sub) {
            return Err(row.error("sub", "the entry is defined twice"));
        }
        if let Some((_, first)) = rows.first() {
            let differs = |column: &&str| ![first.get(column), ""].contains(&row.get(column));
            if let Some(column) = OF_OBJECT.split_whitespace().find(differs) {
                return Err(row.error(column, "differs from an earlier row of the object"));
            }
        }
        rows.push((sub, row));
    }
    let mut device = Device { lists: ObjectLists::naming(objects.keys().copied()), ..Device::default() };
    let mut application = ApplicationProcess::default();
    let mut members = Vec::new();
    for (&index, rows) in &objects {
        let object = object(index, rows, &mut application)?;
        for (sub, row) in rows {
            let id = Parameter::usual_id(index, sub.filter(|_| !object.subs.is_empty()));
            members.push((
                row.get("groups").split("; ").filter(|path| !path.is_empty()).collect::<Vec<_>>(),
                id,
            ));
        }
        device.objects.insert(index, object);
    }
    // who is in most groups shows their order
    members.sort_by_key(|(paths, _)| usize::MAX - paths.len());
    for (paths, id) in members {
        paths.into_iter().for_each(|path| group(&mut application.groups, path, &id));
    }
    device.application.extend(Some(application).filter(|application| *application != Default::default()));
    Ok(device)
}

fn fault(line: usize, column: &str, message: &str) -> String {
    format!("line {line}, column `{column}`: {message}")
}

/// A cell without the apostrophes that keep spreadsheets from evaluating it.
fn plain(cell: &str) -> String {
    let part = |part: &str| match part.strip_prefix('\'') {
        Some(rest) if rest.trim_start().starts_with(['=', '+', '-', '@']) => rest.to_owned(),
        _ => part.to_owned(),
    };
    cell.split(';').map(part).collect::<Vec<_>>().join(";")
}

fn object(
    index: u16,
    rows: &[(Option<u8>, TableLine)],
    application: &mut ApplicationProcess,
) -> Result<Object, String> {
    let mut object = Object::default();
    let Some((first_sub, first)) = rows.first() else { return Ok(object) };
    let object_type =
        first.word("object_type", |word| ObjectType::ALL.into_iter().find(|known| known.name() == word))?;
    object.orphan = object_type.is_none();
    let has_subs = object_type.is_none_or(ObjectType::has_subs);
    let without_sub = rows.iter().filter(|(sub, _)| sub.is_none() && (has_subs || rows.len() > 1));
    let missing = |row: &TableLine| {
        let column = ["data_type", "access", "default", "value"]
            .into_iter()
            .find(|column| !row.get(column).is_empty())?;
        Some(row.error(column, "the sub-index of the entry is missing"))
    };
    if let Some(error) = without_sub.into_iter().find_map(|(_, row)| missing(row)) {
        return Err(error);
    }
    if rows.len() == 1 && !has_subs && first_sub.is_none_or(|sub| sub == 0) {
        object.main = first.entry(&format!("{index:04X}"), &Parameter::usual_id(index, None), application)?;
    } else {
        if !object.orphan {
            first.name(&mut object.main, "object_name", "object_name_in_file");
        }
        first.details(&mut object.main, ["object_description", "object_facts", "object_keys"])?;
        for (sub, row) in rows.iter().filter_map(|(sub, row)| Some(((*sub)?, row))) {
            let id = Parameter::usual_id(index, Some(sub));
            let entry = row.entry(&format!("{index:04X}sub{sub:X}"), &id, application)?;
            object.subs.insert(sub, Entry { object_type: Some(ObjectType::Var), ..entry });
        }
    }
    object.main.object_type = object_type;
    let count = object.subs.iter().filter(|(sub, _)| *sub < 0xFF).count();
    object.sub_number = u8::try_from(count).ok().filter(|count| *count > 0);
    let links = first.get("links").split("; ").filter(|link| !link.is_empty());
    let links = links.map(|link| first.hex("links", link, 4)).collect::<Result<Vec<_>, _>>();
    object.links = links?;
    Ok(object)
}

impl TableLine {
    fn get(&self, column: &str) -> &str {
        self.cells.get(column).map_or("", String::as_str)
    }

    fn error(&self, column: &str, message: &str) -> String {
        let text = self.get(column);
        let message = if text.is_empty() { message.to_owned() } else { format!("{message}: `{text}`") };
        fault(self.line, column, &message)
    }

    fn hex(&self, column: &str, text: &str, digits: usize) -> Result<u16, String> {
        let number = text.strip_prefix("0x").filter(|rest| rest.len() <= digits && !rest.starts_with('+'));
        let number = number.and_then(|rest| u16::from_str_radix(rest, 16).ok());
        number.ok_or_else(|| self.error(column, &format!("expected at most {digits} hex digits after `0x`")))
    }

    fn number(&self, column: &str, digits: usize) -> Result<Option<u16>, String> {
        let text = self.get(column).trim();
        if text.is_empty() { Ok(None) } else { self.hex(column, text, digits).map(Some) }
    }

    fn word<T>(&self, column: &str, read: impl Fn(&str) -> Option<T>) -> Result<Option<T>, String> {
        match self.get(column).trim() {
            "" => Ok(None),
            text => read(text).map(Some).ok_or_else(|| self.error(column, "unknown word")),
        }
    }

    /// The pairs in a cell: `0 = off; 1 = on`. A separator that no key follows belongs to the preceding text.
    fn pairs<'t>(
        &self,
        column: &str,
        text: &'t str,
        between: &str,
        is: &str,
    ) -> Result<Vec<(&'t str, String)>, String> {
        let mut pairs: Vec<(&str, String)> = Vec::new();
        for part in text.split(between).filter(|_| !text.is_empty()) {
            match (part.split_once(is), pairs.last_mut()) {
                (Some((key, text)), _) => pairs.push((key, text.to_owned())),
                (None, Some((_, before))) => *before = [before, between, part].concat(),
                (None, None) => return Err(self.error(column, &format!("expected `key{is}text`"))),
            }
        }
        Ok(pairs)
    }

    /// The name in the file, and the displayed name if it differs.
    fn name(&self, entry: &mut Entry, shown: &str, own: &str) {
        entry.name = self.get(if self.get(own).is_empty() { shown } else { own }).into();
        if !self.get(own).is_empty() {
            entry.parameter_mut().labels = Labels::name(LANGUAGE, self.get(shown));
        }
    }

    fn entry(&self, address: &str, id: &str, application: &mut ApplicationProcess) -> Result<Entry, String> {
        let data_type = |word: &str| {
            let digits = word.strip_prefix("0x").or(word.strip_suffix('h'));
            DataType::from_name(word).or_else(|| u16::from_str_radix(digits?, 16).ok().map(DataType))
        };
        let data_type = self.word("data_type", data_type)?;
        let mut entry =
            Entry { data_type, access: self.word("access", Access::from_name)?, ..Entry::default() };
        self.name(&mut entry, "name", "name_in_file");
        let directions = self.get("pdo").trim();
        let mappings = [PdoMapping::No, PdoMapping::Optional, PdoMapping::Tpdo, PdoMapping::Rpdo];
        let fits = |mapping: &PdoMapping| {
            Entry { pdo_mapping: Some(*mapping), access: entry.access, ..Entry::default() }.pdo_directions()
                == directions
        };
        entry.pdo_mapping = mappings.into_iter().find(fits);
        if entry.pdo_mapping.is_none() {
            return Err(self.error("pdo", "the access type does not allow these PDOs"));
        }
        entry.default = self.value("default", "default_formula", data_type)?;
        entry.low_limit = self.value("low_limit", "", data_type)?;
        entry.high_limit = self.value("high_limit", "", data_type)?;
        if let Some(value) = self.value("value", "value_formula", data_type)? {
            entry.configured_mut().value = Some(value);
        }
        for (key, text) in self.pairs("invalid_values", self.get("invalid_values"), "; ", " = ")? {
            let reason =
                literal::value(&text, data_type, &mut Quirks::default()).err().unwrap_or(Reason::Malformed);
            entry.invalid_values.push(field(key), &text, reason);
        }
        self.details(&mut entry, ["description", "facts", "keys"])?;
        if !self.get("denotation").is_empty() {
            entry.parameter_mut().denotation = Labels::name(LANGUAGE, self.get("denotation"));
        }
        if !self.get("unit").is_empty() {
            scale(self.get("unit"), entry.parameter_mut());
        }
        let named = self.pairs("named_values", self.get("named_values"), "; ", " = ")?;
        if !named.is_empty() {
            let allowed = entry.parameter_mut().allowed_values.get_or_insert_default();
            allowed.values = AllowedValues::named(named).values;
        }
        self.bit_fields(address, &mut entry, application)?;
        if !self.get("groups").is_empty() {
            entry.parameter_mut().unique_id = id.into();
        }
        Ok(entry)
    }

    /// A value, or the formula that it is calculated from.
    fn value(
        &self,
        column: &str,
        formula: &str,
        data_type: Option<DataType>,
    ) -> Result<Option<Value>, String> {
        let text = if self.get(formula).is_empty() { self.get(column) } else { self.get(formula) };
        let read = match data_type.map(DataType::kind) {
            _ if text.is_empty() => return Ok(None),
            Some(TypeKind::VisibleString | TypeKind::UnicodeString) => Ok(Value::Text(text.into())),
            Some(TypeKind::TimeOfDay | TypeKind::TimeDifference) => literal::value(
                &text.replace(" d ", " ").replace(" ms", ""),
                data_type,
                &mut Quirks::default(),
            ),
            _ => literal::value(text, data_type, &mut Quirks::default()),
        };
        let wanted = || format!("no {}", data_type.and_then(DataType::name).unwrap_or("value"));
        read.map(Some).map_err(|_| self.error(column, &wanted()))
    }

    /// Description, properties and keys of an entry or object.
    fn details(&self, entry: &mut Entry, [description, facts, keys]: [&str; 3]) -> Result<(), String> {
        if !self.get(description).is_empty() {
            let text =
                Label::Description { lang: LANGUAGE.into(), text: self.get(description).into(), uri: None };
            entry.parameter_mut().labels.0.push(text);
        }
        for (key, text) in self.pairs(facts, self.get(facts), "; ", " = ")? {
            let flags = entry.flags().0;
            match (key, text.as_str()) {
                ("substitute value", text) => {
                    entry.parameter_mut().substitute_value =
                        Some(ScaledValue { value: text.into(), ..ScaledValue::default() });
                }
                ("persistent", "yes") => entry.parameter_mut().persistent = Some(true),
                ("support", word) if Support::from_name(word).is_some() => {
                    entry.parameter_mut().support = Support::from_name(word);
                }
                ("allowed", text) => allow(text, entry.parameter_mut()),
                ("upload file", text) => entry.configured_mut().upload_file = Some(text.into()),
                ("download file", text) => entry.configured_mut().download_file = Some(text.into()),
                ("reference", text) => entry.configured_mut().reference_designator = Some(text.into()),
                ("configuration tool", "does not write it") => entry.flags = Some(ObjFlags(flags | 1)),
                ("configuration tool", "does not read it") => entry.flags = Some(ObjFlags(flags | 2)),
                ("SRDO", "may be mapped") => entry.safety_mut().srdo_mapping = Some(true),
                ("inverted value", place) => {
                    let (index, sub) = place.split_once(':').unwrap_or((place, ""));
                    let sub =
                        u8::from_str_radix(sub, 16).map_err(|_| self.error(facts, "no place of an entry"))?;
                    entry.safety_mut().inverted_srad =
                        Some(u32::from(self.hex(facts, index, 4)?) << 16 | u32::from(sub));
                }
                _ => return Err(self.error(facts, &format!("unknown field `{key} = {text}`"))),
            }
        }
        let mut stack = StackOptions::default();
        let keys = self.pairs(keys, self.get(keys), "; ", " = ")?;
        // properties precede the settings for CANopenNode, and other keys follow them
        let properties = keys.iter().position(|(key, _)| key.starts_with("CO_")).unwrap_or_default();
        for (number, (key, text)) in keys.into_iter().enumerate() {
            match text.strip_prefix('`').and_then(|text| text.strip_suffix("`?")) {
                Some(invalid) => entry.invalid_values.push(field(key), invalid, Reason::Malformed),
                None if stack.set(key, &text) => {}
                None if number < properties => {
                    let property = Property { name: key.into(), value: text.into() };
                    entry.parameter_mut().properties.push(property);
                }
                None => entry.extra.push(key, &text),
            }
        }
        entry.stack = Some(Box::new(stack)).filter(|stack| **stack != StackOptions::default());
        Ok(())
    }

    /// The bit fields of a word, as a type: `0: ready; 4–7: mode (0 = off, 1 = on)`.
    fn bit_fields(
        &self,
        address: &str,
        entry: &mut Entry,
        application: &mut ApplicationProcess,
    ) -> Result<(), String> {
        let mut members = Vec::new();
        for (range, text) in self.pairs("bit_fields", self.get("bit_fields"), "; ", ": ")? {
            let (first, last) = range.split_once('–').unwrap_or((range, range));
            let range = first
                .parse()
                .ok()
                .zip(last.parse().ok())
                .filter(|(first, last): &(u8, u8)| first <= last && *last < 64);
            let range =
                range.ok_or_else(|| self.error("bit_fields", "expected bits such as `3` or `4–7`"))?;
            let (name, values) =
                text.strip_suffix(')').and_then(|text| text.rsplit_once(" (")).unwrap_or((&text, ""));
            let mut member = meaning::member(address, range, name);
            let values = self.pairs("bit_fields", values, ", ", " = ")?;
            if !values.is_empty() {
                let id = format!("UID_ENUM_{address}_{}", range.0);
                member.data_type = Some(DataTypeRef::Defined(id.as_str().into()));
                let value = |(number, name): (&str, String)| EnumValue {
                    labels: Labels::name(LANGUAGE, &name),
                    value: Some(number.into()),
                };
                let shape = TypeShape::Enum {
                    size: None,
                    values: values.into_iter().map(value).collect(),
                    base: None,
                };
                application.data_types.push(TypeDefinition {
                    name: name.into(),
                    unique_id: id.into(),
                    labels: Labels::default(),
                    shape,
                });
            }
            members.push(member);
        }
        if !members.is_empty() {
            meaning::set_bits(address, entry, members, application);
        }
        Ok(())
    }
}

fn field(name: &str) -> Field {
    let known = Field::NAMED.iter().find(|(known, _)| *known == name);
    known.map_or_else(|| Field::Named(name.into()), |(_, field)| field.clone())
}

/// The unit and its scaling: `mm (× 0.001) = (value + 5) × 0.1`.
fn scale(text: &str, parameter: &mut Parameter) {
    let is_formula = |text: &str| text.starts_with("value ") || text.starts_with("(value + ");
    let parts = text.rsplit_once(" = ").filter(|(_, formula)| is_formula(formula));
    let (head, formula) = parts.unwrap_or(if is_formula(text) { ("", text) } else { (text, "") });
    let (sum, factor) =
        formula.rsplit_once(" × ").map_or((formula, None), |(sum, factor)| (sum, Some(factor)));
    let offset = sum.trim_matches(['(', ')']).strip_prefix("value + ");
    (parameter.offset, parameter.multiplier) = (offset.map(Into::into), factor.map(Into::into));
    let scaled = head.strip_suffix(')').and_then(|head| head.rsplit_once(" (× "));
    let (symbol, base) = scaled.unwrap_or((head, "1"));
    parameter.unit =
        Some(Unit { multiplier: base.into(), ..Unit::named(LANGUAGE, symbol) }).filter(|_| !head.is_empty());
}

/// A range of allowed values: `0 … 10, in steps of 2`.
fn allow(text: &str, parameter: &mut Parameter) {
    let (range, step) =
        text.split_once(", in steps of ").map_or((text, None), |(range, step)| (range, Some(step)));
    let (min, max) = range.split_once(" … ").unwrap_or((range, range));
    let value = |text: &str| ScaledValue { value: text.into(), ..ScaledValue::default() };
    let range = ValueRange { min: value(min), max: value(max), step: step.map(value) };
    parameter.allowed_values.get_or_insert_with(AllowedValues::default).ranges.push(range);
}

/// The maximum depth of groups; names of deeper ones are part of the last.
const MAX_DEPTH: usize = 8;

/// Adds a parameter to the group of a path, `Drive / Limits`.
fn group(mut groups: &mut Vec<ParameterGroup>, path: &str, id: &str) {
    let mut names = path.splitn(MAX_DEPTH, " / ").enumerate().peekable();
    while let Some((depth, name)) = names.next() {
        let is_it = |group: &ParameterGroup| group.labels.name_in(LANGUAGE) == Some(name);
        let at = groups.iter().position(is_it).unwrap_or(groups.len());
        if at == groups.len() {
            let unique_id = format!("UID_PG_{id}_{depth}_{at}").into();
            let labels = Labels::name(LANGUAGE, name);
            groups.push(ParameterGroup { unique_id, labels, ..ParameterGroup::default() });
        }
        if names.peek().is_none() {
            groups[at].parameters.push(id.into());
        }
        groups = &mut groups[at].groups;
    }
}
