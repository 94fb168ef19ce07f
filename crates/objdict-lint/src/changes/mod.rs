//! The changes between two revisions of a device, by meaning, and their effect on each audience.
//!
//! Devices are compared as dictionaries of entries, regardless of order, spelling and storage.

mod audience;
mod device;
mod entries;
mod objects;
mod pdos;
mod release;
mod rest;
mod rules;
mod values;
mod versions;

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use self::audience::Affected;
pub use self::audience::{Audience, ChangeVerdict};
pub use self::release::{ReleaseFacts, release};
pub use self::rules::{ChangeImpact, ChangeRule, rules};
use crate::diagnostic::{Diagnostic, Severity, Text, say};
use crate::model::{Device, MappedObject, Meanings, ObjectList, Pdo, Place};

/// The group of the rules about changes.
pub const CHANGE: &str = "change";

/// A change.
#[derive(Clone, Debug)]
pub struct DeviceChange {
    /// Its kind.
    pub rule: &'static ChangeRule,
    /// The index of the object, in the old device if it has it; `None` for the device as a whole.
    pub index: Option<u16>,
    /// The sub-index of the entry; `None` for an object as a whole, or a PDO.
    pub sub: Option<u8>,
    /// The old value, in short; `None` if missing.
    pub old: Option<String>,
    /// The new value, in short; `None` if missing.
    pub new: Option<String>,
    /// The change as a sentence.
    pub message: Text,
    /// The place in the old description.
    pub old_place: Option<Place>,
    /// The place in the new description.
    pub new_place: Option<Place>,
    affected: Affected,
}

impl DeviceChange {
    /// The effect of the change on each affected audience.
    pub fn effects(&self) -> impl Iterator<Item = &'static ChangeImpact> + '_ {
        self.rule.effects.iter().filter(|effect| self.affected.has(effect.audience))
    }

    /// The worst of its effects.
    pub fn verdict(&self) -> ChangeVerdict {
        self.effects().map(|effect| effect.verdict).max().unwrap_or(ChangeVerdict::Compatible)
    }

    /// The audiences with this verdict.
    pub fn audiences(&self, verdict: ChangeVerdict) -> impl Iterator<Item = Audience> + '_ {
        self.effects().filter(move |effect| effect.verdict == verdict).map(|effect| effect.audience)
    }

    /// The change as a finding in one of the descriptions: at its place in the new one, if it exists there.
    pub fn finding(&self) -> Diagnostic {
        let place = self.new_place.as_ref().or(self.old_place.as_ref()).cloned();
        let severity = match self.verdict() {
            ChangeVerdict::Breaking => Severity::Error,
            ChangeVerdict::Risky => Severity::Warning,
            ChangeVerdict::Compatible => Severity::Note,
        };
        let finding =
            Diagnostic::new(&self.rule.info, place.unwrap_or(Place::device()), self.message.clone());
        finding.severity(severity).help(as_help(self.rule.info.remedy))
    }
}

/// The text of a page as the help of a finding: without initial capital and full stop.
fn as_help(remedy: &str) -> String {
    let mut characters = remedy.trim_end_matches('.').chars();
    let first = characters.next().map(|first| first.to_ascii_lowercase());
    first.into_iter().chain(characters).collect()
}

/// The changes from one device to another, in dictionary order; changes of the device as a whole come last.
pub fn compare(old: &Device, new: &Device) -> Vec<DeviceChange> {
    let (old, new) = (implied(old, new), implied(new, old));
    let (old, new) = (Side::new(&old), Side::new(&new));
    let mut comparison = DeviceComparison { old, new, moved: BTreeMap::new(), changes: Vec::new() };
    comparison.objects();
    comparison.pdos();
    comparison.device();
    comparison.rest();
    comparison.versions();
    comparison.changes
}

/// A device with its implied PDOs. If both imply an object, its presence in the lists is compared like other values; if
/// the other device describes the object, only the notation differs.
fn implied<'a>(device: &'a Device, other: &Device) -> Cow<'a, Device> {
    let mut implied = device.with_implicit_pdos();
    if let Cow::Owned(implied) = &mut implied {
        for list in ObjectList::ALL {
            let stated = device.lists.get(list);
            if let Some(members) = implied.lists.get_mut(list) {
                members.retain(|index| stated.contains(index) || other.objects.contains_key(index));
            }
        }
    }
    implied
}

/// The change of an identifier in generated code although the name of the entry is unchanged. The generators determine
/// the identifiers; `c` and `rust` are the old and the new one.
pub fn identifier_changed((index, sub): (u16, Option<u8>), c: [&str; 2], rust: [&str; 2]) -> DeviceChange {
    let place = Some(Place::at(index, sub));
    DeviceChange {
        rule: &rules::IDENTIFIER_CHANGED,
        index: Some(index),
        sub,
        old: Some(c[0].to_owned()),
        new: Some(c[1].to_owned()),
        message: say!("in C `{}` becomes `{}`, in Rust `{}` becomes `{}`", c[0], c[1], rust[0], rust[1]),
        old_place: place.clone(),
        new_place: place,
        affected: Affected::ALL,
    }
}

/// A download of a stored configuration that the new device rejects, with the reason. The code that verifies
/// configurations determines the rejections.
pub fn configuration_refused(index: u16, sub: u8, reason: &str) -> DeviceChange {
    let place = Some(Place::entry(index, sub));
    DeviceChange {
        rule: &rules::CONFIGURATION_REFUSED,
        index: Some(index),
        sub: Some(sub),
        old: None,
        new: None,
        message: Text::from(reason.to_owned()),
        old_place: place.clone(),
        new_place: place,
        affected: Affected::ALL,
    }
}

/// One of the devices.
struct Side<'a> {
    device: &'a Device,
    meanings: Meanings<'a>,
    /// The entries that a PDO carries.
    mapped: BTreeSet<(u16, u8)>,
}

impl<'a> Side<'a> {
    fn new(device: &'a Device) -> Self {
        let pdos: Vec<_> = device.pdos().collect();
        let mapped = pdos.iter().flat_map(Pdo::mapped).map(MappedObject::entry);
        Self { device, meanings: device.meanings(), mapped: mapped.collect() }
    }
}

struct DeviceComparison<'a> {
    old: Side<'a>,
    new: Side<'a>,
    /// Entries that are elsewhere in the new device.
    moved: BTreeMap<(u16, u8), (u16, u8)>,
    changes: Vec<DeviceChange>,
}

/// The location of a change: its place and the affected audiences.
#[derive(Clone)]
struct Spot {
    index: Option<u16>,
    sub: Option<u8>,
    old: Option<Place>,
    new: Option<Place>,
    affected: Affected,
}

impl Spot {
    /// A part of the device that is not an object.
    fn part(place: &Place) -> Self {
        let place = Some(place.clone());
        Self { index: None, sub: None, old: place.clone(), new: place, affected: Affected::ALL }
    }

    /// The place of a field.
    fn field(&self, field: &crate::model::Field) -> Self {
        let field = |place: &Option<Place>| place.clone().map(|place| place.field(field.clone()));
        Self { old: field(&self.old), new: field(&self.new), ..self.clone() }
    }
}

impl DeviceComparison<'_> {
    fn report(
        &mut self,
        rule: &'static ChangeRule,
        spot: &Spot,
        values: [Option<String>; 2],
        message: impl Into<Text>,
    ) {
        let [old, new] = values;
        let Spot { index, sub, old: old_place, new: new_place, affected } = spot.clone();
        let message = message.into();
        self.changes.push(DeviceChange {
            rule,
            index,
            sub,
            old,
            new,
            message,
            old_place,
            new_place,
            affected,
        });
    }
}
