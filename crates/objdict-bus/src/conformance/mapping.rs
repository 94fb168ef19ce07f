//! The mapping of PDOs (CiA 301 §7.5.2.36, §7.5.2.38).

use objdict_device::Abort;

use super::bench::{Bench, MS};
use super::pdo::{CheckedPdo, MappedTarget, PdoDirection, RPDO, TPDO, map, mappable, mapping_of, set_up};
use super::{CheckStep, Verdict, absent, checks, ensure};

checks! { "PDO mapping":
    "7.5.2.38" "a TPDO with a new mapping sends its values" tpdo_procedure;
    "7.5.2.36" "an RPDO with a new mapping writes its values" rpdo_procedure;
    "7.5.2.36" "RPDO: dummies are left out" dummy;
    "7.5.2.38" "TPDO: a change while it is valid is rejected" @Writes |bench| while_valid(bench, TPDO);
    "7.5.2.36" "RPDO: a change while it is valid is rejected" @Writes |bench| while_valid(bench, RPDO);
    "7.5.2.38" "TPDO: an entry while their number is not 0 is rejected" @Writes |bench| while_counted(bench, TPDO);
    "7.5.2.36" "RPDO: an entry while their number is not 0 is rejected" @Writes |bench| while_counted(bench, RPDO);
    "7.5.2.38" "TPDO: an object that does not exist is rejected" @Writes |bench| no_object(bench, TPDO);
    "7.5.2.36" "RPDO: an object that does not exist is rejected" @Writes |bench| no_object(bench, RPDO);
    "7.5.2.38" "TPDO: a length other than the entry's is rejected" |bench| wrong_length(bench, TPDO);
    "7.5.2.36" "RPDO: a length other than the entry's is rejected" |bench| wrong_length(bench, RPDO);
    "7.5.2.38" "TPDO: an entry that is not mappable is rejected" @Writes |bench| { let entry = not_mappable(bench)?; refused(bench, TPDO, entry) };
    "7.5.2.36" "RPDO: an entry that is not mappable is rejected" @Writes |bench| { let entry = not_mappable(bench)?; refused(bench, RPDO, entry) };
    "7.5.2.38" "TPDO: more entries than the mapping has are rejected" @Writes |bench| too_many(bench, TPDO);
    "7.5.2.36" "RPDO: more entries than the mapping has are rejected" @Writes |bench| too_many(bench, RPDO);
    "7.5.2.38" "TPDO: more than eight bytes are rejected" @Writes |bench| too_long(bench, TPDO);
    "7.5.2.36" "RPDO: more than eight bytes are rejected" @Writes |bench| too_long(bench, RPDO);
}

/// A PDO that is not valid and has no mapped entry.
fn emptied(bench: &mut Bench<'_>, kind: PdoDirection, settings: &[(u8, u64)]) -> CheckStep<CheckedPdo> {
    let pdo = set_up(bench, kind, settings)?;
    for sub in 0..=1 {
        bench.described.needs_writable(pdo.mapping(), sub)?;
    }
    pdo.disable(bench)?;
    bench.write(pdo.mapping(), 0, 0)?;
    Ok(pdo)
}

fn tpdo_procedure(bench: &mut Bench<'_>) -> CheckStep {
    let entry = mappable(bench, TPDO)?;
    let pdo = emptied(bench, TPDO, &[(2, 255)]).or_else(|_| emptied(bench, TPDO, &[(2, 254)]))?;
    map(bench, pdo.mapping(), &[entry])?;
    pdo.enable(bench)?;
    let pdo = CheckedPdo { mapped: vec![entry], ..pdo };
    let expected = pdo.packed(bench)?;
    let mut sent = bench.start();
    sent.extend(bench.run(MS).into_iter().map(|(_, frame)| frame));
    let is_sent = sent.iter().any(|frame| frame.id() == pdo.id && frame.data() == expected);
    ensure(is_sent, || format!("it does not send {}", super::described::hex(&expected)))
}

/// Maps an entry behind `before`, and writes another value to it.
fn write_behind(bench: &mut Bench<'_>, before: &[MappedTarget]) -> CheckStep {
    let entry = mappable(bench, RPDO)?;
    let pdo = emptied(bench, RPDO, &[(2, 255)]).or_else(|_| emptied(bench, RPDO, &[(2, 254)]))?;
    let mapped: Vec<MappedTarget> = before.iter().copied().chain([entry]).collect();
    for sub in (1..).take(mapped.len()) {
        bench.described.needs_writable(pdo.mapping(), sub)?;
    }
    map(bench, pdo.mapping(), &mapped)?;
    pdo.enable(bench)?;
    let (index, sub, _) = entry;
    let old = bench.read(index, sub)?;
    let Some(new) = bench.described.needs(index, sub)?.other_than(&old) else {
        return absent("another value");
    };
    let mut frame: Vec<u8> = before.iter().flat_map(|mapped| vec![0xFF; usize::from(mapped.2) / 8]).collect();
    frame.extend(&new);
    bench.start();
    bench.send(pdo.id, &frame);
    bench.expect(index, sub, &new)
}

fn rpdo_procedure(bench: &mut Bench<'_>) -> CheckStep {
    write_behind(bench, &[])
}

fn dummy(bench: &mut Bench<'_>) -> CheckStep {
    if mappable(bench, RPDO)?.2 > 48 {
        return absent("a mappable entry of at most six bytes");
    }
    write_behind(bench, &[(6, 0, 16)])
}

fn while_valid(bench: &mut Bench<'_>, kind: PdoDirection) -> CheckStep {
    let pdo = set_up(bench, kind, &[])?;
    bench.refuse(pdo.mapping(), 0, 0, Abort::UnsupportedAccess)
}

fn while_counted(bench: &mut Bench<'_>, kind: PdoDirection) -> CheckStep {
    let pdo = emptied(bench, kind, &[])?;
    let entry = mappable(bench, kind)?;
    map(bench, pdo.mapping(), &[entry])?;
    bench.refuse(pdo.mapping(), 1, mapping_of(entry), Abort::UnsupportedAccess)
}

fn refused(bench: &mut Bench<'_>, kind: PdoDirection, entry: MappedTarget) -> CheckStep {
    let pdo = emptied(bench, kind, &[])?;
    bench.refuse(pdo.mapping(), 1, mapping_of(entry), Abort::NotMappable)
}

/// CiA 301 allows two abort codes.
fn no_object(bench: &mut Bench<'_>, kind: PdoDirection) -> CheckStep {
    let entry = (bench.described.unused(), 0, 8);
    match refused(bench, kind, entry) {
        Err(Verdict::Failed(_)) => {
            let pdo = emptied(bench, kind, &[])?;
            bench.refuse(pdo.mapping(), 1, mapping_of(entry), Abort::NoObject)
        }
        verdict => verdict,
    }
}

fn wrong_length(bench: &mut Bench<'_>, kind: PdoDirection) -> CheckStep {
    let (index, sub, bits) = mappable(bench, kind)?;
    refused(bench, kind, (index, sub, if bits == 8 { 16 } else { 8 }))
}

fn not_mappable(bench: &Bench<'_>) -> CheckStep<MappedTarget> {
    let entry = bench.described.entries.iter().find(|entry| entry.fits == [false; 2] && entry.is_integer());
    match entry {
        Some(entry) => Ok((entry.index, entry.sub, (8 * entry.size().unwrap_or(0)) as u8)),
        None => absent("an entry that is not mappable"),
    }
}

fn too_many(bench: &mut Bench<'_>, kind: PdoDirection) -> CheckStep {
    let pdo = emptied(bench, kind, &[])?;
    let most = bench
        .described
        .object(pdo.mapping())
        .map(|entry| entry.sub)
        .filter(|sub| *sub <= 64)
        .max()
        .unwrap_or(0);
    bench.refuse(pdo.mapping(), 0, u64::from(most) + 1, Abort::PdoTooLong)
}

fn too_long(bench: &mut Bench<'_>, kind: PdoDirection) -> CheckStep {
    let pdo = emptied(bench, kind, &[])?;
    let entry = mappable(bench, kind)?;
    let count = 64 / entry.2 + 1;
    for sub in 1..=count {
        bench.described.needs_writable(pdo.mapping(), sub)?;
        bench.write(pdo.mapping(), sub, mapping_of(entry))?;
    }
    bench.refuse(pdo.mapping(), 0, u64::from(count), Abort::PdoTooLong)
}
