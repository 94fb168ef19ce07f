//! Patches made in the model of a description.

use std::sync::Arc;

use hmac_sha256::Hash;

use super::patched::lines;
use super::read::{EXPECT_NOT_MET, INVALID_CHANGE, NO_EFFECT, OTHER_FILE};
use super::{ChangeWords, ChangedPart, Patch, Patched, Worded, selected};
use crate::Description;
use crate::compare::{self, Datum, DatumChange};
use crate::patch::fields::{entry, get, set};
use objdict_keyed::tree::{KeyedTree, Kind};
use objdict_model::diagnostic::{Diagnostic, Text, say};
use objdict_model::model::{Address, Device, Entry, Field, Object, ObjectList, Part, Place, field_names};
use objdict_model::source::{Said, Span};

/// Applies the patches that [select](Patch::selects) a description, and records them. Its text is unchanged until it is
/// printed or edited.
pub fn apply(description: Description, patches: &[Arc<Patch>]) -> Description {
    let given = patches.to_vec();
    let patches = selected(patches, description.device());
    if given.is_empty() || patches.is_empty() && description.device_count() == 1 {
        return description;
    }
    let mut device = description.described().clone();
    let mut patched = Patched { patches, given, ..Patched::default() };
    for (number, patch) in patched.patches.iter().enumerate() {
        let mut findings = patch.findings.clone();
        if let Some(expected) = &patch.selector.sha256 {
            let hash: String = Hash::hash(&description.source().to_bytes())
                .iter()
                .map(|byte| format!("{byte:02x}"))
                .collect();
            if hash != expected.value {
                let name = description.source().name();
                let finding =
                    Diagnostic::new(&OTHER_FILE, expected.at, say!("`{}` has the hash `{}`", name, hash));
                findings
                    .push(finding.help("check the patch with this file, then correct or remove `sha256`"));
            }
        }
        let (mut raws, mut spans) = (Vec::new(), Vec::new());
        for change in &patch.changes {
            match &change.what {
                ChangedPart::Words(words) => match make_words(&mut device, words) {
                    Ok(places) => {
                        patched.causes.extend(places.into_iter().map(|place| (place, number, change.span)));
                    }
                    Err(problem) => findings.push(problem.finding(change.span, description.source().name())),
                },
                ChangedPart::Raw(raw) => {
                    raws.push(raw.clone());
                    spans.push(change.span);
                }
            }
        }
        for (raw, span) in raws.iter().zip(&spans) {
            patched.causes.push((place_of(raw), number, *span));
        }
        // together: a type and its values fit each other only then
        for refused in compare::apply(&mut device, raws.clone()) {
            let span =
                raws.iter().position(|raw| raw.path == refused.path).map(|at| spans[at]).unwrap_or_default();
            findings.push(refusal(&device, refused).finding(span, description.source().name()));
        }
        patched.findings.push(findings);
    }
    if !patched.has_errors() {
        patched.by_patch().for_each(|(patch, findings)| patch.warn(lines(patch, findings)));
    }
    description.with_patched(device, patched)
}

fn place_of(change: &DatumChange) -> Place {
    compare::DatumDifference { path: change.path.clone(), left: None, right: None }.place()
}

/// The reason why a value was not changed.
fn refusal(device: &Device, refused: DatumChange) -> PatchProblem {
    let before = refused.after.as_ref().map(Datum::fingerprint);
    let path = refused.path.clone();
    match compare::apply(&mut device.clone(), vec![DatumChange { before, ..refused }]).is_empty() {
        true => PatchProblem::NoEffect(say!("`{}` already has this value", path)),
        false => PatchProblem::NotExpected(say!(
            "`{}` does not match `expect`, or cannot take the values of `set`",
            path
        )),
    }
}

/// Why a change was not made.
pub(super) enum PatchProblem {
    /// The file contains a different value.
    NotExpected(Text),
    /// The file already contains the value.
    NoEffect(Text),
    /// The value is not valid there.
    Invalid(Text),
}

impl PatchProblem {
    fn finding(self, span: Span, file: &str) -> Diagnostic {
        let (rule, message, help) = match self {
            Self::NotExpected(message) => (
                &EXPECT_NOT_MET,
                message,
                "compare the patch with this file; correct `expect` or remove the change",
            ),
            Self::NoEffect(message) => {
                (&NO_EFFECT, message, "remove the change, or name the revisions that need it with `revision`")
            }
            Self::Invalid(message) => (&INVALID_CHANGE, message, "correct the change"),
        };
        Diagnostic::new(rule, span, say!("`{}`: {}", file, message)).help(help)
    }
}

/// Applies a keyword change; returns the changed places.
pub(super) fn make_words(device: &mut Device, words: &ChangeWords) -> Result<Vec<Place>, PatchProblem> {
    let part = &words.part;
    let name = part.to_string();
    let exists = is_there(device, part);
    match (&words.add, exists) {
        (Some(fields), true) if fields.iter().all(|field| says(device, part, field)) => {
            return Err(PatchProblem::NoEffect(say!("`{}` already exists", name)));
        }
        (Some(_), true) => {
            return Err(PatchProblem::NotExpected(say!("`{}` already exists, with different fields", name)));
        }
        (None, false) if words.is_removed => {
            return Err(PatchProblem::NoEffect(say!("`{}` does not exist", name)));
        }
        (None, false) => return Err(PatchProblem::NotExpected(say!("`{}` does not exist", name))),
        _ => {}
    }
    let is_done = words.set.iter().all(|field| says(device, part, field))
        && words.unset.iter().all(|word| get(device, part, &word.value).is_none());
    let has_fields = !words.set.is_empty() || !words.unset.is_empty();
    if has_fields && is_done && words.rename.is_none() {
        let said = words.set.first().map_or_else(
            || say!("`{}` has no such field", name.as_str()),
            |field| {
                say!(
                    "`{}` of `{}` is already `{}`",
                    field.word.as_str(),
                    name.as_str(),
                    field.value.spelled()
                )
            },
        );
        return Err(PatchProblem::NoEffect(said));
    }
    expect(device, part, words)?;
    let mut places = Vec::new();
    if let Some(fields) = &words.add {
        add(device, part)?;
        set_all(device, part, fields)?;
        places.push(Place::of(part.clone()));
    }
    set_all(device, part, &words.set)?;
    for word in &words.unset {
        set(device, part, &word.value, None).map_err(PatchProblem::Invalid)?;
    }
    let fields = words.set.iter().map(|field| &field.word).chain(words.unset.iter().map(|word| &word.value));
    places.extend(fields.map(|word| Place::of(part.clone()).field(field_of(word))));
    if words.is_removed {
        remove(device, part);
        places.push(Place::of(part.clone()));
    }
    if let Some(address) = &words.rename {
        places.push(Place::of(rename(device, part, address)?));
    }
    Ok(places)
}

fn is_there(device: &Device, part: &Part) -> bool {
    match *part {
        Part::Object(index) => device.object(index).is_some(),
        Part::Entry(index, sub) => device.object(index).is_some_and(|object| object.has(sub)),
        // a part with properties is created with its first property
        _ => true,
    }
}

/// The field that a word or key names.
fn field_of(word: &str) -> Field {
    let row = field_names::ENTRY.iter().find(|row| row.key == word);
    row.map_or_else(|| Field::from_name(word), field_names::FieldRow::field)
}

/// Checks the expectations of the patch.
fn expect(device: &Device, part: &Part, words: &ChangeWords) -> Result<(), PatchProblem> {
    for field in &words.expect {
        if says(device, part, field) {
            continue;
        }
        let (word, name, expected) = (field.word.as_str(), part.to_string(), shown(&field.value.kind));
        let is_corrected = words.set.iter().any(|own| own.word == field.word && says(device, part, own));
        return Err(PatchProblem::NotExpected(match get(device, part, &field.word) {
            Some(found) if is_corrected => {
                say!("the vendor corrected `{}` of `{}`: it is already `{}`", word, name, shown(&found))
            }
            Some(found) => {
                say!("the vendor changed `{}` of `{}`: `{}` → `{}`", word, name, expected, shown(&found))
            }
            None => say!("`{}` has no `{}`, which was `{}`", name, word, expected),
        }));
    }
    for word in &words.absent {
        if let Some(found) = get(device, part, &word.value) {
            let (word, name) = (word.value.as_str(), part.to_string());
            return Err(PatchProblem::NotExpected(say!(
                "the vendor added `{}` to `{}`: `{}`",
                word,
                name,
                shown(&found)
            )));
        }
    }
    Ok(())
}

/// A value in messages.
fn shown(kind: &Kind) -> String {
    match kind {
        Kind::Map(entries) => {
            let entries =
                entries.iter().map(|entry| format!("{} = {}", entry.key.spelled(), entry.value.spelled()));
            entries.collect::<Vec<_>>().join(", ")
        }
        kind => KeyedTree::new(Span::default(), kind.clone()).spelled(),
    }
}

/// Whether a field has this value, in any spelling.
fn says(device: &Device, part: &Part, field: &Worded) -> bool {
    let found = get(device, part, &field.word);
    let is = |kind: &Kind| found.as_ref().is_some_and(|found| shown(found) == shown(kind));
    if is(&field.value.kind) {
        return true;
    }
    // the spelling that the field would have
    let mut other = Device {
        application: device.application.clone(),
        commissioning: device.commissioning.clone(),
        device_info: device.device_info.clone(),
        file_info: device.file_info.clone(),
        ..Device::default()
    };
    if let Some((index, object)) = part.object().and_then(|index| Some((index, device.object(index)?))) {
        other.objects.insert(index, object.clone());
    }
    let is_set = set(&mut other, part, &field.word, Some(&field.value)).is_ok();
    is_set && get(&other, part, &field.word).is_some_and(|kind| is(&kind))
}

fn set_all(device: &mut Device, part: &Part, fields: &[Worded]) -> Result<(), PatchProblem> {
    for field in fields {
        set(device, part, &field.word, Some(&field.value)).map_err(PatchProblem::Invalid)?;
    }
    let Some(entry) = entry(device, part) else { return Ok(()) };
    let is_set = |invalid: &Field| {
        fields.iter().any(|field| field_of(&field.word) == *invalid || field.word == "type")
    };
    match entry.invalid_values.iter().find(|invalid| is_set(&invalid.field)) {
        Some(invalid) => {
            let (field, text) = (invalid.field.to_string(), &*invalid.text);
            Err(PatchProblem::Invalid(say!(
                "`{}` of `{}` is `{}`, which is not a value of the new type: set it too",
                field,
                part.to_string(),
                text
            )))
        }
        None => Ok(()),
    }
}

/// Adds an object or entry, and adds an object to its list.
fn add(device: &mut Device, part: &Part) -> Result<(), PatchProblem> {
    match *part {
        Part::Object(index) => {
            device.objects.insert(index, Object::default());
            list(device, index);
        }
        Part::Entry(index, sub) => {
            let missing =
                || PatchProblem::NotExpected(say!("`{}` does not exist", Part::Object(index).to_string()));
            device.objects.get_mut(&index).ok_or_else(missing)?.subs.insert(sub, Entry::default());
        }
        _ => {}
    }
    Ok(())
}

/// Puts an object into its list.
fn list(device: &mut Device, index: u16) {
    let Some(list) = ObjectList::of(index) else { return };
    if ObjectList::ALL.iter().any(|list| device.lists.has(*list)) && !device.lists.get(list).contains(&index)
    {
        let indexes = device.lists.get_mut(list).get_or_insert_default();
        let at = indexes.iter().position(|other| *other > index).unwrap_or(indexes.len());
        indexes.insert(at, index);
    }
}

fn remove(device: &mut Device, part: &Part) {
    match *part {
        Part::Object(index) => {
            device.objects.remove(&index);
            for list in ObjectList::ALL {
                device.lists.get_mut(list).iter_mut().for_each(|list| list.retain(|other| *other != index));
            }
        }
        Part::Entry(index, sub) => {
            if let Some(object) = device.objects.get_mut(&index) {
                object.subs.remove(sub);
            }
        }
        _ => {}
    }
}

/// Moves an object or entry to a different address.
fn rename(device: &mut Device, part: &Part, to: &Said<Address>) -> Result<Part, PatchProblem> {
    let refused = || {
        PatchProblem::Invalid(say!(
            "`{}` cannot become `{}`: write an index for an object, and a free address",
            part.to_string(),
            to_text(to.value)
        ))
    };
    match (part.clone(), to.value) {
        (Part::Object(index), Address { index: new, sub: None }) if device.object(new).is_none() => {
            let object = device.object(index).cloned().ok_or_else(refused)?;
            remove(device, part);
            device.objects.insert(new, object);
            list(device, new);
            Ok(Part::Object(new))
        }
        (Part::Entry(index, sub), Address { index: same, sub: Some(new) }) if same == index => {
            let object =
                device.objects.get_mut(&index).filter(|object| !object.has(new)).ok_or_else(refused)?;
            let entry = object.subs.remove(sub).ok_or_else(refused)?;
            object.subs.insert(new, entry);
            Ok(Part::Entry(index, new))
        }
        _ => Err(refused()),
    }
}

fn to_text(Address { index, sub }: Address) -> String {
    sub.map_or_else(|| format!("{index:04X}"), |sub| format!("{index:04X}:{sub:X}"))
}
