//! The versions to bump before a new description is released: findings of the rules about versions, with
//! fixes.

use super::rules::{self, ChangeRule};
use super::{DeviceChange, compare, versions};
use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{ClockTime, Date, Device, DeviceInfo, Field, Identity, Part, Place};

/// Information for a release that is not in the descriptions.
#[derive(Clone, Copy, Debug)]
pub struct ReleaseFacts {
    /// The new date of the description.
    pub date: Date,
    /// The time of that day.
    pub time: ClockTime,
    /// The product code of the new device, if it needs a different one: only its vendor knows it.
    pub product_code: Option<u32>,
}

/// Revision number, product code, version and date of the new description that do not match the changes, each with a
/// fix if the new value is known.
pub fn release(old: &Device, new: &Device, facts: &ReleaseFacts) -> Findings {
    let changes = compare(old, new);
    let raise = |change: &DeviceChange| FIXES.iter().find(|(rule, _)| std::ptr::eq(*rule, change.rule));
    let is_behaviour = changes.iter().any(|change| versions::is_behaviour(change) && raise(change).is_none());
    let release = Release { old, new, facts, is_behaviour };
    let found = changes.iter().filter_map(|change| {
        let (_, fix) = raise(change)?;
        let finding = change.finding();
        Some(match fix(&release) {
            Some(fix) => finding.help(fix.title.clone()).fix(fix),
            None => finding,
        })
    });
    let mut found: Vec<Diagnostic> = found.collect();
    found.extend(release.older_date(&found));
    let mut findings = Findings::new();
    found.into_iter().for_each(|finding| findings.push(finding));
    findings
}

type Raise = fn(&Release<'_>) -> Option<Fix>;

/// The rules about versions, with their fixes.
static FIXES: [(&ChangeRule, Raise); 5] = [
    (&rules::REVISION_NOT_RAISED, |release| release.revision()),
    (&rules::REVISION_LOWERED, |release| release.revision()),
    (&rules::PRODUCT_CODE_NOT_CHANGED, |release| release.product_code()),
    (&rules::FILE_VERSION_NOT_RAISED, |release| release.file_version()),
    (&rules::MODIFICATION_DATE_NOT_MOVED, |release| release.date()),
];

struct Release<'a> {
    old: &'a Device,
    new: &'a Device,
    facts: &'a ReleaseFacts,
    /// Whether a change affects the behaviour on the bus.
    is_behaviour: bool,
}

impl Release<'_> {
    /// The next major revision, or the current one of the device.
    fn revision(&self) -> Option<Fix> {
        let (major, _) = self.old.identity().revision()?;
        let wanted = match self.is_behaviour {
            true => u32::from(major.checked_add(1)?) << 16,
            false => self.old.identity().revision_number?,
        };
        let title = say!("bump the revision number to {}.{}", wanted >> 16, wanted & 0xFFFF);
        self.identity(Fix::safe(title), 3, wanted)
    }

    fn product_code(&self) -> Option<Fix> {
        let code = self.facts.product_code?;
        self.identity(Fix::safe(say!("write the product code {}", code)), 2, code)
    }

    /// Sets a number of the identity object, and of the device information if it is stated there.
    fn identity(&self, fix: Fix, sub: u8, number: u32) -> Option<Fix> {
        let stated = |of: fn(&DeviceInfo) -> Option<u32>| self.new.device_info.as_ref().and_then(of);
        let (field, stated) = match sub {
            2 => (Field::ProductNumber, stated(|info| info.product_number)),
            _ => (Field::RevisionNumber, stated(|info| info.revision_number)),
        };
        let text = format!("0x{number:08X}");
        let place = self.new.value_place(Identity::INDEX, sub);
        // the default of a compact object applies to all its sub-indexes
        let fix = (place.part != Part::Object(Identity::INDEX)).then(|| fix.set(place, text.clone()))?;
        Some(match stated {
            Some(_) => fix.set(Place::of(Part::DeviceInfo).field(field), text),
            None => fix,
        })
    }

    /// The next revision of the file, or the next version if it has no revision.
    fn file_version(&self) -> Option<Fix> {
        let info = self.old.file_info.as_ref()?;
        let (version, revision) = (info.file_version?, info.file_revision?);
        let (version, revision) = match revision.checked_add(1) {
            Some(revision) => (version, revision),
            None => (version.checked_add(1)?, 0),
        };
        let place = |field| Place::of(Part::FileInfo).field(field);
        let fix = Fix::safe(say!("bump the file version to {}.{}", version, revision));
        let fix = fix.set(place(Field::FileRevision), revision.to_string());
        let is_same = self.new.file_info.as_ref().and_then(|info| info.file_version) == Some(version);
        Some(if is_same { fix } else { fix.set(place(Field::FileVersion), version.to_string()) })
    }

    fn date(&self) -> Option<Fix> {
        let ReleaseFacts { date, time, .. } = self.facts;
        let place = |field| Place::of(Part::FileInfo).field(field);
        let fix = Fix::safe(say!("write the date {}", date.to_iso()));
        let fix = fix.set(place(Field::ModificationDate), date.to_string());
        let has_time = self.new.file_info.as_ref()?.modification_time.is_some();
        Some(if has_time { fix.set(place(Field::ModificationTime), time.to_string()) } else { fix })
    }

    /// A fix is a modification, so a date that moved already moves with it.
    fn older_date(&self, found: &[Diagnostic]) -> Option<Diagnostic> {
        let rule = &rules::MODIFICATION_DATE_NOT_MOVED.info;
        let is_found = found.iter().any(|finding| finding.rule.id == rule.id);
        let is_needed = found.iter().any(|finding| finding.fix.is_some()) && !is_found;
        let stated = self.new.file_info.as_ref()?.modification_date?;
        let is_older = is_needed && stated < self.facts.date;
        let fix = self.date().filter(|_| is_older)?;
        let place = Place::of(Part::FileInfo).field(Field::ModificationDate);
        let message = say!("the modification date is still {}, but the versions change", stated.to_iso());
        Some(Diagnostic::new(rule, place, message).help(fix.title.clone()).fix(fix))
    }
}
