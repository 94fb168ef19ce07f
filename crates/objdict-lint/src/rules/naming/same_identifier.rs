use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Device, Field, Object, Place};
use crate::rule;

rule! {
    "naming/same-identifier", Note, Object(check);
    summary: "two names of an object result in the same identifier",
    checks: "Whether the names of an object's sub-indexes from 2000h on differ in more than case, spaces and punctuation. Equal names have their own finding. Only the first pair in an object is shown.",
    why: "Identifiers in generated code consist of letters, digits and `_`: `Gain +` and `gain -` become the same, and the generator has to add numbers, which change when an entry is inserted.",
    example: "`ParameterName=Limit +` in `[2000sub1]` and `ParameterName=Limit -` in `[2000sub2]`",
    remedy: "Express the difference in words: `Limit positive` and `Limit negative`.",
    source: "Not in a standard",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if index < 0x2000 {
        return;
    }
    let Some((first, second)) = alike(object) else { return };
    let name = |sub| object.subs.get(sub).map_or("", |entry| &entry.name);
    let message = say!(
        "`{}` and `{}`, sub-indexes {} and {}, result in the same identifier",
        name(first),
        name(second),
        sub_index(first),
        sub_index(second)
    );
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding = Diagnostic::new(&RULE.info, place(second), message).label(place(first), "first here");
    findings.push(finding.help("express the difference in words"));
}

/// The first two sub-indexes whose names differ only in case, spaces and punctuation.
fn alike(object: &Object) -> Option<(u8, u8)> {
    let mut seen: Vec<(u64, u8)> = Vec::with_capacity(object.subs.len());
    for (sub, entry) in object.subs.iter() {
        let Some(hash) = hash(&entry.name) else { continue };
        let same = seen.iter().find(|&&(other, first)| {
            let name = object.subs.get(first).map_or("", |entry| &entry.name);
            other == hash && is_alike(name, &entry.name)
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
fn letters(name: &str) -> impl Iterator<Item = u8> {
    name.bytes().filter(u8::is_ascii_alphanumeric).map(|byte| byte.to_ascii_lowercase())
}

fn is_alike(one: &str, other: &str) -> bool {
    letters(one).eq(letters(other))
}

/// A hash that is equal for similar names; `None` for a name without letters, or with non-ASCII letters.
fn hash(name: &str) -> Option<u64> {
    if !name.is_ascii() {
        return None;
    }
    let fold = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3);
    let mut letters = letters(name).peekable();
    letters.peek()?;
    Some(letters.fold(0xCBF2_9CE4_8422_2325, fold))
}
