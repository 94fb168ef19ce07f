use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Device, Field, Object, Place};
use crate::rule;

rule! {
    "naming/unordered-numbering", Note, Object(check);
    summary: "the numbers in element names are not in the order of the sub-indexes",
    checks: "Whether numbered element names of an object from 2000h on ascend with the sub-indexes, from any start. Checked are objects whose elements share one name followed by consecutive numbers. Numbers with gaps or repetitions have another purpose and are not checked.",
    why: "Usually lines were swapped: software that sets element 3 by its name sets another element.",
    example: "`[2000sub1]` to `[2000sub3]` called `Input 1`, `Input 3` and `Input 2`",
    remedy: "Number the names in the order of the sub-indexes.",
    source: "Not in a standard",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if index < 0x2000 || object.compact.is_some() {
        return;
    }
    let Some((first, second)) = disorder(object) else { return };
    let name = |sub| object.subs.get(sub).map_or("", |entry| &entry.name);
    let message = say!(
        "sub-index {} is `{}`, but sub-index {} is `{}`",
        sub_index(first),
        name(first),
        sub_index(second),
        name(second)
    );
    let place = |sub| Place::entry(index, sub).field(Field::ParameterName);
    let finding =
        Diagnostic::new(&RULE.info, place(second), message).label(place(first), "the previous element");
    findings.push(finding.help("number the names in the order of the sub-indexes"));
}

/// The first two neighbours whose numbers do not ascend, if the numbers of all elements are consecutive.
fn disorder(object: &Object) -> Option<(u8, u8)> {
    let mut elements = object.subs.iter().filter(|&(sub, _)| sub > 0 && sub < 0xFF);
    let (sub, entry) = elements.next()?;
    let (stem, start) = numbered(&entry.name)?;
    let (mut last, mut lowest, mut highest, mut sum, mut count) =
        ((sub, start), start, start, u64::from(start), 1u64);
    let mut broken = None;
    for (sub, entry) in elements {
        let (_, number) = numbered(&entry.name).filter(|(other, _)| *other == stem)?;
        if number <= last.1 {
            broken.get_or_insert((last.0, sub));
        }
        (lowest, highest) = (lowest.min(number), highest.max(number));
        (sum, count, last) = (sum + u64::from(number), count + 1, (sub, number));
    }
    let (lowest, highest) = (u64::from(lowest), u64::from(highest));
    let is_row = highest - lowest + 1 == count && (lowest + highest) * count == 2 * sum;
    broken.filter(|_| is_row && is_unique(object, lowest))
}

/// Whether all numbers are different; the caller has checked that they are in a range as long as the number
/// of elements.
fn is_unique(object: &Object, lowest: u64) -> bool {
    let mut seen = [false; 256];
    object.subs.iter().filter(|&(sub, _)| sub > 0 && sub < 0xFF).all(|(_, entry)| {
        let at =
            numbered(&entry.name).and_then(|(_, number)| usize::try_from(u64::from(number) - lowest).ok());
        at.and_then(|at| seen.get_mut(at)).is_some_and(|seen| !std::mem::replace(seen, true))
    })
}

/// A name that ends with a number: its stem, and the number.
fn numbered(name: &str) -> Option<(&str, u32)> {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = name.get(stem.len()..)?;
    if stem.is_empty() || number.is_empty() { None } else { Some((stem, number.parse().ok()?)) }
}
