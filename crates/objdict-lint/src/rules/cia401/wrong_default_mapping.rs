use crate::demands::Applied;
use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, RuleInfo, Severity, say, series};
use crate::model::{Device, MappedObject};
use crate::{Facts, PdoFacts, Target, channels, rule};

rule! {
    "cia401/wrong-default-mapping", Warning, Applied(check), fix Unsafe;
    summary: "a PDO of an I/O module carries by default what CiA 401 has elsewhere",
    checks: "Whether the default mapping of PDO 1 to 4 in an EDS is that of the profile, as far as there are channels: RPDO 1 carries the first 8 bytes of digital outputs (6200h), RPDOs 2 to 4 the first 12 words of analogue outputs (6411h), TPDO 1 the first 8 bytes of digital inputs (6000h), TPDOs 2 to 4 the first 12 words of analogue inputs (6401h). A PDO that carries some of its channels and nothing else is a note. It is silent when bit 23 of 1000h says that the manufacturer maps them, for modules of several logical devices, and for PDOs that carry nothing or whose entries are wrong in themselves.",
    why: "The default mapping is what makes modules of different manufacturers exchangeable: a master that knows the profile works with it and configures nothing. In real files most PDOs that differ carry fewer channels than there are, which costs only those.",
    example: "`[1A00sub1]` with `DefaultValue=0x64010110`",
    remedy: "Use the mapping of the profile, or set bit 23 of 1000h.",
    source: "CiA 401, default PDOs",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for (pdo, right) in channels::default_pdos(facts, applied) {
        let found: Vec<MappedObject> = pdo.mapped.iter().map(|mapped| mapped.object).collect();
        if found.is_empty() || found == right || !is_readable(pdo) {
            continue;
        }
        let (carries, should) = (shown(&found), shown(&right));
        let message = say!("{} carries {}, CiA 401 has {} in it", pdo.pdo, carries, should);
        let is_shorter = right.starts_with(&found);
        let differs = found.iter().zip(&right).position(|(found, right)| found != right);
        let slot = differs.and_then(|at| pdo.mapped.get(at)).map_or(0, |mapped| mapped.slot);
        let place = device.value_place(pdo.pdo.mapping_index(), slot);
        let finding = Diagnostic::new(rule, place, message);
        let finding = finding.help("use the mapping of the profile, or set bit 23 of 1000h");
        let finding = if is_shorter { finding.severity(Severity::Note) } else { finding };
        findings.push(match fix(device, pdo, &right) {
            Some(fix) => finding.fix(fix),
            None => finding,
        });
    }
}

/// Whether the description says what the PDO carries, and no other rule has anything against it.
fn is_readable(pdo: &PdoFacts<'_>) -> bool {
    let fits = |target: &Target<'_>| match target {
        Target::Entry(entry) => entry.is_mappable() && entry.fits_pdo(pdo.pdo.kind),
        Target::Dummy | Target::Elsewhere => true,
        _ => false,
    };
    let slots = || pdo.pdo.used_slots();
    let is_counted = pdo.pdo.mapped_count.is_some_and(|count| slots().count() == usize::from(count));
    let is_stated = slots().all(|slot| slot.object.is_some_and(|object| !object.is_unused()));
    is_counted && is_stated && pdo.lengths_are_right() && pdo.mapped.iter().all(|mapped| fits(&mapped.target))
}

/// The mapping of the profile, where there are entries to write it to.
fn fix(device: &Device, pdo: &PdoFacts<'_>, right: &[MappedObject]) -> Option<Fix> {
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

/// `6401h:01 to 04`, and what else there is.
fn shown(mapped: &[MappedObject]) -> Argument {
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
