//! Whether the versions of device and description match the changes.

use std::cmp::Ordering;

use super::{Audience, DeviceChange, DeviceComparison, Spot, rules};
use crate::diagnostic::say;
use crate::model::{ClockTime, Date, Device, DeviceKind, Field, FileInfo, Identity, Part, Place};

impl DeviceComparison<'_> {
    pub(super) fn versions(&mut self) {
        // a configured node has the versions of its device
        let are_types =
            [self.old.device, self.new.device].iter().all(|device| device.kind == DeviceKind::Type);
        self.revision(are_types);
        if !are_types {
            return;
        }
        self.product_code();
        if !self.changes.is_empty() {
            self.file_version();
            self.modification_date();
        }
    }

    fn revision(&mut self, are_types: bool) {
        let identities = [self.old.device, self.new.device].map(|device| device.identity().revision_number);
        let [Some(old), Some(new)] = identities else { return };
        let place = |device: &Device| Some(device.value_place(Identity::INDEX, 3));
        let at = [place(self.old.device), place(self.new.device)];
        let [old_place, new_place] = at;
        let spot = Spot {
            index: Some(Identity::INDEX),
            sub: Some(3),
            old: old_place,
            new: new_place,
            ..Spot::part(&Place::device())
        };
        let shown = |revision: u32| format!("{}.{}", revision >> 16, revision & 0xFFFF);
        let values = [Some(shown(old)), Some(shown(new))];
        if new < old {
            let message = say!("the revision number decreases from {} to {}", shown(old), shown(new));
            return self.report(&rules::REVISION_LOWERED, &spot, values, message);
        }
        let reason = self.changes.iter().find(|change| are_types && is_behaviour(change));
        if let Some(reason) = reason.filter(|_| new >> 16 == old >> 16) {
            let message = say!(
                "the major revision number is still {} ({}, then {}): {}",
                old >> 16,
                shown(old),
                shown(new),
                reason.message.clone(),
            );
            self.report(&rules::REVISION_NOT_RAISED, &spot, values, message);
        } else if new > old {
            // a different behaviour needs a different configuration anyway
            let affected = spot.affected.without(Audience::Configurations, reason.is_none());
            let message = say!("the revision number increases from {} to {}", shown(old), shown(new));
            self.report(&rules::REVISION_RAISED, &Spot { affected, ..spot }, values, message);
        }
    }

    fn product_code(&mut self) {
        let profile = |device: &Device| device.profile();
        let (Some(old), Some(new)) = (profile(self.old.device), profile(self.new.device)) else { return };
        let codes = [self.old.device, self.new.device].map(|device| device.identity().product_code);
        let [Some(code), Some(same)] = codes else { return };
        if old == new || code != same {
            return;
        }
        let place = Place::object(Identity::INDEX);
        let spot = Spot { index: Some(Identity::INDEX), sub: Some(2), ..Spot::part(&place) };
        let message =
            say!("the profile changes from CiA {} to {}, but the product code is still {}", old, new, code);
        let values = [Some(code.to_string()), Some(code.to_string())];
        self.report(&rules::PRODUCT_CODE_NOT_CHANGED, &spot, values, message);
    }

    fn file_version(&mut self) {
        let version = |device: &Device| {
            let info = device.file_info.as_ref()?;
            Some((info.file_version?, info.file_revision?))
        };
        let (Some(old), Some(new)) = (version(self.old.device), version(self.new.device)) else { return };
        if new > old {
            return;
        }
        let shown = |(version, revision): (u8, u8)| format!("{version}.{revision}");
        let spot = Spot::part(&Place::of(Part::FileInfo).field(Field::FileRevision));
        let message = match new.cmp(&old) {
            Ordering::Equal => say!("the file version is still {}", shown(old)),
            _ => say!("the file version decreases from {} to {}", shown(old), shown(new)),
        };
        self.report(&rules::FILE_VERSION_NOT_RAISED, &spot, [Some(shown(old)), Some(shown(new))], message);
    }

    fn modification_date(&mut self) {
        let date = |info: &FileInfo| Some((info.modification_date?, info.modification_time));
        let dates = [self.old.device, self.new.device].map(|device| device.file_info.as_ref().and_then(date));
        let [Some(old), Some(new)] = dates else { return };
        if new > old {
            return;
        }
        let spot = Spot::part(&Place::of(Part::FileInfo).field(Field::ModificationDate));
        let shown = |(date, time): (Date, Option<ClockTime>)| {
            let time = time.map(|time| format!(" {}", time.to_iso(false)));
            format!("{}{}", date.to_iso(), time.unwrap_or_default())
        };
        let message = match new == old {
            true => say!("the modification date is still {}", shown(new)),
            false => say!("the modification date is {}, earlier than {}", shown(new), shown(old)),
        };
        let values = [Some(shown(old)), Some(shown(new))];
        self.report(&rules::MODIFICATION_DATE_NOT_MOVED, &spot, values, message);
    }
}

/// Whether a change affects the behaviour on the bus, and not just names, the use by the network, or initial values.
pub(super) fn is_behaviour(change: &DeviceChange) -> bool {
    let is_of = |rules: &[&rules::ChangeRule]| rules.iter().any(|rule| std::ptr::eq(*rule, change.rule));
    let is_on_the_bus = change.effects().any(|effect| {
        matches!(effect.audience, Audience::SdoClients | Audience::PdoConsumers | Audience::Configurations)
    });
    is_on_the_bus
        && !is_of(&[
            &rules::OBJECT_RENAMED,
            &rules::ENTRY_RENAMED,
            &rules::NAME_RESPELLED,
            &rules::ARRAY_OR_RECORD,
            &rules::DATA_TYPE_STATED,
            &rules::CONSTANT_CHANGED,
            &rules::VALUE_RENAMED,
            &rules::UNIT_CHANGED,
            &rules::UNIT_STATED,
            &rules::DEFAULT_CHANGED,
            &rules::DEFAULT_STATED,
            &rules::ACCESS_UNKNOWN,
            &rules::READ_ONLY_DEFAULT_CHANGED,
            &rules::READ_LIMITS_WIDENED,
            &rules::READ_LIMITS_NARROWED,
            &rules::CONFIGURED_VALUE_CHANGED,
            &rules::FLAGS_CHANGED,
            &rules::STORAGE_CHANGED,
            &rules::DATA_CHANGED,
            &rules::DEVICE_FACT_CHANGED,
            &rules::IDENTITY_CHANGED,
            &rules::NODE_CHANGED,
            &rules::NODE_FACT_CHANGED,
        ])
}
