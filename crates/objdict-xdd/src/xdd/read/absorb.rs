//! Moves the properties of an entry from its parameter to the entry; the others remain in the parameter.

use crate::diagnostic::Findings;
use crate::literal::{self, Quirks};
use crate::model::{
    Access, AllowedValues, DataType, DataTypeRef, Definitions, Entry, Field, Label, Labels, ObjectType,
    Parameter, ParameterAccess, PdoMapping, Place, ScaledValue, ValueRange,
};
use crate::xdd::defaults::written_access;
use crate::xdd::fact::{self, stated_text};
use crate::xdd::schema::Slots;
use crate::xdd::types;

/// Fills the entry at `place`, whose data type is known, from its parameter, and removes the used properties
/// from the parameter. The attributes of the entry have priority; conflicting values remain in the
/// parameter.
pub(crate) fn absorb(
    entry: &mut Entry,
    parameter: &mut Parameter,
    definitions: &Definitions<'_>,
    place: &Place,
    findings: &mut Findings,
) {
    name(entry, &mut parameter.labels);
    let template = definitions.template(parameter);
    access(entry, parameter, template);
    let data_type = entry.implied_type();
    let mut values = EntryValues { entry, data_type, place, findings };
    values.take(parameter, definitions);
    if let Some(template) = template {
        values.take(&mut template.clone(), definitions);
    }
    denotation(entry, &mut parameter.denotation);
}

/// The name of an entry without an attribute for it; a parameter without other texts needs no label.
pub(crate) fn name(entry: &mut Entry, labels: &mut Labels) {
    if entry.name.is_empty()
        && let Some(name) = labels.names().next().map(|(_, name)| name.trim_ascii())
    {
        entry.name = name.into();
    }
    if is_only(labels, &entry.name) {
        *labels = Labels::default();
    }
}

/// Whether the labels are a single English name.
fn is_only(labels: &Labels, name: &str) -> bool {
    matches!(&labels.0[..], [Label::Name { lang, text }] if &**lang == "en" && &**text == name)
}

/// The data type of an entry without an attribute for it.
pub(crate) fn data_type(entry: &mut Entry, parameter: &mut Parameter, definitions: &Definitions<'_>) {
    let object_type = entry.object_type;
    let template = definitions.template(parameter);
    let stated = parameter.data_type.as_ref().or(template.and_then(|template| template.data_type.as_ref()));
    if entry.data_type.is_none() {
        let simple = stated.and_then(|reference| definitions.simple(reference, None));
        entry.data_type = simple.map(|simple| types::data_type(simple, object_type));
    }
    let written = entry.data_type.map(types::simple_type).map(DataTypeRef::Simple);
    if written.is_some() && parameter.data_type == written {
        parameter.data_type = None;
    }
}

/// The access type of an entry. Only the parameter can specify rwr and rww; without any access type the
/// entry is readable, and a DOMAIN also writable (CiA 306-1 §4.6.3.2).
fn access(entry: &mut Entry, parameter: &mut Parameter, template: Option<&Parameter>) {
    let stated = parameter.access.or(template.and_then(|template| template.access));
    let unstated = match entry.object_type {
        Some(ObjectType::Domain) => ParameterAccess::ReadWrite,
        _ => ParameterAccess::Read,
    };
    let stated = stated.unwrap_or(unstated);
    let access = Access::ALL.into_iter().find(|access| written_access(*access) == stated);
    let is_invalid = entry.invalid_values.get(&Field::AccessType).is_some();
    match (entry.access, access) {
        (Some(Access::Rw), Some(Access::Rwr | Access::Rww)) => entry.access = access,
        (None, _) if !is_invalid => entry.access = access,
        _ => {}
    }
    // some versions of CANopenEditor confuse input and output, but not the directions of PDOs
    let other = match (entry.access, entry.pdo_mapping) {
        (Some(Access::Rwr), Some(PdoMapping::Rpdo)) => Some(Access::Rww),
        (Some(Access::Rww), Some(PdoMapping::Tpdo)) => Some(Access::Rwr),
        _ => None,
    };
    if other.is_some() {
        (entry.access, parameter.access) = (other, None);
    }
    if entry.access.is_some_and(|access| parameter.access == Some(written_access(access))) {
        parameter.access = None;
    }
}

/// The values of an entry.
struct EntryValues<'a> {
    entry: &'a mut Entry,
    data_type: Option<DataType>,
    place: &'a Place,
    findings: &'a mut Findings,
}

impl EntryValues<'_> {
    /// Moves all values of a parameter.
    fn take(&mut self, parameter: &mut Parameter, definitions: &Definitions<'_>) {
        self.absorb(Slots::Default, &mut parameter.default_value);
        self.range(&mut parameter.allowed_values, definitions);
        self.absorb(Slots::Actual, &mut parameter.actual_value);
    }

    /// Moves a value from the parameter to the entry; it remains in the parameter if the entry cannot store
    /// all of it.
    fn absorb(&mut self, slot: Slots, value: &mut Option<ScaledValue>) {
        if value.as_ref().is_some_and(|value| self.fill(slot, value)) {
            *value = None;
        }
    }

    /// Moves the limits if the parameter allows only ranges; of several, the outer limits. The parameter keeps
    /// the rest.
    fn range(&mut self, allowed: &mut Option<AllowedValues>, definitions: &Definitions<'_>) {
        let Some(stated) = allowed.as_ref() else { return };
        let AllowedValues { values, ranges, .. } = definitions.allowed(stated);
        if !values.is_empty() {
            return;
        }
        let Some((min, max)) = outer_limits(ranges, self.data_type) else { return };
        // no short circuit: both limits are filled
        let is_stated = self.fill(Slots::Low, min) & self.fill(Slots::High, max);
        let is_own = stated.template.is_none();
        let is_all = matches!(&ranges[..], [ValueRange { step: None, .. }]);
        if is_stated && is_own && is_all {
            *allowed = None;
        }
    }

    /// Fills a missing value. Returns whether the entry then contains everything that the parameter states.
    fn fill(&mut self, slot: Slots, value: &ScaledValue) -> bool {
        let is_plain = value.offset.is_none() && value.multiplier.is_none() && value.labels.is_empty();
        let Some(text) = stated_text(&value.value, self.data_type) else { return is_plain };
        if let Some(invalid) = self.entry.invalid_values.get(&slot.field()) {
            return is_plain && &*invalid.text == text;
        }
        let mut quirks = Quirks::default();
        let read = fact::read_value(text, self.data_type, &mut quirks).map(|value| match slot {
            Slots::High => literal::high_limit(value, self.entry, &mut quirks),
            _ => value,
        });
        if let Some(own) = slot.get(self.entry) {
            return is_plain && read.as_ref() == Ok(own);
        }
        match read {
            Ok(value) => {
                let at = self.place.clone().field(slot.field());
                literal::spelling(text, at, quirks, Some(&value), self.findings);
                slot.set(self.entry, value);
            }
            Err(reason) => self.entry.invalid_values.push(slot.field(), text, reason),
        }
        is_plain
    }
}

/// The lowest minimum and the highest maximum; `None` if there are several ranges that cannot be compared.
fn outer_limits(ranges: &[ValueRange], data_type: Option<DataType>) -> Option<(&ScaledValue, &ScaledValue)> {
    if let [ValueRange { min, max, .. }] = ranges {
        return Some((min, max));
    }
    let number = |value: &ScaledValue| {
        let text = stated_text(&value.value, data_type)?;
        fact::read_value(text, data_type, &mut Quirks::default()).ok()?.as_real()
    };
    let limits =
        ranges.iter().map(|ValueRange { min, max, .. }| Some(((number(min)?, min), (number(max)?, max))));
    limits
        .collect::<Option<Vec<_>>>()?
        .into_iter()
        .fold(None, |outer, (min, max)| {
            let Some((low, high)) = outer else { return Some((min, max)) };
            Some((if min.0 < low.0 { min } else { low }, if max.0 > high.0 { max } else { high }))
        })
        .map(|(low, high)| (low.1, high.1))
}

/// The name of the entry in the application. An English name moves to the entry; others also remain in
/// the parameter.
fn denotation(entry: &mut Entry, labels: &mut Labels) {
    let Some(name) = labels.name_in("en") else { return };
    let own = entry.configured.as_ref().and_then(|configured| configured.denotation.clone());
    let denotation = match own {
        Some(own) => own,
        None => {
            let name: Box<str> = name.trim_ascii().into();
            if !name.is_empty() {
                entry.configured_mut().denotation = Some(name.clone());
            }
            name
        }
    };
    if is_only(labels, &denotation) {
        *labels = Labels::default();
    }
}
