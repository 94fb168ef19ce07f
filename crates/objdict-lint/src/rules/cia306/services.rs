//! `[DeviceInfo]` flags of services: boot-up, network manager, LSS and group messaging.

use crate::diagnostic::{Findings, Severity, say, series_or};
use crate::model::{Access, Device, Field, Object, Part, Place, Value};
use crate::rule::rules;
use crate::{Facts, stated};

rules! {
    "cia306/boot-up-master-without-startup" = BOOT_UP_MASTER_WITHOUT_STARTUP, Note,
        Device(boot_up_master_without_startup);
    summary: "a boot-up master lacks 1F80h, NMT startup",
    checks: "Whether a device with `SimpleBootUpMaster=1` has 1F80h, NMT startup.",
    why: "A configuration tool uses 1F80h to make the device the NMT master. Without 1F80h, a tool can neither configure how the device starts the network nor turn the master off.",
    example: "`SimpleBootUpMaster=1` without `[1F80]`",
    remedy: "Add 1F80h, an UNSIGNED32, or write `SimpleBootUpMaster=0`.",
    source: "CiA 306-1 §4.5, CiA 302-2",

    "cia306/group-messaging-flag" = GROUP_MESSAGING_FLAG, Warning, Facts(group_messaging_flag);
    summary: "`GroupMessaging` and the PDOs disagree",
    checks: "Whether a device with multiplexed PDOs (mapping count 254 or 255) or with their lists (1FA0h to 1FFFh) has `GroupMessaging=1`, and whether a device with `GroupMessaging=1` has such a list or such a PDO. A device with a writable mapping, which can make a PDO multiplexed, is a note.",
    why: "Tools offer multiplexed PDOs only for devices with the flag. With a wrong flag they configure PDOs that the device does not support.",
    example: "`[1A00sub0]` with `DefaultValue=255` and `GroupMessaging=0`",
    remedy: "Correct the flag.",
    source: "CiA 306-1 §4.5, CiA 301 §7.5.2.36",

    "cia306/lss-serial-number" = LSS_SERIAL_NUMBER, Warning, Device(lss_serial_number);
    summary: "the serial number for LSS differs from 1018h",
    checks: "Whether `LSS_SerialNumber` equals 1018h sub-index 4, where both are given and not 0.",
    why: "LSS selects the node by its serial number; with a wrong number the node does not answer.",
    example: "`LSS_SerialNumber=1234` and `ParameterValue=1235` in `[1018sub4]`",
    remedy: "Write the number from the device label in both places.",
    source: "CiA 306-1 §5.4",

    "cia306/lss-without-identity" = LSS_WITHOUT_IDENTITY, Warning, Device(lss_without_identity);
    summary: "the device supports LSS, but its identity is incomplete",
    checks: "Whether 1018h of a device with `LSS_Supported=1` has vendor-ID, product code, revision number and serial number.",
    why: "LSS addresses a device by these four numbers. A device without one of them cannot be selected.",
    example: "`LSS_Supported=1` and a 1018h that ends with sub-index 1",
    remedy: "Describe sub-indexes 1 to 4 of 1018h, or write `LSS_Supported=0`.",
    source: "CiA 305, CiA 301 §7.5.2.21",

    "cia306/manager-without-nmt-master" = MANAGER_WITHOUT_NMT_MASTER, Warning,
        Device(manager_without_nmt_master);
    summary: "the network manager is not an NMT master",
    checks: "Whether a DCF with `CANopenManager=1` has `SimpleBootUpMaster=1` or 1F80h, NMT startup.",
    why: "The manager starts and monitors the other nodes. Without an NMT master they stay in the state after power-on.",
    example: "`CANopenManager=1`, `SimpleBootUpMaster=0`, and no `[1F80]`",
    remedy: "Write `CANopenManager=0`, or correct `SimpleBootUpMaster`.",
    source: "CiA 306-1 §5.4, CiA 302-2",
}

fn boot_up_master_without_startup(device: &Device, findings: &mut Findings) {
    let is_master = device.device_info.as_ref().is_some_and(|info| info.simple_boot_up_master == Some(true));
    if !is_master || stated::is_there(device, 0x1F80) {
        return;
    }
    let place = Place::of(Part::DeviceInfo).field(Field::SimpleBootUpMaster);
    let message = "the device is a boot-up master, but 1F80h (NMT startup) is missing";
    let finding = BOOT_UP_MASTER_WITHOUT_STARTUP.at(place, message);
    findings.push(finding.help("add 1F80h (NMT startup, UNSIGNED32), or write 0"));
}

fn group_messaging_flag(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let Some(flag) = device.device_info.as_ref().and_then(|info| info.group_messaging) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::GroupMessaging);
    let multiplexed = facts.pdos.iter().map(|facts| &facts.pdo).find(|pdo| pdo.is_multiplexed());
    let list = device.objects.range(0x1FA0..=0x1FFF).next();
    let finding = match (flag, multiplexed, list) {
        (false, Some(pdo), _) => {
            let finding = GROUP_MESSAGING_FLAG.at(
                place,
                say!("{} is a multiplexed PDO, but `{GroupMessaging}` is {GroupMessaging:0}", pdo),
            );
            finding.label(device.value_place(pdo.mapping_index(), 0), "multiplexed by this value")
        }
        (false, None, Some((&index, _))) => {
            let message =
                say!("{:04X}h is for multiplexed PDOs, but `{GroupMessaging}` is {GroupMessaging:0}", index);
            GROUP_MESSAGING_FLAG.at(place, message).label(Place::object(index), "the list")
        }
        (true, None, None) if has_dynamic_mapping(facts) => {
            let message =
                say!("`{GroupMessaging}` is {GroupMessaging:1}, but no PDO is multiplexed by default");
            GROUP_MESSAGING_FLAG.at(place, message).severity(Severity::Note)
        }
        (true, None, None) => {
            GROUP_MESSAGING_FLAG.at(place, "the device has no multiplexed PDO and no PDO that can become one")
        }
        _ => return,
    };
    findings.push(finding.help("correct the flag"));
}

/// Whether the device has or implies a PDO with a writable number of mapped objects.
fn has_dynamic_mapping(facts: &Facts<'_>) -> bool {
    let writable = |object: &Object| {
        object.subs.get(0).is_some_and(|entry| entry.access.is_none_or(Access::is_writable))
    };
    let is_implied =
        facts.device.device_info.as_ref().is_some_and(|info| info.compact_pdo.is_some_and(|mask| mask != 0));
    is_implied || facts.pdos.iter().filter_map(|facts| facts.pdo.mapping).any(writable)
}

fn lss_serial_number(device: &Device, findings: &mut Findings) {
    let stated = device.commissioning.as_ref().and_then(|node| node.lss_serial_number);
    let Some(stated) = stated.filter(|&number| number != 0) else { return };
    let Some(entry) = device.entry(0x1018, 4) else { return };
    let field = if entry.configured_value().is_some() { Field::ParameterValue } else { Field::DefaultValue };
    // an EDS has 0 for a number that differs in each device
    let Some(value) = entry.value().and_then(Value::as_integer).filter(|&value| value != 0) else {
        return;
    };
    if value != i128::from(stated) {
        let message = say!("`{LSS_SerialNumber}` is {}, but 1018h sub-index 4 is {}", stated, value);
        let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
        let finding = LSS_SERIAL_NUMBER
            .at(place, message)
            .label(Place::entry(0x1018, 4).field(field), "the serial number of the identity object");
        findings.push(finding.help("write the serial number of the device in both places"));
    }
}

const IDENTITY_NAMES: [&str; 4] = ["vendor-ID", "product code", "revision number", "serial number"];

fn lss_without_identity(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    // another rule reports a missing 1018h
    let Some(identity) = device.object(0x1018).filter(|_| info.lss_supported == Some(true)) else { return };
    let missing: Vec<&str> = (1..)
        .zip(IDENTITY_NAMES)
        .filter(|&(sub, _)| identity.entry(sub).is_none())
        .map(|(_, name)| name)
        .collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("`{LSS_Supported}` is {LSS_Supported:1}, but 1018h has no {}", series_or(&missing));
    let finding = LSS_WITHOUT_IDENTITY
        .at(Place::object(0x1018), message)
        .label(Place::of(Part::DeviceInfo).field(Field::LssSupported), "LSS is supported");
    findings.push(finding.help(say!("describe sub-indexes 1 to 4 of 1018h, or write `{LSS_Supported=0}`")));
}

fn manager_without_nmt_master(device: &Device, findings: &mut Findings) {
    let is_manager = device.commissioning.as_ref().is_some_and(|node| node.manager == Some(true));
    let refuses = device.device_info.as_ref().is_some_and(|info| info.simple_boot_up_master == Some(false));
    if !is_manager || !refuses || stated::is_there(device, 0x1F80) {
        return;
    }
    let place = Place::of(Part::Commissioning).field(Field::CanOpenManager);
    let finding =
        MANAGER_WITHOUT_NMT_MASTER.at(place, "the node is the network manager, but not an NMT master").label(
            Place::of(Part::DeviceInfo).field(Field::SimpleBootUpMaster),
            "not an NMT master, and 1F80h is missing",
        );
    findings.push(finding.help(say!("write `{CANopenManager=0}`, or correct `{SimpleBootUpMaster}`")));
}
