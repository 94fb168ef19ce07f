//! Storing and restoring parameters, the stored EDS and the configuration date.

use crate::diagnostic::{Findings, Fix, Severity, Text, say, sub_index};
use crate::model::{Device, DeviceKind, Entry, Field, Place, Value};
use crate::rule::rules;
use crate::{Facts, stated};

rules! {
    source: "CiA 301 §7.5.2.13, §7.5.2.14";

    "cia301/incomplete-eds-storage" = INCOMPLETE_EDS_STORAGE, Error, Device(incomplete_eds_storage);
    summary: "one of the two objects that store the EDS is missing",
    checks: "A device that stores its EDS must have both 1021h, the file, and 1022h, its format. CiA 301 requires 1022h with 1021h. 1022h without 1021h is useless and a warning.",
    why: "A tool cannot unpack a file of unknown format, and a format without the file is useless.",
    example: "`[1021]` without `[1022]`",
    remedy: "Add the missing object: 1021h is a DOMAIN, 1022h an UNSIGNED8 or UNSIGNED16 with 0 for an uncompressed file.",
    source: "CiA 301 §7.5.2.24, §7.5.2.25",

    "cia301/invalid-configuration-date" = INVALID_CONFIGURATION_DATE, Warning,
        Facts(invalid_configuration_date);
    summary: "the configuration date is impossible",
    checks: "In an EDS, 1020h (verify configuration) must be 0. In a DCF, it must contain a time below 86400000 ms and a date with it. The expected times in a manager's 1F27h must be below 86400000 ms too.",
    why: "A manager that reads its own date from 1020h assumes that the device is configured and writes nothing. A new device with a date, or one with an impossible time, is never configured or is configured at every start.",
    example: "`[1020sub2]` with `ParameterValue=90000000`",
    remedy: "Write the days since 1984-01-01 to sub-index 1 and the milliseconds since midnight to sub-index 2; 0 to both in an EDS.",
    source: "CiA 301 §7.5.2.23; CiA 302-3 (1F27h)",

    "cia301/storage-signature-as-default" = STORAGE_SIGNATURE_AS_DEFAULT, Warning,
        Device(storage_signature_as_default), fix Unsafe;
    summary: "a default of 1010h or 1011h is not a value that the device returns",
    checks: "The defaults of 1010h must be 0 to 3 and the defaults of 1011h must be 0 or 1: the values that the device returns when the entry is read. Bit 0 means that it stores or restores on command, bit 1 of 1010h that it stores autonomously.",
    why: "The signatures `save` and `load` are written to the entries, not read from them. A tool that compares the device with its description finds a difference. A tool that writes the defaults stores or restores by accident.",
    example: "`[1010sub1]` with `DefaultValue=0x65766173`",
    remedy: "Write 1, or the value that the device returns.",

    "cia301/storage-without-function" = STORAGE_WITHOUT_FUNCTION, Warning, Device(storage_without_function);
    summary: "according to 1010h or 1011h, the device cannot store or restore anything",
    checks: "At least one value of 1010h must have bit 0 (stores on command) or bit 1 (stores by itself) set. At least one value of 1011h must have bit 0 (restores on command) set. The rule applies if all values are given.",
    why: "A tool reads the entries before it writes the signatures. With 0 it does not store the configuration, which is lost when the power is switched off.",
    example: "`[1010sub1]` with `DefaultValue=0` and no other sub-index",
    remedy: "Write the value that the device returns, 1 if it stores or restores on command. Alternatively, remove the object.",

    "cia301/store-without-restore" = STORE_WITHOUT_RESTORE, Note, Device(store_without_restore);
    summary: "the device has only one of 1010h and 1011h",
    checks: "A device with 1010h (store parameters) must have 1011h (restore default parameters), and the reverse.",
    why: "After storing a wrong bit rate or COB-ID, users need the factory settings back. On a device that stores nothing, restoring is useless.",
    example: "`[1010]` without `[1011]`",
    remedy: "Add the other object.",
}

fn incomplete_eds_storage(device: &Device, findings: &mut Findings) {
    let pairs = [
        (0x1021, 0x1022, "format of the EDS", Severity::Error),
        // required only with 1021h and useless without it
        (0x1022, 0x1021, "stored EDS", Severity::Warning),
    ];
    for (there, other, lacks, severity) in pairs {
        if device.objects.contains_key(&there) && !stated::is_there(device, other) {
            let message = say!("{:04X}h is described without {:04X}h ({})", there, other, lacks);
            let finding = INCOMPLETE_EDS_STORAGE.at(Place::object(there), message).severity(severity);
            findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", other, there)));
        }
    }
}

/// The milliseconds in a day.
const MILLISECONDS_OF_DAY: i128 = 86_400_000;

fn invalid_configuration_date(facts: &Facts<'_>, findings: &mut Findings) {
    let beyond_day = |index: u16, sub: u8, time: i128| {
        let message = say!("{} ms since midnight is more than a day ({} ms)", time, MILLISECONDS_OF_DAY);
        let finding = INVALID_CONFIGURATION_DATE.at(facts.device.value_place(index, sub), message);
        finding.help("write the milliseconds since midnight")
    };
    for node in 1..=127 {
        if let Some(time) = facts.number(0x1F27, node).filter(|&time| time >= MILLISECONDS_OF_DAY) {
            findings.push(beyond_day(0x1F27, node, time));
        }
    }
    let (Some(date), Some(time)) = (facts.number(0x1020, 1), facts.number(0x1020, 2)) else { return };
    let place = |sub| facts.device.value_place(0x1020, sub);
    let is_type = facts.device.kind == DeviceKind::Type;
    let finding = if is_type && (date, time) != (0, 0) {
        let message = say!(
            "the default configuration date is day {} at {} ms, but a new device is not configured",
            date,
            time
        );
        INVALID_CONFIGURATION_DATE
            .at(place(if date == 0 { 2 } else { 1 }), message)
            .help("write 0 to sub-indexes 1 and 2")
    } else if time >= MILLISECONDS_OF_DAY {
        beyond_day(0x1020, 2, time)
    } else if date == 0 && time != 0 {
        let message = "the configuration time is set without a date";
        INVALID_CONFIGURATION_DATE.at(place(1), message).help("write the days since 1984-01-01")
    } else {
        return;
    };
    findings.push(finding);
}

fn storage_signature_as_default(device: &Device, findings: &mut Findings) {
    for (index, known, signature) in [(0x1010, 3, 0x6576_6173), (0x1011, 1, 0x6461_6F6C)] {
        let Some(object) = device.object(index) else { continue };
        let shared = object.compact.as_ref().map(|_| (None, &object.main));
        let described = object.subs.iter().filter(|&(sub, _)| (1..=0x7F).contains(&sub));
        let mut wrong =
            shared.into_iter().chain(described.map(|(sub, entry)| (Some(sub), entry))).filter_map(
                |(sub, entry)| Some((sub, default_number(entry).filter(|number| number & !known != 0)?)),
            );
        let Some((sub, value)) = wrong.next() else { continue };
        let place = Place::at(index, sub).field(Field::DefaultValue);
        let which = sub.map_or_else(Text::default, |sub| say!(" sub-index {}", sub_index(sub)));
        let finding = if value == signature {
            let message = say!(
                "`0x{:08X}` is the signature for writing to {:04X}h{}, not the value read from it",
                value,
                index,
                which
            );
            STORAGE_SIGNATURE_AS_DEFAULT.at(place.clone(), message)
        } else {
            let message = say!("`0x{:08X}` of {:04X}h{} has reserved bits set", value, index, which);
            STORAGE_SIGNATURE_AS_DEFAULT.at(place.clone(), message)
        };
        let fix = Fix::risky("write `1`, the value for storing or restoring on command").set(place, "1");
        findings.push(
            finding
                .help("write the value that the device returns: 1 if it stores or restores on command")
                .fix(fix),
        );
    }
}

fn default_number(entry: &Entry) -> Option<i128> {
    entry.default.as_ref().and_then(Value::as_integer)
}

fn storage_without_function(device: &Device, findings: &mut Findings) {
    for (index, verb) in [(0x1010, "store"), (0x1011, "restore")] {
        let Some(object) = device.object(index) else { continue };
        let subs: Vec<u8> =
            object.entries().map(|(sub, _)| sub).filter(|sub| (1..=0x7F).contains(sub)).collect();
        let is_zero = |&sub: &u8| object.value(sub).is_some_and(|value| value.as_integer() == Some(0));
        let Some(&first) = subs.first().filter(|_| subs.iter().all(is_zero)) else { continue };
        let message = say!("{:04X}h is `0`: the device cannot {} anything", index, verb);
        let finding = STORAGE_WITHOUT_FUNCTION.at(device.value_place(index, first), message);
        findings
            .push(finding.help(say!("write 1 if the device can {} on command, or remove the object", verb)));
    }
}

fn store_without_restore(device: &Device, findings: &mut Findings) {
    let pairs = [
        (0x1010, 0x1011, "the device can store parameters (1010h), but not restore the defaults (1011h)"),
        (0x1011, 0x1010, "the device can restore the defaults (1011h), but not store parameters (1010h)"),
    ];
    for (there, other, message) in pairs {
        if device.objects.contains_key(&there) && !stated::is_there(device, other) {
            let finding = STORE_WITHOUT_RESTORE.at(Place::object(there), message);
            findings.push(finding.help(say!("add {:04X}h", other)));
        }
    }
}
