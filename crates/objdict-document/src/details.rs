//! Details that only some entries have: units, names of values, bit fields, denotations, vendor-specific
//! keys; and the state machine and the error codes that the device profile defines.

use std::ops::RangeInclusive;

use super::anchor::Anchor;
use super::context::Context;
use crate::Language;
use crate::describe::single_codes;
use crate::model::{Entry, Field, Meaning, Parameter, Scaling};
use crate::profile::{self, BitFieldFacts, EntryFacts, ObjectFacts, Profile, Transition, Values};

/// Fields shown elsewhere on a page.
pub(super) const VALUES: [Field; 4] =
    [Field::DefaultValue, Field::ParameterValue, Field::LowLimit, Field::HighLimit];

/// Further details of an entry.
#[derive(Debug, Default)]
pub(crate) struct Details<'a> {
    /// The description text, possibly several lines.
    pub(crate) description: Option<String>,
    /// The unit of the engineering value with its scaling.
    pub(crate) unit: Option<String>,
    /// The application-specific name.
    pub(crate) denotation: Option<String>,
    /// The PDOs that map it: `TPDO 1`.
    pub(crate) carried_by: Vec<String>,
    /// Named values.
    pub(crate) values: Vec<(i128, &'a str)>,
    /// Bit fields as named in the description.
    pub(crate) parts: Vec<BitPart<'a>>,
    /// Bit fields as named in CiA documents.
    pub(crate) word: Vec<BitPart<'static>>,
    /// The entry that shows the same bit fields.
    pub(crate) word_of: Option<Anchor>,
    /// The values allowed by a CiA document, if the description has no limits.
    pub(crate) allowed: Option<String>,
    /// Further properties with their labels.
    pub(crate) facts: Vec<(&'static str, String)>,
    /// Vendor-specific or tool-specific keys, as in the file.
    pub(crate) keys: Vec<(String, String)>,
}

/// A bit field.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct BitPart<'a> {
    pub(crate) first: u8,
    pub(crate) last: u8,
    pub(crate) name: &'a str,
    pub(crate) values: Vec<(String, &'a str)>,
}

impl BitPart<'_> {
    /// `3` or `4–7`.
    pub(crate) fn range(&self) -> String {
        if self.first == self.last {
            self.first.to_string()
        } else {
            format!("{}–{}", self.first, self.last)
        }
    }
}

impl Details<'_> {
    /// Whether there are no details.
    pub(crate) fn is_empty(&self) -> bool {
        self.description.is_none()
            && self.has_no_facts()
            && self.values.is_empty()
            && self.parts.is_empty()
            && self.word.is_empty()
            && self.word_of.is_none()
    }

    /// Whether there is nothing to show next to the name.
    pub(crate) fn has_no_facts(&self) -> bool {
        self.unit.is_none()
            && self.allowed.is_none()
            && self.denotation.is_none()
            && self.carried_by.is_empty()
            && self.facts.is_empty()
            && self.keys.is_empty()
    }
}

impl Details<'_> {
    /// Adds the definitions of CiA documents for an entry in addition to its description.
    pub(super) fn add_documents(&mut self, sub: u8, entry: &Entry, documents: &[ObjectFacts<'static>]) {
        let facts = || documents.iter().filter_map(|facts| facts.entry(sub));
        if self.values.is_empty() && self.parts.is_empty() {
            let fields = profile::bits(documents.iter().copied(), sub);
            self.word = fields.iter().map(BitPart::of_document).collect();
        }
        if self.unit.is_none() {
            self.unit = facts().find_map(|facts| facts.unit).map(str::to_owned);
        }
        let is_count = |facts: &EntryFacts<'_>| sub == 0 && !facts.name.is_empty();
        let has_limits = entry.low_limit.is_some() || entry.high_limit.is_some();
        if !has_limits && self.word.is_empty() {
            let stated = facts().find(|facts| !facts.values.is_empty() && !is_count(facts));
            self.allowed = stated.map(|facts| ranges(facts.values));
        }
    }
}

impl BitPart<'static> {
    fn of_document(field: &BitFieldFacts<'static>) -> Self {
        let values = field.masked().into_iter().map(|(values, name)| (shown(&values), name));
        Self { first: field.first, last: field.last, name: field.name, values: values.collect() }
    }
}

/// `0, 2 … 240`.
fn ranges(values: &[RangeInclusive<i128>]) -> String {
    let ranges = values.iter().map(|range| match (range.start(), range.end()) {
        (first, last) if first == last => first.to_string(),
        (first, last) => format!("{first} … {last}"),
    });
    ranges.collect::<Vec<_>>().join(", ")
}

/// The details of an entry beyond name, type, access and values.
pub(super) fn of<'a>(context: &Context<'a>, index: u16, sub: u8, entry: &Entry) -> Details<'a> {
    let mut details = Details { carried_by: context.carriers(index, sub), ..Details::default() };
    match context.meanings.as_ref().and_then(|meanings| meanings.of(index, sub)) {
        None => {}
        Some(Meaning::Enumeration(found)) => {
            details.values = found.values.iter().map(|value| (value.number, value.name)).collect();
        }
        Some(Meaning::BitStruct(word)) => {
            let part = |field: &crate::model::BitField<'a>| BitPart {
                first: field.first,
                last: field.first + (field.bits - 1),
                name: field.name,
                values: field
                    .values
                    .iter()
                    .flat_map(|values| &values.values)
                    .map(|value| (value.number.to_string(), value.name))
                    .collect(),
            };
            details.parts = word.fields.iter().map(part).collect();
        }
    }
    if !is_plain(entry) {
        of_own(context, entry, &mut details);
    }
    details
}

/// Details stated for this entry only.
fn of_own(context: &Context<'_>, entry: &Entry, details: &mut Details<'_>) {
    if let Some(parameter) = &entry.parameter {
        of_parameter(context, parameter, details);
    }
    of_configuration(context, entry, details);
    of_flags(context, entry, details);
    if let Some(stack) = &entry.stack {
        details.keys.extend(stack.settings().map(|(key, value)| (key.to_owned(), value)));
    }
    details.keys.extend(entry.extra.iter().map(|(key, value)| (key.to_owned(), value.to_owned())));
    // invalid values are shown instead of the values
    let others = entry.invalid_values.iter().filter(|invalid| !VALUES.contains(&invalid.field));
    details.keys.extend(others.map(|invalid| (invalid.field.to_string(), format!("`{}`?", invalid.text))));
}

/// The details of an object beyond the name and the entries.
pub(super) fn of_object<'a>(context: &Context<'a>, main: &'a Entry) -> Details<'a> {
    let mut details = Details::default();
    if !is_plain(main) {
        of_own(context, main, &mut details);
    }
    details
}

/// Whether an entry has no details, like most entries.
fn is_plain(entry: &Entry) -> bool {
    entry.parameter.is_none()
        && entry.configured.is_none()
        && entry.flags.is_none()
        && entry.safety.is_none()
        && entry.stack.is_none()
        && entry.extra.is_empty()
        && entry.invalid_values.is_empty()
}

fn of_parameter(context: &Context<'_>, parameter: &Parameter, details: &mut Details<'_>) {
    let text = parameter.labels.description_in(context.tag).filter(|text| !text.trim().is_empty());
    details.description = text.map(str::to_owned);
    details.unit = scaled_unit(context, parameter);
    details.denotation =
        parameter.denotation.name_in(context.tag).filter(|text| !text.is_empty()).map(str::to_owned);
    let language = context.language;
    let mut fact = |name: &'static str, text: String| details.facts.push((name, text));
    if let Some(value) = &parameter.substitute_value {
        fact(language.pick("substitute value", "Ersatzwert"), value.value.to_string());
    }
    if parameter.persistent == Some(true) {
        fact(language.pick("persistent", "nichtflüchtig"), language.pick("yes", "ja").to_owned());
    }
    if let Some(support) = parameter.support {
        fact(language.pick("support", "Unterstützung"), support.name().to_owned());
    }
    for range in parameter.allowed_values.iter().flat_map(|allowed| &allowed.ranges) {
        let step = range.step.as_ref().map(|step| match language {
            Language::English => format!(", in steps of {}", step.value),
            Language::German => format!(", in Schritten von {}", step.value),
        });
        let text = format!("{} … {}{}", range.min.value, range.max.value, step.unwrap_or_default());
        fact(language.pick("allowed", "erlaubt"), text);
    }
    let properties = parameter.properties.iter();
    details.keys.extend(properties.map(|property| (property.name.to_string(), property.value.to_string())));
}

/// `mm`, `mm (× 0.001) = (value + 5) × 0.1`: the symbol of the unit, and the formula of the
/// engineering value.
fn scaled_unit(context: &Context<'_>, parameter: &Parameter) -> Option<String> {
    let Scaling { unit, offset, multiplier } = context.meanings.as_ref()?.scaling(parameter);
    let mut text =
        unit.and_then(|unit| unit.labels.name_in(context.tag)).unwrap_or_default().trim().to_owned();
    if let Some(base) = unit.map(|unit| unit.multiplier.trim()).filter(|factor| !matches!(*factor, "" | "1"))
    {
        text.push_str(&format!(" (× {base})"));
    }
    let factor = multiplier.filter(|factor| *factor != "1");
    let offset = offset.filter(|offset| *offset != "0");
    let value = context.language.pick("value", "Wert");
    let formula = match (offset, factor) {
        (None, None) => None,
        (None, Some(factor)) => Some(format!("{value} × {factor}")),
        (Some(offset), None) => Some(format!("{value} + {offset}")),
        (Some(offset), Some(factor)) => Some(format!("({value} + {offset}) × {factor}")),
    };
    let parts: Vec<String> = Some(text).filter(|text| !text.is_empty()).into_iter().chain(formula).collect();
    if parts.is_empty() { None } else { Some(parts.join(" = ")) }
}

fn of_configuration(context: &Context<'_>, entry: &Entry, details: &mut Details<'_>) {
    let Some(configured) = &entry.configured else { return };
    if let Some(denotation) = configured.denotation.as_deref().filter(|text| !text.is_empty()) {
        details.denotation = Some(denotation.to_owned());
    }
    let language = context.language;
    let texts = [
        (language.pick("upload file", "Upload-Datei"), &configured.upload_file),
        (language.pick("download file", "Download-Datei"), &configured.download_file),
        (language.pick("reference", "Referenzkennzeichen"), &configured.reference_designator),
    ];
    for (name, text) in texts {
        if let Some(text) = text.as_deref().filter(|text| !text.is_empty()) {
            details.facts.push((name, text.to_owned()));
        }
    }
}

fn of_flags(context: &Context<'_>, entry: &Entry, details: &mut Details<'_>) {
    let language = context.language;
    let mut fact = |name: &'static str, text: String| details.facts.push((name, text));
    let tool = language.pick("configuration tool", "Konfigurationswerkzeug");
    if entry.flags().refuses_write() {
        fact(tool, language.pick("does not write it", "schreibt ihn nicht").to_owned());
    }
    if entry.flags().refuses_read() {
        fact(tool, language.pick("does not read it", "liest ihn nicht").to_owned());
    }
    let Some(safety) = &entry.safety else { return };
    if safety.srdo_mapping == Some(true) {
        fact("SRDO", language.pick("may be mapped", "abbildbar").to_owned());
    }
    if let Some(inverted) = safety.inverted_srad.filter(|&place| place != 0) {
        let [sub, _, low, high] = inverted.to_le_bytes();
        let place = Anchor::entry(u16::from_le_bytes([low, high]), sub).spoken();
        fact(language.pick("inverted value", "invertierter Wert"), place);
    }
}

/// A state machine in tables.
pub(crate) struct StatesView {
    /// `CiA 402`.
    pub(crate) document: &'static str,
    /// The object with the state, and the object that receives commands.
    pub(crate) objects: [Anchor; 2],
    /// The bits of the first object in each state.
    pub(crate) states: Vec<(String, &'static str)>,
    /// The bits of each command in the second one.
    pub(crate) commands: Vec<(&'static str, &'static str)>,
    pub(crate) transitions: Vec<Transition<'static>>,
}

/// An error code of EMCY with its meaning.
pub(crate) type ErrorCode = (String, &'static str);

/// The state machine of a device that has both of its objects.
pub(super) fn states(context: &Context<'_>) -> Option<StatesView> {
    let profile = profile::of_device(context.device)?;
    let machine = profile.state_machine()?;
    let objects = [machine.status, machine.command];
    if !objects.iter().all(|index| context.device.object(*index).is_some()) {
        return None;
    }
    let states = machine.states.into_iter().map(|(values, name)| (shown(&values), name));
    Some(StatesView {
        document: &profile.document,
        objects: objects.map(Anchor::object),
        states: states.collect(),
        commands: machine.commands,
        transitions: machine.transitions,
    })
}

/// The values as text: `x01x 0111`, `3`, `4–7`.
pub(super) fn shown(values: &Values) -> String {
    match values {
        Values::Mask(mask) => mask.clone(),
        Values::Range(range) if range.start() == range.end() => range.start().to_string(),
        Values::Range(range) => format!("{}–{}", range.start(), range.end()),
    }
}

/// The error codes of a device whose profile defines some, including those of communication.
pub(super) fn error_codes(context: &Context<'_>) -> Vec<ErrorCode> {
    let errors = profile::of_device(context.device).map(Profile::errors).filter(|errors| errors.len() > 0);
    let Some(errors) = errors else { return Vec::new() };
    let of_profile = errors.map(|(codes, name)| match (codes.start(), codes.end()) {
        (first, last) if first == last => (format!("0x{first:04X}"), name),
        (first, last) => (format!("0x{first:04X}–0x{last:04X}"), name),
    });
    let single = single_codes(context.language).map(|(code, name)| (format!("0x{code:04X}"), name));
    let mut codes: Vec<ErrorCode> = of_profile.chain(single).collect();
    codes.sort();
    codes
}
