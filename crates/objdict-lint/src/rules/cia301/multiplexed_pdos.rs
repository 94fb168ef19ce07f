//! Multiplexed PDOs with their scanner and dispatching lists.

use crate::diagnostic::{Findings, say};
use crate::model::{Device, Object, PdoKind};
use crate::rule::rules;
use crate::{Facts, PdoFacts, stated};

rules! {
    "cia301/listed-entry-missing" = LISTED_ENTRY_MISSING, Error, Object(listed_entry_missing);
    summary: "a list of multiplexed PDOs names an entry that does not exist",
    checks: "Whether each value of an object scanner list (1FA0h to 1FCFh) and the local entry of each value of an object dispatching list (1FD0h to 1FFFh) is described, with all sub-indexes of its block. Modular devices are not checked.",
    why: "The device cannot send the entry, and discards what it receives for it.",
    example: "`[1FA0sub1]` with `DefaultValue=0x01200001`, without `[2000sub1]`",
    remedy: "Describe the entry, or write 0 for an unused place of the list.",
    source: "CiA 301 §7.5.2.39, §7.5.2.40",

    "cia301/multiplexed-pdo-transmission-type" = MULTIPLEXED_PDO_TRANSMISSION_TYPE, Warning,
        Pdo(multiplexed_pdo_transmission_type);
    summary: "a multiplexed PDO has a synchronous transmission type",
    checks: "Whether the transmission type of each multiplexed PDO (sub-index 0 of the mapping is 254 or 255) is 254 or 255.",
    why: "A multiplexed PDO transmits one entry per frame when that entry changes. SYNC cannot trigger it.",
    example: "`[1A00sub0]` with `DefaultValue=255` and `[1800sub2]` with `DefaultValue=1`",
    remedy: "Write 254 or 255.",
    source: "CiA 301 §7.2.2.6, §7.5.2.36",

    "cia301/multiplexed-pdo-without-list" = MULTIPLEXED_PDO_WITHOUT_LIST, Error,
        Facts(multiplexed_pdo_without_list);
    summary: "a multiplexed PDO in source address mode has no list",
    checks: "Whether a device with a TPDO whose mapping has 254 in sub-index 0 has an object scanner list (1FA0h to 1FCFh), and one with such an RPDO an object dispatching list (1FD0h to 1FFFh).",
    why: "In source address mode, the lists define which entries are sent and where received entries are written. Without them nothing is sent, and received data are discarded.",
    example: "`[1600sub0]` with `DefaultValue=254`, without `[1FD0]`",
    remedy: "Add the list, or write 255 to sub-index 0 for destination address mode, which needs no list.",
    source: "CiA 301 §7.2.2.6, §7.5.2.39, §7.5.2.40",
}

fn listed_entry_missing(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    // the local index of a dispatching list begins 32 bits further up
    let shift = match index {
        0x1FA0..=0x1FCF => 0,
        0x1FD0..=0x1FFF => 32,
        _ => return,
    };
    if device.is_modular() {
        return;
    }
    for (sub, _) in object.entries().filter(|(sub, _)| (1..0xFF).contains(sub)) {
        let value = object.value(sub).and_then(|value| value.as_integer());
        let Some(value) = value.and_then(|value| u64::try_from(value).ok()).filter(|&value| value != 0)
        else {
            continue;
        };
        let [.., block, high, low, first] = (value >> shift).to_be_bytes();
        let target = u16::from_be_bytes([high, low]);
        let last = first.saturating_add(block.saturating_sub(1));
        let lacks = |sub: &u8| device.object(target).and_then(|target| target.entry(*sub)).is_none();
        let Some(missing) = (first..=last).find(lacks) else { continue };
        // an object without a section of its own
        if stated::is_there(device, target) && device.object(target).is_none_or(|target| target.orphan) {
            continue;
        }
        let message =
            say!("{:04X}h names {:04X}h:{:02X}, but there is no such entry", index, target, missing);
        let finding = LISTED_ENTRY_MISSING.at(device.value_place(index, sub), message);
        findings.push(finding.help("describe the entry, or write 0"));
    }
}

fn multiplexed_pdo_transmission_type(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(transmission_type @ 0..=240) = pdo.transmission_type.filter(|_| pdo.is_multiplexed()) else {
        return;
    };
    let place = facts.device.value_place(pdo.communication_index(), 2);
    let message =
        say!("{} is a multiplexed PDO, but transmission type `{}` is synchronous", pdo, transmission_type);
    let finding = MULTIPLEXED_PDO_TRANSMISSION_TYPE
        .at(place, message)
        .label(facts.device.value_place(pdo.mapping_index(), 0), "this makes it a multiplexed PDO");
    findings.push(finding.help("write 254 or 255"));
}

fn multiplexed_pdo_without_list(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    for kind in PdoKind::ALL {
        let (first, last, name) = match kind {
            PdoKind::Tpdo => (0x1FA0, 0x1FCF, "object scanner list"),
            PdoKind::Rpdo => (0x1FD0, 0x1FFF, "object dispatching list"),
        };
        let mut pdos = facts.pdos.iter().map(|facts| &facts.pdo).filter(|pdo| pdo.kind == kind);
        let Some(pdo) = pdos.find(|pdo| pdo.mapped_count == Some(0xFE)) else { continue };
        let is_listed = device.lists.iter().any(|(_, index)| (first..=last).contains(&index));
        if is_listed || device.objects.range(first..=last).next().is_some() {
            continue;
        }
        let message = say!("{} is a multiplexed PDO in source address mode, but there is no {}", pdo, name);
        let finding = MULTIPLEXED_PDO_WITHOUT_LIST.at(device.value_place(pdo.mapping_index(), 0), message);
        findings.push(finding.help(say!(
            "add {:04X}h ({}), or write 255 for destination address mode",
            first,
            name
        )));
    }
}
