use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Field, Part, Place};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/mapping-granularity", Warning, Pdo(check);
    summary: "the length of a mapped object is not a multiple of the granularity",
    checks: "Whether the length of each object that a PDO maps by default is a multiple of `Granularity`. With 0 the mapping is fixed and not checked.",
    why: "A device with a granularity of 8 maps whole bytes and rejects a BOOLEAN. Either the granularity is smaller than stated or the mapping does not work.",
    example: "`Granularity=8`, and `[1A00sub1]` with `DefaultValue=0x60200101`",
    remedy: "Write the granularity of the device, or map objects of whole bytes.",
    source: "CiA 306-1 §4.5",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity);
    let Some(granularity) = granularity.filter(|granularity| (2..=64).contains(granularity)) else { return };
    let is_odd = |bits: u8| !bits.is_multiple_of(granularity);
    let mut known = pdo.mapped.iter().filter(|mapped| match mapped.target {
        Target::Entry(_) => mapped.wrong_length().is_none(),
        _ => matches!(mapped.target, Target::Dummy),
    });
    let Some(first) = known.find(|mapped| is_odd(mapped.object.bits)) else { return };
    let message = say!(
        "{} maps {}, which is not a multiple of the granularity of `{}` bits",
        pdo.pdo,
        first.object,
        granularity
    );
    let place = facts.device.value_place(pdo.pdo.mapping_index(), first.slot);
    let finding = Diagnostic::new(&RULE.info, place, message);
    let finding = finding.label(Place::of(Part::DeviceInfo).field(Field::Granularity), "the granularity");
    findings.push(finding.help("correct the granularity, or map only objects that are multiples of it"));
}
