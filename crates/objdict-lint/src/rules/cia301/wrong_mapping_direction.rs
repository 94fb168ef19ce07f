use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, PdoKind, Place};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/wrong-mapping-direction", Error, Pdo(check);
    summary: "a PDO maps an object of the other direction",
    checks: "Whether the objects of a TPDO are readable and not process outputs (`wo`, `rww`), and those of an RPDO are writable and not process inputs (`ro`, `const`, `rwr`).",
    why: "An RPDO cannot write a read-only object: the device rejects the mapping, or drops the data silently.",
    example: "`[1600sub1]` with `DefaultValue=0x60000108`, and `[6000sub1]` with `AccessType=ro`",
    remedy: "Map the object to a PDO of its direction, or correct its access type: `rww` for an output, `ro` or `rwr` for an input, `rw` for both.",
    source: "CiA 301 §7.5.2.36 (corrigendum 3); CiA 306-1 §4.6.3.2",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let Target::Entry(entry) = &mapped.target else { continue };
        let Some(access) = entry.access.filter(|_| entry.is_mappable() && !entry.fits_pdo(pdo.pdo.kind))
        else {
            continue;
        };
        let (index, sub) = (mapped.object.index, mapped.object.sub);
        let message = say!("{} maps {:04X}h:{:02X}, which is {}", pdo.pdo, index, sub, what_it_is(access));
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let is_single = facts.device.object(index).is_some_and(|object| object.subs.get(sub).is_none());
        let target = if is_single { Place::object(index) } else { Place::entry(index, sub) };
        let finding = Diagnostic::new(&RULE.info, place, message);
        let finding = finding.label(target.field(Field::AccessType), "the access type");
        findings.push(finding.help(match pdo.pdo.kind {
            PdoKind::Rpdo => "map a writable object: `rww`, `rw` or `wo`",
            PdoKind::Tpdo => "map a readable object: `ro`, `rwr` or `rw`",
        }));
    }
}

fn what_it_is(access: Access) -> &'static str {
    match access {
        Access::Ro => "read-only (`ro`)",
        Access::Const => "constant (`const`)",
        Access::Wo => "write-only (`wo`)",
        Access::Rwr => "a process input (`rwr`)",
        Access::Rww => "a process output (`rww`)",
        Access::Rw => "for PDOs of the other direction",
    }
}
