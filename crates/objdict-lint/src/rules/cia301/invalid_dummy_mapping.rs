use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::model::{DataType, Field, MappedObject, Part, PdoKind, Place};
use crate::{Facts, PdoFacts, Target, rule};

rule! {
    "cia301/invalid-dummy-mapping", Error, Pdo(check);
    summary: "a dummy entry of a PDO mapping is not valid",
    checks: "Whether each mapping entry that refers to a data type instead of an object (below 0020h) is in an RPDO, refers to an integer type or BOOLEAN, has sub-index 0 and the length of the type, and is not disabled in `DummyUsage`.",
    why: "A dummy entry makes an RPDO skip data for other nodes. A TPDO has no value to send for it, and a device rejects a type that it does not support as dummy entry.",
    example: "`[1600sub2]` with `DefaultValue=0x00050010`",
    remedy: "Write `0x00050008` for one byte, `0x00060010` for two, `0x00070020` for four, and enable the type in `DummyUsage`.",
    source: "CiA 301 §7.4.7.1; CiA 306-1 §4.6.2",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in pdo.mapped.iter().filter(|mapped| matches!(mapped.target, Target::Dummy)) {
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        if let Some((what, help)) = defect(pdo.pdo.kind, mapped.object) {
            let message = say!("{} {}", pdo.pdo, what);
            findings.push(Diagnostic::new(&RULE.info, place, message).help(help));
        } else if let Some(key) = forbidden(facts, mapped.object) {
            let data_type = DataType(mapped.object.index);
            let message =
                say!("{} has a dummy entry of type {}, which `DummyUsage` disables", pdo.pdo, data_type);
            let key = Place::of(Part::DummyUsage).field(key);
            let finding = Diagnostic::new(&RULE.info, place, message).label(key, "disabled here");
            findings.push(finding.help("use a type that `DummyUsage` enables"));
        }
    }
}

fn defect(kind: PdoKind, dummy: MappedObject) -> Option<(Text, Text)> {
    let data_type = DataType(dummy.index);
    let bits = data_type.bit_length();
    if kind == PdoKind::Tpdo {
        let what = say!("maps the data type {}, but only an RPDO can have dummy entries", data_type);
        return Some((what, "map an object".into()));
    }
    let Some(bits) = bits.filter(|_| data_type.is_dummy()) else {
        let what = say!("maps {:04X}h, which is not a data type for dummy entries", dummy.index);
        return Some((what, "use BOOLEAN or an integer type: `0x00050008` skips one byte".into()));
    };
    let right = say!("write `0x{:08X}`", MappedObject { bits, sub: 0, ..dummy }.to_number());
    if dummy.sub != 0 {
        return Some((say!("has a dummy entry with sub-index {}, which must be 0", dummy.sub), right));
    }
    let what = say!("has a dummy entry of {} bits, but {} has {}", dummy.bits, data_type, bits);
    (bits != dummy.bits).then_some((what, right))
}

/// The key that disables the type as dummy entry.
fn forbidden(facts: &Facts<'_>, dummy: MappedObject) -> Option<Field> {
    let usage = facts.device.dummy_usage.as_ref()?;
    let allowed = usage.types.get(&DataType(dummy.index))?;
    (!allowed).then(|| Field::Named(format!("Dummy{:04X}", dummy.index).into()))
}
