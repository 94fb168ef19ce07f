//! Names that are used twice.

use std::collections::HashMap;

use crate::diagnostic::{Findings, say, sub_index};
use crate::model::{Device, DeviceKind, Field, ModulePart, Object, Part, Place};
use crate::rule::rules;
use crate::with_others;

rules! {
    "naming/duplicate-denotation" = DUPLICATE_DENOTATION, Note, Device(duplicate_denotation);
    summary: "two entries have the same denotation",
    checks: "Whether the denotations of a DCF, the application's names of entries, differ. The first repetition is shown with the others.",
    why: "An application that looks up variables by denotation gets the first of the two.",
    example: "`Denotation=Door open` in `[6000sub1]` and in `[6000sub2]`",
    remedy: "Give each entry a unique denotation.",
    source: "CiA 306-1 §5.3",

    "naming/duplicate-module" = DUPLICATE_MODULE, Note, Device(duplicate_module);
    summary: "two modules have the same name and order code",
    checks: "Whether two modules have both the same `ProductName` and the same `OrderCode`.",
    why: "Users who assemble a station by names cannot distinguish the two modules.",
    example: "`ProductName=DI8` and `OrderCode=750-430` in `[M1ModuleInfo]` and in `[M2ModuleInfo]`",
    remedy: "Add the version to the name, or remove one of the modules.",
    source: "CiA 306-1 §6.3",

    "naming/duplicate-object-name" = DUPLICATE_OBJECT_NAME, Note, Device(duplicate_object_name);
    summary: "two objects have the same name",
    checks: "Whether the names of objects from 2000h on differ. Not checked: objects at a distance of 800h, which are the same object of several axes or channels, and 5800h to 5FFFh, where masters store the PDOs of other nodes. The first repetition is shown with the others.",
    why: "Users cannot distinguish the objects, libraries that look up objects by name return the first one, and code generators have to add numbers.",
    example: "`ParameterName=Setpoint` in `[2000]` and in `[2001]`",
    remedy: "Add a number or a word to the names.",
    source: "Not in a standard; python-canopen, for example, looks up objects by name",

    "naming/same-identifier" = SAME_IDENTIFIER, Note, Object(same_identifier);
    summary: "two names of an object result in the same identifier",
    checks: "Whether the names of an object's sub-indexes from 2000h on differ in more than case, spaces and punctuation. Equal names have their own finding. Only the first pair in an object is shown.",
    why: "Identifiers in generated code consist of letters, digits and `_`: `Gain +` and `gain -` become the same, and the generator has to add numbers, which change when an entry is inserted.",
    example: "`ParameterName=Limit +` in `[2000sub1]` and `ParameterName=Limit -` in `[2000sub2]`",
    remedy: "Express the difference in words: `Limit positive` and `Limit negative`.",
    source: "Not in a standard",
}

fn duplicate_denotation(device: &Device, findings: &mut Findings) {
    if device.kind != DeviceKind::Node {
        return;
    }
    let mut seen: HashMap<&str, Place> = HashMap::new();
    let mut repeated = Vec::new();
    let mut take = |name, place: Place| match seen.get(name) {
        Some(first) => repeated.push((first.clone(), place, name)),
        None => {
            seen.insert(name, place);
        }
    };
    for (&index, object) in &device.objects {
        for (sub, entry) in object.described() {
            let Some(configured) = &entry.configured else { continue };
            let Some(name) = configured.denotation.as_deref().filter(|name| !name.is_empty()) else {
                continue;
            };
            take(
                name,
                sub.map_or(Place::object(index), |sub| Place::entry(index, sub)).field(Field::Denotation),
            );
        }
        for (sub, name) in object.compact.iter().flat_map(|compact| &compact.denotations) {
            if !name.is_empty() {
                take(name, Place::of(Part::CompactDenotations(index)).field(Field::Item(u32::from(*sub))));
            }
        }
    }
    let mut repeated = repeated.into_iter();
    let Some((first, second, name)) = repeated.next() else { return };
    let message = say!("two entries have the denotation `{}`", name);
    let finding = DUPLICATE_DENOTATION.at(second, message).label(first, "first here");
    let others = repeated.map(|(_, place, name)| (place, say!("`{}` again", name)));
    findings.push(with_others(finding, others).help("give each entry a unique denotation"));
}

fn duplicate_module(device: &Device, findings: &mut Findings) {
    let mut seen = HashMap::new();
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        let (Some(name), Some(code)) = (&module.product_name, &module.order_code) else { continue };
        // two versions of a module may share a name
        let key = (name, code, module.product_version, module.product_revision);
        let first = *seen.entry(key).or_insert(number);
        if first == number || name.is_empty() {
            continue;
        }
        let place = |number| Place::of(Part::Module(number, ModulePart::Info)).field(Field::ProductName);
        let message = say!("modules {} and {} are both `{}` with order code `{}`", first, number, name, code);
        let finding = DUPLICATE_MODULE.at(place(number), message).label(place(first), "first here");
        findings.push(finding.help("add the version to the name, or remove one of the modules"));
    }
}

fn duplicate_object_name(device: &Device, findings: &mut Findings) {
    let mut seen: HashMap<&str, u16> = HashMap::with_capacity(device.objects.len());
    let mut repeated = device.objects.range(0x2000..).filter_map(|(&index, object)| {
        let name = object.name();
        if name.is_empty() || object.orphan || (0x5800..0x6000).contains(&index) {
            return None;
        }
        let first = *seen.entry(name).or_insert(index);
        // the same object of another axis is 800h higher
        let is_copy = index >= 0x6000 && (index - first).is_multiple_of(0x800);
        (first != index && !is_copy).then_some((first, index, name))
    });
    let Some((first, second, name)) = repeated.next() else { return };
    let place = |index| Place::object(index).field(Field::ParameterName);
    let message = say!("{:04X}h and {:04X}h are both called `{}`", first, second, name);
    let finding = DUPLICATE_OBJECT_NAME.at(place(second), message).label(place(first), "first here");
    let others = repeated
        .map(|(first, index, _)| (place(index), say!("and {:04X}h the same as {:04X}h", index, first)));
    findings.push(with_others(finding, others).help("add a number or a word to the names"));
}

fn same_identifier(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if index < 0x2000 {
        return;
    }
    let Some((first, second)) = similar_names(object) else { return };
    let name = |sub| object.subs.get(sub).map_or("", |entry| &entry.name);
    let message = say!(
        "`{}` and `{}`, sub-indexes {} and {}, result in the same identifier",
        name(first),
        name(second),
        sub_index(first),
        sub_index(second)
    );
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding = SAME_IDENTIFIER.at(place(second), message).label(place(first), "first here");
    findings.push(finding.help("express the difference in words"));
}

/// The first two sub-indexes whose names differ only in case, spaces and punctuation.
fn similar_names(object: &Object) -> Option<(u8, u8)> {
    let mut seen: Vec<(u64, u8)> = Vec::with_capacity(object.subs.len());
    for (sub, entry) in object.subs.iter() {
        let Some(hash) = hash_of_letters(&entry.name) else { continue };
        let same = seen.iter().find(|&&(other, first)| {
            let name = object.subs.get(first).map_or("", |entry| &entry.name);
            other == hash && is_similar(name, &entry.name)
        });
        match same {
            // another rule reports equal names
            Some(&(_, first)) if object.subs.get(first).is_some_and(|other| other.name == entry.name) => {}
            Some(&(_, first)) => return Some((first, sub)),
            None => seen.push((hash, sub)),
        }
    }
    None
}

/// The letters and digits of a name in lower case; a name with non-ASCII letters is skipped.
fn letters_of(name: &str) -> impl Iterator<Item = u8> {
    name.bytes().filter(u8::is_ascii_alphanumeric).map(|byte| byte.to_ascii_lowercase())
}

fn is_similar(one: &str, other: &str) -> bool {
    letters_of(one).eq(letters_of(other))
}

/// A hash that is equal for similar names; `None` for a name without letters, or with non-ASCII letters.
fn hash_of_letters(name: &str) -> Option<u64> {
    if !name.is_ascii() {
        return None;
    }
    let fold = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3);
    let mut letters = letters_of(name).peekable();
    letters.peek()?;
    Some(letters.fold(0xCBF2_9CE4_8422_2325, fold))
}
