use std::cell::LazyCell;
use std::collections::HashMap;

use crate::demands::{self, Against};
use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Field, Place};
use crate::profile::index_in;
use crate::{Facts, rule, with_others};

rule! {
    "naming/name-of-other-object", Note, Facts(check), explains Around ["duplicate-object-name"];
    summary: "an object has the name of another object of the standard",
    checks: "Whether no object has the name that the CiA document gives to another index, and no entry the name of another sub-index of the same object. Only letters and digits are compared, without case; `Reserved` is not a name. One finding for each device.",
    why: "Users and tools that go by names write the deceleration to the acceleration. Either the index or the name is wrong; usually both were exchanged.",
    example: "`[6083]` with `ParameterName=Profile deceleration`, which is 6084h",
    remedy: "Write the name of the document, or move the object.",
    source: "CiA 301 and the device profiles, names of objects",
}

/// The name of sub-indexes that must not be there.
const RESERVED: &str = "Reserved";

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let mut wrong = Vec::new();
    for one in demands::applied(facts.device, facts.options) {
        let objects = one.profile.objects().map(|object| (object.name, (object.first, object.last)));
        let named = LazyCell::new(|| places_of(objects));
        for against in demands::against(facts.device, &one).filter(|against| !against.object.orphan) {
            if let Some((other, _)) = place_of_other(&named, against.object.name(), against.facts.name) {
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
            entries(&against, &mut wrong);
        }
    }
    let mut wrong = wrong.into_iter().map(|(place, text)| (place.field(Field::ParameterName), text));
    let Some((place, message)) = wrong.next() else { return };
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(
        with_others(finding, wrong).help("write the name that the document gives it, or move the object"),
    );
}

/// Adds the entries of an object that have the name of another one of its entries.
fn entries(against: &Against<'_>, wrong: &mut Vec<(Place, crate::diagnostic::Text)>) {
    let names = against.facts.entries().map(|entry| (entry.name, (entry.first, entry.last)));
    let named = LazyCell::new(|| places_of(names));
    for at in against.entries() {
        // another rule reports reserved sub-indexes
        let Some(sub) = at.sub.filter(|_| at.facts.name != RESERVED) else { continue };
        if let Some((other, _)) = place_of_other(&named, &at.entry.name, at.facts.name) {
            let message =
                say!("{} has the name of sub-index {}, `{}`", at, sub_index(other), &*at.entry.name);
            wrong.push((Place::entry(against.index, sub), message));
        }
    }
}

/// The place with a name that is not the `own` one. Most names are, and then the others are not asked for.
fn place_of_other<T: Copy>(
    named: &LazyCell<Places<T>, impl FnOnce() -> Places<T>>,
    name: &str,
    own: &str,
) -> Option<T> {
    if name == own || plain(name) == plain(own) {
        return None;
    }
    named.get(&plain(name)).copied().flatten()
}

type Places<T> = HashMap<String, Option<T>>;

/// The first and the last number with each name; `None` for a name of several objects.
fn places_of<'a, T: Copy + PartialEq>(named: impl Iterator<Item = (&'a str, (T, T))>) -> Places<(T, T)> {
    let mut places = HashMap::new();
    for (name, place) in named.filter(|(name, _)| !matches!(*name, "" | RESERVED)) {
        let is_one = place.0 == place.1;
        places.entry(plain(name)).and_modify(|known| *known = None).or_insert(is_one.then_some(place));
    }
    places
}

/// A name without blanks, case and signs, but the asterisk of values in increments (CiA 402).
fn plain(name: &str) -> String {
    name.chars().filter(|&char| char.is_alphanumeric() || char == '*').flat_map(char::to_lowercase).collect()
}
