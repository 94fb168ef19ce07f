//! What the values of entries mean.

use std::collections::{BTreeMap, HashMap};

use objdict::model::{Device, Meaning as Meant, Scaling};
use objdict::profile;

/// What a description or a CiA document says of the values of an entry.
#[derive(Default)]
pub(crate) struct ValueMeaning {
    pub(crate) unit: Option<String>,
    pub(crate) factor: Option<f64>,
    pub(crate) offset: Option<f64>,
    pub(crate) values: BTreeMap<i128, String>,
    /// Not bytes, which Python would have for `u8`.
    pub(crate) bits: BTreeMap<String, Vec<u16>>,
}

/// The meanings of all entries of a device that have one.
pub(crate) fn meanings(device: &Device) -> HashMap<(u16, u8), ValueMeaning> {
    let described = device.meanings();
    let mut found = HashMap::new();
    for (&index, object) in device.objects.iter() {
        let documents: Vec<_> = profile::of_object(device, index).map(|(_, facts)| facts).collect();
        for (sub, _) in object.entries() {
            let mut meaning = ValueMeaning::default();
            for facts in documents.iter().filter_map(|facts| facts.entry(sub)) {
                if meaning.unit.is_none() {
                    meaning.set_unit_of_document(facts.unit.unwrap_or_default());
                }
            }
            for field in profile::bits(documents.iter().copied(), sub) {
                meaning
                    .bits
                    .insert(field.name.to_owned(), (field.first.into()..=field.last.into()).collect());
            }
            let stated = object.subs.get(sub).or((sub == 0).then_some(&object.main));
            if let Some(entry) = stated {
                meaning.set_scaling(described.scaling_of(entry));
            }
            meaning.set_names(described.of(index, sub));
            if !meaning.is_empty() {
                found.insert((index, sub), meaning);
            }
        }
    }
    found
}

impl ValueMeaning {
    fn is_empty(&self) -> bool {
        let is_scaled = self.unit.is_some() || self.factor.is_some() || self.offset.is_some();
        !is_scaled && self.values.is_empty() && self.bits.is_empty()
    }

    /// The unit of a document, such as `0.1 % of the rated torque`.
    fn set_unit_of_document(&mut self, unit: &str) {
        let scaled = unit.split_once(' ').and_then(|(number, unit)| Some((number.parse().ok()?, unit)));
        let (factor, unit) = scaled.map_or((None, unit), |(factor, unit)| (Some(factor), unit));
        if !unit.is_empty() {
            (self.factor, self.unit) = (factor, Some(unit.to_owned()));
        }
    }

    /// What the description states replaces what the document says.
    fn set_scaling(&mut self, scaling: Scaling<'_>) {
        if scaling.is_empty() {
            return;
        }
        let number = |text: Option<&str>| text.and_then(|text| text.parse().ok());
        let unit = scaling.unit.and_then(|unit| unit.labels.name_in("en")).map(str::trim);
        (self.factor, self.offset) = (number(scaling.multiplier), number(scaling.offset));
        self.unit = unit.filter(|unit| !unit.is_empty()).map(ToOwned::to_owned);
    }

    fn set_names(&mut self, meaning: Option<Meant<'_>>) {
        match meaning {
            Some(Meant::Enumeration(names)) => {
                let named = names.values.into_iter().filter(|value| !value.name.is_empty());
                self.values = named.map(|value| (value.number, value.name.to_owned())).collect();
            }
            Some(Meant::BitStruct(word)) => {
                let bits = |first: u8, bits: u8| (first.into()..u16::from(first) + u16::from(bits)).collect();
                let fields = word.fields.into_iter();
                self.bits =
                    fields.map(|field| (field.name.to_owned(), bits(field.first, field.bits))).collect();
            }
            None => {}
        }
    }
}
