use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, say};
use crate::model::{Access, Field, Object, Part, Place};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/granularity-against-access", Warning, Facts(check), fix Unsafe;
    summary: "`Granularity` contradicts the access types of the PDO mappings",
    checks: "Whether `Granularity` is 0 if no PDO mapping is writable, and not 0 if one is. A partly writable mapping has its own rule.",
    why: "Tools read `Granularity` to decide whether the mapping can be changed. With 0 they do not offer the change; with another value they offer a change that the device rejects.",
    example: "`Granularity=0`, and `[1A00sub0]` and `[1A00sub1]` with `AccessType=rw`",
    remedy: "Write 0 for a fixed mapping, 8 for a mapping of whole bytes, 1 for a mapping of single bits.",
    source: "CiA 306-1 §4.5",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity);
    let Some(granularity) = granularity.filter(|&granularity| granularity <= 64) else { return };
    let described = facts.pdos.iter().filter_map(|PdoFacts { pdo, .. }| Some((pdo, pdo.mapping?)));
    let known: Vec<_> = described.filter_map(|(pdo, object)| Some((pdo, is_writable(object)?))).collect();
    let (message, help, related) = match granularity {
        0 => {
            let Some((pdo, _)) = known.iter().find(|(_, writable)| *writable) else { return };
            let message = "`0` means a fixed PDO mapping, but the mapping is writable".into();
            let help =
                say!("write `{Granularity=8}` if whole bytes can be mapped, or make the mapping `const`");
            (message, help, (pdo, "this mapping is writable"))
        }
        _ => {
            let all_fixed = known.len() == facts.pdos.len() && known.iter().all(|(_, writable)| !writable);
            let Some((pdo, _)) = known.first().filter(|_| all_fixed) else { return };
            let message =
                say!("`{}` means a changeable PDO mapping, but no mapping is writable", granularity);
            (
                message,
                say!("write `{Granularity=0}` for a fixed mapping"),
                (pdo, "this mapping is not writable"),
            )
        }
    };
    let place = Place::of(Part::DeviceInfo).field(Field::Granularity);
    let (pdo, text) = related;
    let value = if granularity == 0 { "8" } else { "0" };
    let fix = Fix::risky(say!("write `{}`", Argument::setting(Field::Granularity, value)))
        .set(place.clone(), value);
    let finding = Diagnostic::new(&RULE.info, place, message).help(help).fix(fix);
    findings.push(finding.label(Place::object(pdo.mapping_index()), text));
}

/// Whether the whole mapping is writable; `None` if its access types are not stated or differ.
fn is_writable(object: &Object) -> Option<bool> {
    let mut accesses = object.entries().filter(|(sub, _)| *sub <= 64);
    // sub-index 0 of a compactly stored mapping is read-only by definition
    let skipped = usize::from(object.compact.is_some());
    let first = accesses.nth(skipped)?.1.access.map(Access::is_writable)?;
    accesses.all(|(_, entry)| entry.access.map(Access::is_writable) == Some(first)).then_some(first)
}
