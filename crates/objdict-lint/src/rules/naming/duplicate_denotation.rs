use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, DeviceKind, Field, Part, Place};
use crate::{rule, with_others};

rule! {
    "naming/duplicate-denotation", Note, Device(check);
    summary: "two entries have the same denotation",
    checks: "Whether the denotations of a DCF, the application's names of entries, differ. The first repetition is shown with the others.",
    why: "An application that looks up variables by denotation gets the first of the two.",
    example: "`Denotation=Door open` in `[6000sub1]` and in `[6000sub2]`",
    remedy: "Give each entry a unique denotation.",
    source: "CiA 306-1 §5.3",
}

fn check(device: &Device, findings: &mut Findings) {
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
    let finding = Diagnostic::new(&RULE.info, second, message).label(first, "first here");
    let others = repeated.map(|(_, place, name)| (place, say!("`{}` again", name)));
    findings.push(with_others(finding, others).help("give each entry a unique denotation"));
}
