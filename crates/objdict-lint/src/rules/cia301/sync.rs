//! SYNC and TIME.

use crate::diagnostic::{Findings, Severity, say};
use crate::model::{Device, Object, PdoKind, Place};
use crate::rule::rules;
use crate::{CobIdService, Facts, PdoFacts, stated};

rules! {
    "cia301/invalid-sync-counter" = INVALID_SYNC_COUNTER, Error, Facts(invalid_sync_counter);
    summary: "the overflow value of the SYNC counter is reserved or does not match the PDOs",
    checks: "1019h must be 0 or 2 to 240. As a warning: it must be a multiple of n for each valid TPDO that is sent with every n-th SYNC.",
    why: "The device rejects 1 and values above 240. If the overflow value is not a multiple of n, the counter restarts within a cycle and the PDO is sent early once per counter period.",
    example: "`[1019]` with `DefaultValue=1`",
    remedy: "Write 0 to send SYNC without a counter, otherwise the least common multiple of the transmission types.",
    source: "CiA 301 §7.5.2.22",

    "cia301/invalid-sync-start-value" = INVALID_SYNC_START_VALUE, Error, Pdo(invalid_sync_start_value);
    summary: "a TPDO waits for a SYNC counter value that never occurs",
    checks: "The SYNC start value of each TPDO must be at most 240 and at most the overflow value of the SYNC counter, 1019h. A start value on a device without a counter has no effect and is a warning.",
    why: "The TPDO starts with the SYNC whose counter has the start value. The counter runs from 1 to the overflow value and never reaches a higher start value.",
    example: "`[1800sub6]` with `DefaultValue=12` and `[1019]` with `DefaultValue=10`",
    remedy: "Write 0 to start with any SYNC, or a value up to 1019h.",
    source: "CiA 301 §7.5.2.22, §7.5.2.37",

    "cia301/sync-object-without-sync" = SYNC_OBJECT_WITHOUT_SYNC, Warning, ObjectOf(sync_object_without_sync);
    summary: "the device has a SYNC object but no COB-ID for SYNC",
    checks: "A device with 1006h (communication cycle period), 1007h (synchronous window length) or 1019h (synchronous counter overflow value) must have 1005h, the COB-ID of SYNC.",
    why: "Period, window and counter belong to a SYNC message that the device does not support.",
    example: "`[1006]` without `[1005]`",
    remedy: "Add 1005h, or remove the object.",
    source: "CiA 301 §7.5.2.6, §7.5.2.7, §7.5.2.22",

    "cia301/sync-period-too-short" = SYNC_PERIOD_TOO_SHORT, Warning, Facts(sync_period_too_short);
    summary: "the SYNC period is shorter than a bus allows",
    checks: "1006h, the communication cycle period, must be 0 or at least 100 µs, configured or by default.",
    why: "At 1 Mbit/s, a SYNC message takes about 50 µs and each PDO of the cycle up to 135 µs. Such a value is usually a time in milliseconds, but the unit of the object is microseconds.",
    example: "`[1006]` with `DefaultValue=10`, for 10 ms",
    remedy: "Write the period in microseconds: 10000 for 10 ms.",
    source: "CiA 301 §7.5.2.6",

    "cia301/sync-producer-without-period" = SYNC_PRODUCER_WITHOUT_PERIOD, Warning,
        Facts(sync_producer_without_period);
    summary: "the device produces SYNC but has no communication cycle period",
    checks: "If bit 30 of 1005h is set (SYNC producer), the device must have 1006h (communication cycle period) with a value other than 0. The value 0 switches SYNC off. This is a warning if a valid PDO of the device is synchronous, otherwise a note.",
    why: "The period of SYNC is unknown, or a period of 0 switches SYNC off: synchronous PDOs are never sent.",
    example: "`[1005]` with `DefaultValue=0x40000080`, without `[1006]`",
    remedy: "Add 1006h, an UNSIGNED32 in microseconds, and write the period (in a `bus.yml` of dcfgen, `sync_period`). Alternatively, clear bit 30.",
    source: "CiA 301 §7.5.2.5, §7.5.2.6",

    "cia301/sync-window-above-period" = SYNC_WINDOW_ABOVE_PERIOD, Error, Facts(sync_window_above_period);
    summary: "the synchronous window is longer than the SYNC period",
    checks: "1007h (synchronous window length) must be at most 1006h (communication cycle period). Both are in microseconds; 0 disables them.",
    why: "Synchronous PDOs are sent within the window after SYNC. A window longer than the period never ends, and a device rejects it.",
    example: "`[1006]` with `DefaultValue=1000` and `[1007]` with `DefaultValue=5000`",
    remedy: "Shorten the window, or extend the period.",
    source: "CiA 301 §7.5.2.6, §7.5.2.7",

    "cia301/synchronous-pdo-without-sync" = SYNCHRONOUS_PDO_WITHOUT_SYNC, Error,
        Facts(synchronous_pdo_without_sync);
    summary: "a device has a synchronous PDO but no SYNC",
    checks: "A device with a valid PDO of a synchronous transmission type (0 to 240, for a TPDO also 252) must have 1005h, the COB-ID of SYNC. The rule reports one finding per device, which lists every such PDO.",
    why: "Without 1005h the device does not process SYNC, so the PDO is never sent or never applied.",
    example: "`[1801sub2]` with `DefaultValue=1`, without `[1005]`",
    remedy: "Add 1005h with the default 80h, or give the PDO transmission type 254 or 255.",
    source: "CiA 301 §7.5.2.5, §7.5.2.35, §7.5.2.37",

    "cia301/time-producer-and-consumer" = TIME_PRODUCER_AND_CONSUMER, Warning,
        Facts(time_producer_and_consumer);
    summary: "the device is both producer and consumer of TIME",
    checks: "1012h must not have both bit 31 (TIME consumer) and bit 30 (TIME producer) set.",
    why: "One device on a network produces the time for all others. A device that does both sets its clock from its own message.",
    example: "`[1012]` with `DefaultValue=0xC0000100`",
    remedy: "Clear one of the bits.",
    source: "CiA 301 §7.5.2.15",
}

fn invalid_sync_counter(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let value = device.value(0x1019, 0).and_then(|value| value.as_integer());
    let Some(overflow) = value.and_then(|value| u8::try_from(value).ok()) else { return };
    let place = device.value_place(0x1019, 0);
    if overflow == 1 || overflow > 240 {
        let message = say!("the overflow value `{}` of the SYNC counter is reserved", overflow);
        let finding = INVALID_SYNC_COUNTER.at(place, message);
        findings.push(finding.help("write 0 to disable the counter, or a value from 2 to 240"));
        return;
    }
    let cycles =
        |transmission_type: &u8| (2..=240).contains(transmission_type) && overflow % transmission_type != 0;
    let tpdos = facts.pdos.iter().map(|facts| &facts.pdo);
    let tpdos = tpdos.filter(|pdo| pdo.kind == PdoKind::Tpdo && pdo.is_valid() == Some(true));
    let mut broken = tpdos.filter_map(|pdo| Some((pdo, pdo.transmission_type.filter(cycles)?))).peekable();
    if overflow == 0 || broken.peek().is_none() {
        return;
    }
    let message = say!(
        "the SYNC counter overflows at `{}`, which is not a multiple of every transmission type",
        overflow
    );
    let finding = INVALID_SYNC_COUNTER.at(place, message).severity(Severity::Warning);
    let finding = finding.help("write the least common multiple of the transmission types");
    findings.push(broken.fold(finding, |finding, (pdo, every)| {
        let at = device.value_place(pdo.communication_index(), 2);
        finding.label(at, say!("{} has transmission type {}", pdo, every))
    }));
}

fn invalid_sync_start_value(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(start) = pdo.sync_start_value.filter(|&start| start > 0 && pdo.kind == PdoKind::Tpdo) else {
        return;
    };
    let device = facts.device;
    let finding =
        |message| INVALID_SYNC_START_VALUE.at(device.value_place(pdo.communication_index(), 6), message);
    let counter = device.value(0x1019, 0).and_then(|value| value.as_integer());
    if start > 240 {
        let finding = finding(say!("the SYNC start value `{}` of {} is out of range (0 to 240)", start, pdo));
        findings.push(finding.help("write 0 to start with any SYNC"));
        return;
    }
    match counter {
        None if device.objects.contains_key(&0x1019) => {}
        None | Some(0) => {
            let finding = finding(say!(
                "the SYNC start value `{}` of {} has no effect without a SYNC counter",
                start,
                pdo
            ));
            let finding = match counter {
                Some(_) => finding.label(device.value_place(0x1019, 0), "the counter is disabled here"),
                None => finding,
            };
            findings.push(finding.severity(Severity::Warning).help("write 0, or set 1019h"));
        }
        Some(overflow) if i128::from(start) > overflow => {
            let finding = finding(say!(
                "{} waits for SYNC counter `{}`, but the counter overflows at {}",
                pdo,
                start,
                overflow
            ));
            let finding = finding.label(device.value_place(0x1019, 0), "the overflow value");
            findings.push(finding.help(say!("write at most {}", overflow)));
        }
        Some(_) => {}
    }
}

fn sync_object_without_sync(device: &Device, index: u16, _: &Object, findings: &mut Findings) {
    let name = match index {
        0x1006 => "communication cycle period",
        0x1007 => "synchronous window length",
        0x1019 => "synchronous counter overflow value",
        _ => return,
    };
    if stated::is_there(device, 0x1005) {
        return;
    }
    let message = say!("{:04X}h ({}) is described without 1005h (COB-ID SYNC)", index, name);
    let finding = SYNC_OBJECT_WITHOUT_SYNC.at(Place::object(index), message);
    findings.push(finding.help(say!("add 1005h (COB-ID SYNC), or remove {:04X}h", index)));
}

fn sync_producer_without_period(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let sync = facts.cob_ids.iter().find(|cob_id| cob_id.service == CobIdService::Sync);
    let Some(sync) = sync.filter(|sync| sync.is_sent()) else { return };
    if !stated::is_there(device, 0x1006) {
        let message = say!(
            "`{}` makes the device a SYNC producer, but 1006h (communication cycle period) is missing",
            sync.cob_id
        );
        let finding = SYNC_PRODUCER_WITHOUT_PERIOD.at(device.value_place(0x1005, 0), message);
        findings.push(finding.help("add 1006h (UNSIGNED32), or clear bit 30 of 1005h"));
    } else if facts.number(0x1006, 0) == Some(0) {
        let message =
            say!("`{}` makes the device a SYNC producer, but a period of `0` disables SYNC", sync.cob_id);
        let finding = SYNC_PRODUCER_WITHOUT_PERIOD
            .at(device.value_place(0x1006, 0), message)
            .label(device.value_place(0x1005, 0), "bit 30 is set");
        let mut pdos = facts.pdos.iter().map(|facts| &facts.pdo);
        let needs_sync = pdos.any(|pdo| pdo.is_synchronous() && pdo.is_valid() == Some(true));
        let finding = if needs_sync { finding } else { finding.severity(Severity::Note) };
        findings.push(finding.help("write the period in microseconds, or clear bit 30 of 1005h"));
    }
}

/// In microseconds. A SYNC message has 44 to 52 bits, and so does a synchronous PDO of 0 bytes.
const SHORTEST_SYNC_PERIOD: i128 = 100;

fn sync_period_too_short(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(period) = facts.number(0x1006, 0) else { return };
    if (1..SHORTEST_SYNC_PERIOD).contains(&period) {
        let message = say!("the SYNC period is `{}` µs, shorter than the messages of a cycle", period);
        let finding = SYNC_PERIOD_TOO_SHORT.at(facts.device.value_place(0x1006, 0), message);
        findings.push(finding.help(say!(
            "write the period in microseconds, `{}` for {} ms",
            period * 1000,
            period
        )));
    }
}

fn sync_window_above_period(facts: &Facts<'_>, findings: &mut Findings) {
    let (Some(period), Some(window)) = (facts.number(0x1006, 0), facts.number(0x1007, 0)) else { return };
    if period == 0 || window <= period {
        return;
    }
    let message =
        say!("the synchronous window of {} µs is longer than the SYNC period of {} µs", window, period);
    let finding = SYNC_WINDOW_ABOVE_PERIOD
        .at(facts.device.value_place(0x1007, 0), message)
        .label(facts.device.value_place(0x1006, 0), "the SYNC period");
    findings.push(finding.help("shorten the window, or extend the period"));
}

fn synchronous_pdo_without_sync(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    if stated::is_there(device, 0x1005) {
        return;
    }
    let pdos = facts.pdos.iter().map(|facts| &facts.pdo);
    for pdo in pdos.filter(|pdo| pdo.is_synchronous() && pdo.is_valid() == Some(true)) {
        let transmission_type = pdo.transmission_type.unwrap_or_default();
        let message = say!(
            "{} has the synchronous transmission type `{}`, but 1005h (COB-ID SYNC) is missing",
            pdo,
            transmission_type
        );
        let place = device.value_place(pdo.communication_index(), 2);
        let finding = SYNCHRONOUS_PDO_WITHOUT_SYNC.at(place, message);
        let help = "add 1005h (UNSIGNED32, default `0x80`), or use transmission type 254 or 255";
        findings.push(finding.help(help));
    }
}

fn time_producer_and_consumer(facts: &Facts<'_>, findings: &mut Findings) {
    let time = facts.cob_ids.iter().find(|cob_id| cob_id.service == CobIdService::Time);
    let Some(time) = time.filter(|time| !time.cob_id.is_valid() && time.cob_id.bit_30()) else { return };
    let message = say!("`{}` makes the device both producer and consumer of TIME", time.cob_id);
    let finding = TIME_PRODUCER_AND_CONSUMER.at(facts.device.value_place(0x1012, 0), message);
    findings.push(finding.help("clear bit 30 for a consumer, or bit 31 for a producer"));
}
