//! Names that contradict the standard.

use crate::demands::{self, Against};
use crate::diagnostic::{Findings, say, sub_index};
use crate::model::{Field, PdoKind, Place};
use crate::profile::index_in;
use crate::rule::rules;
use crate::{Facts, PdoFacts, with_others};

rules! {
    "naming/name-of-other-object" = NAME_OF_OTHER_OBJECT, Note,
        Facts(name_of_other_object), explains Around ["duplicate-object-name"];
    summary: "an object has the name of another object of the standard",
    checks: "Whether no object has the name that the CiA document gives to another index, and no entry the name of another sub-index of the same object. Only letters and digits are compared, without case; `Reserved` is not a name. One finding for each device.",
    why: "Users and tools that go by names write the deceleration to the acceleration. Either the index or the name is wrong; usually both were exchanged.",
    example: "`[6083]` with `ParameterName=Profile deceleration`, which is 6084h",
    remedy: "Write the name of the document, or move the object.",
    source: "CiA 301 and the device profiles, names of objects",

    "naming/wrong-pdo-direction" = WRONG_PDO_DIRECTION, Warning, Pdo(wrong_pdo_direction);
    summary: "the name of a PDO has the wrong direction",
    checks: "Whether names of RPDO objects (14xxh and 16xxh) mention only a transmit PDO or TPDO, or names of TPDO objects (18xxh and 1Axxh) only a receive PDO or RPDO.",
    why: "Users who configure the device by names configure the wrong PDO. Usually the object was copied.",
    example: "`ParameterName=Receive PDO 1 parameter` in `[1800]`",
    remedy: "Correct the name or the index.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",
}

/// The name of sub-indexes that must not be there.
const RESERVED_NAME: &str = "Reserved";

fn name_of_other_object(facts: &Facts<'_>, findings: &mut Findings) {
    let mut wrong = Vec::new();
    for one in demands::applied(facts.device, facts.options) {
        let objects = || one.profile.objects().map(|object| (object.name, (object.first, object.last)));
        for against in demands::against(facts.device, &one).filter(|against| !against.object.orphan) {
            if let Some((other, _)) = place_of_other(objects(), against.object.name(), against.facts.name) {
                let place = Place::object(against.index);
                let other = index_in(one.block, other);
                wrong.push((
                    place,
                    say!(
                        "{:04X}h has the name of {:04X}h, `{}`",
                        against.index,
                        other,
                        against.object.name()
                    ),
                ));
            }
            entries_with_other_names(&against, &mut wrong);
        }
    }
    let mut wrong = wrong.into_iter().map(|(place, text)| (place.field(Field::ParameterName), text));
    let Some((place, message)) = wrong.next() else { return };
    let finding = NAME_OF_OTHER_OBJECT.at(place, message);
    findings.push(
        with_others(finding, wrong).help("write the name that the document gives it, or move the object"),
    );
}

/// Adds the entries of an object that have the name of another one of its entries.
fn entries_with_other_names(against: &Against<'_>, wrong: &mut Vec<(Place, crate::diagnostic::Text)>) {
    let entries = || against.facts.entries().map(|entry| (entry.name, (entry.first, entry.last)));
    for at in against.entries() {
        // another rule reports reserved sub-indexes
        let Some(sub) = at.sub.filter(|_| at.facts.name != RESERVED_NAME) else { continue };
        if let Some((other, _)) = place_of_other(entries(), &at.entry.name, at.facts.name) {
            let message =
                say!("{} has the name of sub-index {}, `{}`", at, sub_index(other), &*at.entry.name);
            wrong.push((Place::entry(against.index, sub), message));
        }
    }
}

/// The first and the last number of the only one with a name that is not the `own` one.
fn place_of_other<'a, T: PartialEq>(
    named: impl Iterator<Item = (&'a str, (T, T))>,
    name: &str,
    own: &str,
) -> Option<(T, T)> {
    if is_alike(name, own) {
        return None;
    }
    let mut alike = named.filter(|(other, _)| !matches!(*other, "" | RESERVED_NAME) && is_alike(name, other));
    let (_, place) = alike.next()?;
    (alike.next().is_none() && place.0 == place.1).then_some(place)
}

/// Whether names are the same but for blanks, case and signs. The asterisk of values in increments counts (CiA 402).
fn is_alike(name: &str, other: &str) -> bool {
    name == other || plain(name).eq(plain(other))
}

fn plain(name: &str) -> impl Iterator<Item = char> {
    let named = name.chars().filter(|&char| char.is_alphanumeric() || char == '*');
    named.flat_map(char::to_lowercase)
}

const RECEIVE_WORDS: [&str; 3] = ["rpdo", "receive", "rxpdo"];
const TRANSMIT_WORDS: [&str; 3] = ["tpdo", "transmit", "txpdo"];

fn wrong_pdo_direction(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let (own, other) = match pdo.kind {
        PdoKind::Rpdo => (RECEIVE_WORDS, TRANSMIT_WORDS),
        PdoKind::Tpdo => (TRANSMIT_WORDS, RECEIVE_WORDS),
    };
    let objects = [(pdo.communication_index(), pdo.communication), (pdo.mapping_index(), pdo.mapping)];
    for (index, object) in objects.into_iter().filter_map(|(index, object)| Some((index, object?))) {
        let name = object.name();
        let says = |words: [&str; 3]| words.iter().any(|word| contains_word(name, word));
        if says(other) && !says(own) {
            let message = say!("{:04X}h belongs to {}, but is named `{}`", index, pdo, name);
            let place = Place::object(index).field(Field::ParameterName);
            findings.push(WRONG_PDO_DIRECTION.at(place, message).help("correct the name or the index"));
            return;
        }
    }
}

/// Whether a name contains a word, ignoring case.
fn contains_word(name: &str, word: &str) -> bool {
    name.as_bytes().windows(word.len()).any(|part| part.eq_ignore_ascii_case(word.as_bytes()))
}
