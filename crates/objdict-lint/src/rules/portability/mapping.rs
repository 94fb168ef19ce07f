//! PDO mappings that not all tools read correctly.

use crate::diagnostic::{Findings, Fix, counted, say};
use crate::model::{Access, Device, Field, ObjectType, Part, PdoKind, PdoMapping, Place};
use crate::rule::rules;
use crate::{EntryAt, EntryOwner, Facts, PdoFacts};

rules! {
    "portability/implicit-pdo" = IMPLICIT_PDO, Note, Device(implicit_pdo);
    summary: "a PDO is only implied by `CompactPDO`",
    checks: "Whether `CompactPDO` and the PDO counts in `[DeviceInfo]` imply PDOs without objects in the file.",
    why: "python-canopen and CANopenEditor ignore `CompactPDO` (CANopenEditor unless the file has modules), so they do not know these PDOs.",
    example: "`NrOfTXPDO=2` and `CompactPDO=0x13` without `[1800]` and `[1801]`",
    remedy: "Describe the objects of the PDOs, for example with `objdict convert`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/mapping-of-structure" = MAPPING_OF_STRUCTURE, Error, Entry(mapping_of_structure), fix Safe;
    summary: "an object without a mappable value has `PDOMapping=0`",
    checks: "Whether an ARRAY, RECORD or DEFSTRUCT without `CompactSubObj`, or a DOMAIN, has `PDOMapping=0`. The key does not belong there, but its value is right.",
    why: "node-canopen refuses keys of a value at these object types.",
    example: "`[1018]` with `ObjectType=0x9` and `PDOMapping=0`",
    remedy: "Remove the key.",
    source: "node-canopen 6.2.1",

    "portability/unclear-direction" = UNCLEAR_DIRECTION, Warning, Device(unclear_direction);
    summary: "a mappable entry is readable and writable",
    checks: "Whether entries with `PDOMapping=1` have an access type with a direction: `ro`, `const` and `rwr` for TPDOs, `wo` and `rww` for RPDOs. Only the first one is shown.",
    why: "CANchkEDS cannot decide whether an entry with `rw` belongs to a TPDO or to an RPDO.",
    example: "`AccessType=rw` and `PDOMapping=1`",
    remedy: "Write `rwr` for an entry that TPDOs send, `rww` for one that RPDOs receive.",
    source: "CANchkEDS 4.0; CiA 306-1 §4.6.3.2",

    "portability/unused-mapping-slot" = UNUSED_MAPPING_SLOT, Warning, Pdo(unused_mapping_slot);
    summary: "a fixed PDO mapping has entries that it does not use",
    checks: "Whether the default of sub-index 0 of each mapping is its highest sub-index, if `Granularity=0` says that the mapping cannot be changed.",
    why: "CANchkEDS warns because the entries can never be used.",
    example: "`Granularity=0`, `[1A00sub0]` with `DefaultValue=1`, and `[1A00sub2]`",
    remedy: "Remove the unused entries, or write the granularity of a mapping that can be changed.",
    source: "CANchkEDS 4.0",
}

fn implicit_pdo(device: &Device, findings: &mut Findings) {
    let implicit = device.implicit_pdos();
    if implicit.is_empty() {
        return;
    }
    let rpdos = implicit.iter().filter(|(kind, _)| *kind == PdoKind::Rpdo).count();
    let message = match (rpdos, implicit.len() - rpdos) {
        (0, tpdos) => say!("`{CompactPDO}` implies {}", counted(tpdos, "TPDO", "TPDOs")),
        (rpdos, 0) => say!("`{CompactPDO}` implies {}", counted(rpdos, "RPDO", "RPDOs")),
        (rpdos, tpdos) => say!(
            "`{CompactPDO}` implies {} and {}",
            counted(rpdos, "RPDO", "RPDOs"),
            counted(tpdos, "TPDO", "TPDOs")
        ),
    };
    let place = Place::of(Part::DeviceInfo).field(Field::CompactPdo);
    findings.push(IMPLICIT_PDO.at(place, message).help("describe the objects of these PDOs"));
}

fn mapping_of_structure(at: &EntryAt<'_>, findings: &mut Findings) {
    let is_without_value = match at.object_type() {
        _ if at.origin != EntryOwner::Device => false,
        Some(ObjectType::Domain) => true,
        Some(object_type) => object_type.has_subs() && at.sub.is_none() && at.object.compact.is_none(),
        None => false,
    };
    if is_without_value && at.entry.pdo_mapping == Some(PdoMapping::No) {
        let place = at.field(Field::PdoMapping);
        let message = say!("this {} has `{PDOMapping=0}`", at.object_type().unwrap_or(ObjectType::Var));
        let finding = MAPPING_OF_STRUCTURE.at(place.clone(), message).help(say!("remove {the key}"));
        findings.push(finding.fix(Fix::safe(say!("remove {the key}")).remove(place)));
    }
}

fn unclear_direction(device: &Device, findings: &mut Findings) {
    let mut unclear = device.objects.iter().flat_map(|(&index, object)| {
        let entries = object.described();
        let unclear = entries.filter(|(_, entry)| entry.access == Some(Access::Rw) && entry.is_mappable());
        unclear.map(move |(sub, _)| sub.map_or(Part::Object(index), |sub| Part::Entry(index, sub)))
    });
    let Some(first) = unclear.next() else { return };
    let entries = counted(unclear.count() + 1, "entry is", "entries are");
    let message = say!("{} mappable with `{AccessType=rw}`, which names no direction", entries);
    let finding = UNCLEAR_DIRECTION.at(Place::of(first).field(Field::AccessType), message);
    findings.push(finding.help(say!("write `{AccessType=rwr}` for TPDOs, `{AccessType=rww}` for RPDOs")));
}

fn unused_mapping_slot(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity);
    let index = pdo.pdo.mapping_index();
    let highest = facts.device.object(index).and_then(crate::model::Object::highest_sub);
    let (Some(0), Some(count), Some(highest)) = (granularity, pdo.pdo.mapped_count, highest) else { return };
    if count < highest {
        let message = say!("{:04X}h has {} entries, but {} maps only `{}`", index, highest, pdo.pdo, count);
        let finding = UNUSED_MAPPING_SLOT.at(facts.device.value_place(index, 0), message);
        findings.push(finding.help("remove the unused entries, or write another `Granularity`"));
    }
}
