//! The rules that check one object or one entry at a time, and their cached findings in unchanged objects.

use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Object, Objects};
use crate::{Check, EntryAt, EntryOwner, Rule};

/// The objects of a device with the findings of the rules that depend only on the object. The findings are reused while
/// a device shares the object.
#[derive(Clone, Debug, Default)]
pub struct KnownObjects {
    /// The ids of these rules.
    rules: Vec<&'static str>,
    objects: Objects,
    /// The findings of the objects that have some.
    found: BTreeMap<u16, Vec<Diagnostic>>,
    checked: usize,
}

impl KnownObjects {
    /// The number of objects that the last check examined.
    pub fn checked(&self) -> usize {
        self.checked
    }
}

/// The checks of objects and entries, by their dependencies.
#[derive(Default)]
struct ObjectChecks {
    /// The ids of the rules that depend only on the object.
    alone: Vec<&'static str>,
    objects: Vec<fn(u16, &Object, &mut Findings)>,
    entries: Vec<fn(&EntryAt<'_>, &mut Findings)>,
    objects_of: Vec<fn(&Device, u16, &Object, &mut Findings)>,
    entries_of: Vec<fn(&Device, &EntryAt<'_>, &mut Findings)>,
}

impl ObjectChecks {
    fn of(rules: &[&'static Rule]) -> Self {
        let mut checks = Self::default();
        for rule in rules {
            match rule.check {
                Check::Object(check) => checks.objects.push(check),
                Check::Entry(check) => checks.entries.push(check),
                Check::ObjectOf(check) => checks.objects_of.push(check),
                Check::EntryOf(check) => checks.entries_of.push(check),
                _ => {}
            }
            if matches!(rule.check, Check::Object(_) | Check::Entry(_)) {
                checks.alone.push(rule.info.id);
            }
        }
        checks
    }

    fn object(&self, index: u16, object: &Object, findings: &mut Findings) {
        self.objects.iter().for_each(|check| check(index, object, findings));
        self.entries(EntryOwner::Device, index, object, findings);
    }

    fn entries(&self, origin: EntryOwner, index: u16, object: &Object, findings: &mut Findings) {
        for (sub, entry) in object.described() {
            let at = EntryAt { origin, index, object, sub, entry };
            self.entries.iter().for_each(|check| check(&at, findings));
        }
    }

    fn entries_of(
        &self,
        device: &Device,
        origin: EntryOwner,
        (index, object): (u16, &Object),
        findings: &mut Findings,
    ) {
        for (sub, entry) in object.described() {
            let at = EntryAt { origin, index, object, sub, entry };
            self.entries_of.iter().for_each(|check| check(device, &at, findings));
        }
    }

    /// Checks the unknown objects, adds the cached findings of the others, and caches all of them.
    fn unknown(&self, device: &Device, known: &mut KnownObjects, findings: &mut Findings) {
        let before = std::mem::take(known);
        let is_same = before.rules == self.alone;
        for (&index, object) in &device.objects {
            let first = findings.len();
            if is_same && device.objects.shares(&before.objects, &index) {
                let found = before.found.get(&index).into_iter().flatten();
                found.for_each(|finding| findings.push(finding.clone()));
            } else {
                known.checked += 1;
                self.object(index, object, findings);
            }
            if findings.len() > first {
                known.found.insert(index, findings.iter().skip(first).cloned().collect());
            }
        }
        known.rules.clone_from(&self.alone);
        known.objects = device.objects.clone();
    }
}

/// The walks over the objects: one for all rules that depend only on the object, one for those that also depend on the
/// device, and one over the objects of modules.
pub(crate) fn check(
    device: &Device,
    rules: &[&'static Rule],
    is_asked: &dyn Fn(u16) -> bool,
    known: Option<&mut KnownObjects>,
    findings: &mut Findings,
) {
    let checks = ObjectChecks::of(rules);
    let asked = || device.objects.iter().filter(|(index, _)| is_asked(**index));
    match known {
        Some(known) => checks.unknown(device, known, findings),
        None => asked().for_each(|(&index, object)| checks.object(index, object, findings)),
    }
    for (&index, object) in asked() {
        checks.objects_of.iter().for_each(|check| check(device, index, object, findings));
        checks.entries_of(device, EntryOwner::Device, (index, object), findings);
    }
    let mut entries = |origin, index, object: &Object| {
        checks.entries(origin, index, object, findings);
        checks.entries_of(device, origin, (index, object), findings);
    };
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        module.fixed.iter().for_each(|(&index, object)| entries(EntryOwner::Fixed(number), index, object));
        for (&index, extension) in &module.extensions {
            let mut object = Object { main: extension.entry.clone(), ..Object::default() };
            // some descriptions state the type of the extended object
            object.main.object_type = object.main.object_type.filter(|object_type| !object_type.has_subs());
            entries(EntryOwner::Extension(number), index, &object);
        }
    }
}
