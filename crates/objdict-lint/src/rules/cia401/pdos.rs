//! The default PDOs of an I/O module.

use crate::demands::Applied;
use crate::diagnostic::{Argument, Findings, Fix, Severity, say, series};
use crate::model::{Device, MappedObject};
use crate::rule::rules;
use crate::{Facts, MappedTo, PdoFacts, channels};

rules! {
    source: "CiA 401, default PDOs";

    "cia401/wrong-default-mapping" = WRONG_DEFAULT_MAPPING, Warning,
        Applied(wrong_default_mapping), fix Unsafe;
    summary: "the default mapping of a PDO of an I/O module differs from CiA 401",
    checks: "Whether the default mapping of PDO 1 to 4 in an EDS is that of the profile, as far as there are channels: RPDO 1 carries the first 8 bytes of digital outputs (6200h), RPDOs 2 to 4 the first 12 words of analogue outputs (6411h), TPDO 1 the first 8 bytes of digital inputs (6000h), TPDOs 2 to 4 the first 12 words of analogue inputs (6401h). A PDO that carries only some of its channels is a note. The rule does not apply when bit 23 of 1000h declares a manufacturer-specific mapping, to devices with several logical devices, to PDOs that map nothing, and to PDOs whose entries are invalid.",
    why: "The default mapping makes modules of different vendors interchangeable: a master that knows the profile uses it without configuration. In real files most PDOs that differ carry fewer channels than available, which affects only the missing ones.",
    example: "`[1A00sub1]` with `DefaultValue=0x64010110`",
    remedy: "Use the mapping of the profile, or set bit 23 of 1000h.",

    "cia401/wrong-transmission-type" = WRONG_TRANSMISSION_TYPE, Warning,
        Applied(wrong_transmission_type), fix Unsafe;
    summary: "a default PDO of an I/O module has a transmission type other than 255",
    checks: "Whether the default transmission type of PDO 1 to 4 of an EDS, as far as there are channels for them, is 255: sent when an input changes, applied immediately. The rule does not apply to PDOs that are not valid by default, when bit 23 of 1000h declares a manufacturer-specific mapping, and to devices with several logical devices.",
    why: "Without configuration, a master gets no inputs from a module that waits for a SYNC. With 254 the vendor, not the profile, defines when the PDO is sent.",
    example: "`[1800sub2]` with `DefaultValue=254`",
    remedy: "Write `DefaultValue=255`, in the description and in the device.",
}

fn wrong_default_mapping(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for (pdo, right) in channels::default_pdos(facts, applied) {
        let found: Vec<MappedObject> = pdo.mapped.iter().map(|mapped| mapped.object).collect();
        if found.is_empty() || found == right || !is_mapping_readable(pdo) {
            continue;
        }
        let is_shorter = right.starts_with(&found);
        let differs = found.iter().zip(&right).position(|(found, right)| found != right);
        let pair = differs.and_then(|at| Some((found.get(at)?, right.get(at)?)));
        let message = match pair.filter(|(found, right)| (found.index, found.sub) == (right.index, right.sub))
        {
            Some((found, right)) => say!(
                "{} maps {} bits of {:04X}h:{:02X}, but CiA 401 maps {}",
                pdo.pdo,
                found.bits,
                found.index,
                found.sub,
                right.bits
            ),
            None => {
                say!("{} maps {}, but CiA 401 maps {}", pdo.pdo, shown_mapping(&found), shown_mapping(&right))
            }
        };
        let slot = differs.and_then(|at| pdo.mapped.get(at)).map_or(0, |mapped| mapped.slot);
        let place = device.value_place(pdo.pdo.mapping_index(), slot);
        let finding = WRONG_DEFAULT_MAPPING.at(place, message);
        let finding = finding.help("use the mapping of the profile or set bit 23 of 1000h");
        let finding = if is_shorter { finding.severity(Severity::Note) } else { finding };
        findings.push(match mapping_of_profile(device, pdo, &right) {
            Some(fix) => finding.fix(fix),
            None => finding,
        });
    }
}

/// Whether the mapping is stated and not reported by another rule.
fn is_mapping_readable(pdo: &PdoFacts<'_>) -> bool {
    let fits = |target: &MappedTo<'_>| match target {
        MappedTo::Entry(entry) => entry.is_mappable() && entry.fits_pdo(pdo.pdo.kind),
        MappedTo::Dummy | MappedTo::Elsewhere => true,
        _ => false,
    };
    let slots = || pdo.pdo.used_slots();
    let is_counted = pdo.pdo.mapped_count.is_some_and(|count| slots().count() == usize::from(count));
    let is_stated = slots().all(|slot| slot.object.is_some_and(|object| !object.is_unused()));
    is_counted && is_stated && pdo.lengths_are_right() && pdo.mapped.iter().all(|mapped| fits(&mapped.target))
}

/// The mapping of the profile, if there are entries for it.
fn mapping_of_profile(device: &Device, pdo: &PdoFacts<'_>, right: &[MappedObject]) -> Option<Fix> {
    let index = pdo.pdo.mapping_index();
    let object = device.object(index).filter(|object| object.compact.is_none())?;
    let count = u8::try_from(right.len()).ok()?;
    let fix = Fix::risky("write the mapping of the profile");
    let fix = fix.set(device.value_place(index, 0), count.to_string());
    (1..=count).zip(right).try_fold(fix, |fix, (sub, mapped)| {
        let number = format!("0x{:04X}{:02X}{:02X}", mapped.index, mapped.sub, mapped.bits);
        object.subs.get(sub).map(|_| fix.set(device.value_place(index, sub), number))
    })
}

/// Runs of sub-indexes: `6401h:01 to 04`.
fn shown_mapping(mapped: &[MappedObject]) -> Argument {
    let mut runs: Vec<(MappedObject, u8)> = Vec::new();
    for object in mapped {
        match runs.last_mut() {
            Some((first, last)) if first.index == object.index && last.checked_add(1) == Some(object.sub) => {
                *last = object.sub;
            }
            _ => runs.push((*object, object.sub)),
        }
    }
    series(runs.iter().map(|(first, last)| match first.sub == *last {
        true => say!("{:04X}h:{:02X}", first.index, last),
        false => say!("{:04X}h:{:02X} to {:02X}", first.index, first.sub, last),
    }))
}

fn wrong_transmission_type(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    for (pdo, _) in channels::default_pdos(facts, applied) {
        let pdo = &pdo.pdo;
        // another rule reports reserved transmission types
        let wrong = pdo.transmission_type.filter(|found| !matches!(found, 241..=251 | 255));
        let Some(found) = wrong.filter(|_| pdo.is_valid() != Some(false)) else { continue };
        let message = say!("transmission type `{}` of {} differs from CiA 401 (255)", found, pdo);
        let place = facts.device.value_place(pdo.communication_index(), 2);
        let finding = WRONG_TRANSMISSION_TYPE.at(place.clone(), message).help("write 255");
        findings.push(finding.fix(Fix::risky("write `255`").set(place, "255")));
    }
}
