//! Edits the text of a description to describe a different device, with as few edits as the format allows.
//!
//! The canonical EDS texts of both devices are compared key by key (`eds::stated`). The differences become
//! changes as in fixes; the rest is embedded.

use std::collections::BTreeMap;

use crate as format;
use crate::compare::{DatumChange, each_difference};
use crate::input::DEFAULT_MAX_ENTRIES;
use crate::{Description, EditError, Syntax, WriteOptions, embedded};
use objdict_eds::eds;
use objdict_model::diagnostic::{Change, Fix};
use objdict_model::model::{Device, Field, Object, ObjectList, Part, Place};
use objdict_model::source::Edits;

/// Changes a description's text to that of `wanted`: by edits if its format supports them, otherwise, in an EDS or DCF,
/// by embedding, otherwise by writing it from scratch.
///
/// # Errors
/// If the text cannot be written in the encoding of the file, or loses more values than a limit.
pub(crate) fn edited(original: &Description, wanted: &Device) -> Result<Description, EditError> {
    let options = WriteOptions {
        embed: true,
        max_losses: WriteOptions::max_losses_of(original.source().text().len(), DEFAULT_MAX_ENTRIES),
        ..WriteOptions::default()
    };
    let found =
        with_edits(original, wanted).and_then(|edited| with_embedded(edited, wanted, options.max_losses));
    if let Some(edited) = found.filter(|edited| edited.is_as_valid_as(original)) {
        return Ok(edited);
    }
    let bytes = format::write(wanted, original.format(), &options)?.bytes;
    original.with_bytes(bytes).ok_or_else(|| EditError::OtherMeaning(original.source().name().to_owned()))
}

/// Applies as many changes as edits can express.
fn with_edits(original: &Description, wanted: &Device) -> Option<Description> {
    let changes = changes(original, wanted);
    let edits_of = |changes: Vec<Change>| original.edits(&Fix { changes, ..Fix::safe("apply the patch") });
    let found = edits_of(changes.clone()).or_else(|| {
        // an impossible one must not prevent the others
        let possible = changes.into_iter().filter(|change| edits_of(vec![change.clone()]).is_some());
        edits_of(possible.collect())
    });
    let mut edits = Edits::new(original.source());
    found.into_iter().flatten().for_each(|(span, text)| edits.replace(span, text));
    let edited = original.with_bytes(edits.to_bytes().ok()?)?;
    if let Some(tree) = edited.tree()
        && wanted.objects.keys().any(|index| edited.described().object(*index).is_none())
    {
        let bytes = objdict_xdd::xdd::with_objects(tree, wanted)?.ok()?;
        return original.with_bytes(bytes);
    }
    Some(edited)
}

/// The differences of two devices as changes in the terms of CiA 306, from the EDS texts of both.
fn changes(original: &Description, wanted: &Device) -> Vec<Change> {
    let device = original.described();
    let is_other = |index: u16, object: &Object| wanted.object(index).is_some_and(|other| other != object);
    let before = eds::stated(&with_some(device, is_other));
    let after = eds::stated(&with_some(wanted, |index, object| device.object(index) != Some(object)));
    let mut before: BTreeMap<Part, Vec<(Field, String)>> = before.into_iter().collect();
    let gone = device.objects.keys().filter(|index| wanted.object(**index).is_none());
    let mut changes: Vec<Change> =
        gone.map(|index| Change::Remove(Place::of(Part::Object(*index)))).collect();
    for (part, fields) in after {
        let old = before.remove(&part).unwrap_or_default();
        if matches!(part, Part::List(_)) || old == fields {
            continue;
        }
        if original.locate(&Place::of(part.clone())).is_none() {
            changes.push(Change::Add(part, fields));
            continue;
        }
        for (field, _) in old.iter().filter(|(field, _)| !fields.iter().any(|(other, _)| other == field)) {
            changes.push(Change::Remove(Place::of(part.clone()).field(field.clone())));
        }
        for (field, text) in fields {
            if !old.contains(&(field.clone(), text.clone())) {
                changes.push(Change::Set(Place::of(part.clone()).field(field), text));
            }
        }
    }
    let gone = before.into_keys().filter(|part| !matches!(part, Part::List(_)));
    changes.extend(gone.map(|part| Change::Remove(Place::of(part))));
    let lists = ObjectList::ALL.into_iter().filter(|list| device.lists.get(*list) != wanted.lists.get(*list));
    changes.extend(lists.map(|list| Change::List(list, wanted.lists.get(list).to_vec())));
    changes
}

/// A device with some of its objects.
fn with_some(device: &Device, mut is_kept: impl FnMut(u16, &Object) -> bool) -> Device {
    let mut some = device.clone();
    some.objects.retain(|index, object| is_kept(*index, object));
    some
}

/// Embeds the changes that edits could not express; `None` if its format does not support that.
fn with_embedded(edited: Description, wanted: &Device, limit: usize) -> Option<Description> {
    if edited.describes(wanted) {
        return Some(edited);
    }
    if edited.format().syntax() != Syntax::Ini {
        return None;
    }
    let mut edits = Edits::new(edited.source());
    embedded::remove_lines(&mut edits, |_| true);
    let bare = edited.with_bytes(edits.to_bytes().ok()?)?;
    let mut changes = Vec::new();
    let mut found = |difference: crate::compare::DatumDifference| {
        let before = difference.left.map(|left| left.fingerprint());
        changes.push(DatumChange { path: difference.path, before, after: difference.right });
    };
    each_difference(bare.described(), wanted, limit, &mut found).ok()?;
    let mut edits = Edits::new(bare.source());
    embedded::add_lines(&mut edits, &changes);
    bare.with_bytes(edits.to_bytes().ok()?).filter(|edited| edited.describes(wanted))
}
