//! RPDOs (CiA 301 §7.2.2, §7.5.2.35).

use super::bench::{Bench, ENTER_PRE_OPERATIONAL, MS, STOP};
use super::described::DescribedEntry;
use super::emergency::{can_id, expect_history, expect_message};
use super::pdo::{CheckedPdo, RPDO, is_observable, reserved_types, set_up};
use super::sync_frame::{send_sync, sync_id};
use super::{CheckStep, checks, ensure, impossible};

checks! { "RPDO":
    "7.2.2.2" "type 0: written at the next SYNC" |bench| at_sync(bench, 0);
    "7.2.2.2" "type 1: written at the next SYNC" |bench| at_sync(bench, 1);
    "7.2.2.2" "type 240: written at the next SYNC" |bench| at_sync(bench, 240);
    "7.2.2.2" "type 254: written at once" |bench| at_once(bench, 254);
    "7.2.2.2" "type 255: written at once" |bench| at_once(bench, 255);
    "7.3.2.2" "ignored in pre-operational" |bench| ignored(bench, |bench, _| { bench.command(ENTER_PRE_OPERATIONAL); Ok(()) });
    "7.3.2.2" "ignored in stopped" |bench| ignored(bench, |bench, _| { bench.command(STOP); Ok(()) });
    "7.5.2.35" "bit 31 of the COB-ID: ignored" |bench| ignored(bench, |bench, pdo| pdo.disable(bench));
    "7.2.7" "too short: ignored, emergency 8210h" too_short;
    "7.2.7" "too long: the first bytes, emergency 8220h" too_long;
    "7.2.2" "missing for its event timer: emergency 8250h" overdue;
    "7.2.2" "two RPDOs with one CAN-ID are both written" both;
    "7.5.2.35" "reserved transmission types are rejected" |bench| reserved_types(bench, RPDO);
    "7.5.2.35" "a new CAN-ID while it is valid is rejected" |bench| { let pdo = set_up(bench, RPDO, &[])?; pdo.refuse_cob_id(bench, u64::from(pdo.id) ^ 1) };
    "7.3.5" "a restricted CAN-ID is rejected" |bench| { let pdo = set_up(bench, RPDO, &[])?; pdo.disable(bench)?; pdo.refuse_cob_id(bench, 0x601) };
    "7.5.2.35" "a CAN-ID of 29 bits is rejected" |bench| { let pdo = set_up(bench, RPDO, &[])?; pdo.disable(bench)?; pdo.refuse_cob_id(bench, 0x2000_0201) };
    "7.3.5" "the CAN-ID of SYNC is rejected" |bench| { let pdo = set_up(bench, RPDO, &[])?; pdo.disable(bench)?; let id = sync_id(bench)?; pdo.refuse_cob_id(bench, u64::from(id)) };
}

/// A frame that gives a mapped entry another value: the frame, the entry, and its old and new value.
struct RpdoChange {
    frame: Vec<u8>,
    index: u16,
    sub: u8,
    old: Vec<u8>,
    new: Vec<u8>,
}

fn change(bench: &mut Bench<'_>, pdo: &CheckedPdo) -> CheckStep<RpdoChange> {
    let mut frame = pdo_bytes(bench, pdo)?;
    let length = frame.len();
    frame.resize(8, 0);
    let mut bits = u64::from_le_bytes(frame.try_into().unwrap_or_default());
    let mut first = 0;
    for &(index, sub, width) in &pdo.mapped {
        if is_observable(bench, index, sub) {
            let old = bench.read(index, sub)?;
            let entry = bench.described.needs(index, sub)?;
            if let Some(new) = entry.other_than(&old) {
                let word =
                    |bytes: &[u8]| bytes.iter().rev().fold(0_u64, |word, &byte| word << 8 | u64::from(byte));
                bits ^= (word(&old) ^ word(&new)) << first;
                return Ok(RpdoChange { frame: bits.to_le_bytes()[..length].to_vec(), index, sub, old, new });
            }
        }
        first += u32::from(width);
    }
    impossible("no mapped entry can be changed and read")
}

/// The present values as a frame; 0 for those that cannot be read.
fn pdo_bytes(bench: &mut Bench<'_>, pdo: &CheckedPdo) -> CheckStep<Vec<u8>> {
    let is_readable = |&(index, sub, _): &super::pdo::MappedTarget| {
        bench.described.find(index, sub).is_none_or(DescribedEntry::is_readable)
    };
    let mapped = pdo
        .mapped
        .iter()
        .map(|mapped| if is_readable(mapped) { *mapped } else { (5, 0, mapped.2) })
        .collect();
    CheckedPdo { communication: pdo.communication, id: pdo.id, mapped }.packed(bench)
}

fn at_once(bench: &mut Bench<'_>, transmission_type: u64) -> CheckStep {
    let pdo = set_up(bench, RPDO, &[(2, transmission_type)])?;
    let change = change(bench, &pdo)?;
    bench.start();
    bench.send(pdo.id, &change.frame);
    bench.expect(change.index, change.sub, &change.new)
}

fn at_sync(bench: &mut Bench<'_>, transmission_type: u64) -> CheckStep {
    let pdo = set_up(bench, RPDO, &[(2, transmission_type)])?;
    let change = change(bench, &pdo)?;
    bench.start();
    bench.send(pdo.id, &change.frame);
    bench.expect(change.index, change.sub, &change.old)?;
    send_sync(bench, 1)?;
    bench.expect(change.index, change.sub, &change.new)
}

/// An event-driven RPDO.
fn event_driven(bench: &mut Bench<'_>) -> CheckStep<CheckedPdo> {
    set_up(bench, RPDO, &[(2, 255)]).or_else(|_| set_up(bench, RPDO, &[(2, 254)]))
}

fn ignored(
    bench: &mut Bench<'_>,
    prepare: impl FnOnce(&mut Bench<'_>, &CheckedPdo) -> CheckStep,
) -> CheckStep {
    let pdo = event_driven(bench)?;
    let change = change(bench, &pdo)?;
    bench.start();
    prepare(bench, &pdo)?;
    bench.send(pdo.id, &change.frame);
    bench.command(ENTER_PRE_OPERATIONAL);
    bench.expect(change.index, change.sub, &change.old)
}

/// What the node says after a frame.
fn messages_after(bench: &mut Bench<'_>, id: u16, data: &[u8]) -> CheckStep<Vec<super::bench::SentFrame>> {
    let emergency = can_id(bench)?;
    let mut sent: Vec<_> = bench.send(id, data).into_iter().map(|frame| (0, frame)).collect();
    sent.extend(bench.run(MS));
    sent.retain(|(_, frame)| frame.id() == emergency);
    Ok(sent)
}

fn too_short(bench: &mut Bench<'_>) -> CheckStep {
    let pdo = event_driven(bench)?;
    let change = change(bench, &pdo)?;
    bench.start();
    let sent = messages_after(bench, pdo.id, &change.frame[1..])?;
    expect_message(&sent, 0x8210, 0x10)?;
    expect_history(bench, 0x8210)?;
    bench.expect(change.index, change.sub, &change.old)
}

fn too_long(bench: &mut Bench<'_>) -> CheckStep {
    let pdo = event_driven(bench)?;
    let mut change = change(bench, &pdo)?;
    if change.frame.len() == 8 {
        return impossible("its mapping has eight bytes");
    }
    change.frame.push(0xA5);
    bench.start();
    let sent = messages_after(bench, pdo.id, &change.frame)?;
    expect_message(&sent, 0x8220, 0x10)?;
    expect_history(bench, 0x8220)?;
    bench.expect(change.index, change.sub, &change.new)
}

fn overdue(bench: &mut Bench<'_>) -> CheckStep {
    let pdo =
        set_up(bench, RPDO, &[(2, 255), (5, 50)]).or_else(|_| set_up(bench, RPDO, &[(2, 254), (5, 50)]))?;
    let frame = pdo_bytes(bench, &pdo)?;
    let emergency = can_id(bench)?;
    bench.start();
    let before = bench.listen(emergency, 100 * MS);
    ensure(before.is_empty(), || "it is monitored before it came".into())?;
    bench.send(pdo.id, &frame);
    let early = bench.listen(emergency, 49 * MS);
    ensure(early.is_empty(), || "the emergency message is too early".into())?;
    let late = bench.listen(emergency, 2 * MS);
    expect_message(&late, 0x8250, 0x10)?;
    expect_history(bench, 0x8250)
}

fn both(bench: &mut Bench<'_>) -> CheckStep {
    let first = event_driven(bench)?;
    let [one, other] = two_changes(bench)?;
    let second = CheckedPdo { communication: one.communication, id: first.id, mapped: one.mapped };
    let third = CheckedPdo { communication: other.communication, id: first.id, mapped: other.mapped };
    for pdo in [&second, &third] {
        let cob_id = bench.described.number(pdo.communication, 1);
        bench.write(pdo.communication, 1, cob_id | 1 << 31).or_else(|_| pdo.disable(bench))?;
        pdo.enable(bench)?;
    }
    let changes = [change(bench, &second)?, change(bench, &third)?];
    let frame: Vec<u8> = changes[0].frame.clone();
    bench.start();
    bench.send(first.id, &frame);
    let expected = pdo_bytes(bench, &second)?;
    ensure(expected == frame, || "the first one is not written".into())?;
    let expected = pdo_bytes(bench, &third)?;
    ensure(expected == frame, || "the second one is not written".into())
}

/// Two event-driven RPDOs of one length with other entries and no limits, as the description maps them.
fn two_changes(bench: &Bench<'_>) -> CheckStep<[CheckedPdo; 2]> {
    let described = bench.described;
    let is_free = |&(index, sub, bits): &super::pdo::MappedTarget| {
        let entry = described.find(index, sub);
        is_observable(bench, index, sub)
            && entry.is_some_and(|entry| {
                entry.low.is_none() && entry.high.is_none() && entry.size() == Some(usize::from(bits) / 8)
            })
    };
    let usable = super::pdo::all(bench, RPDO).into_iter().filter(|&communication| {
        described.needs_writable(communication, 1).is_ok()
            && described.number(communication, 1) >> 29 & 1 == 0
            && (described.find(communication, 2).is_none() || described.number(communication, 2) >= 254)
    });
    let mut usable: Vec<CheckedPdo> = usable
        .map(|communication| CheckedPdo {
            communication,
            id: 0,
            mapped: super::pdo::default_mapping(bench, communication),
        })
        .filter(|pdo| !pdo.mapped.is_empty() && pdo.mapped.iter().all(is_free))
        .collect();
    let bits = |pdo: &CheckedPdo| pdo.mapped.iter().map(|mapped| u32::from(mapped.2)).sum::<u32>();
    usable.retain(|pdo| bits(pdo) <= 64);
    while let Some(one) = usable.pop() {
        let other = usable.iter().position(|other| {
            bits(other) == bits(&one) && !other.mapped.iter().any(|mapped| one.mapped.contains(mapped))
        });
        if let Some(at) = other {
            return Ok([usable.swap_remove(at), one]);
        }
    }
    super::absent("two RPDOs of one length with values that any frame may have")
}
