//! `[DeviceInfo]`: keys, bit rates, the identity object and the flags of services: boot-up, network manager, LSS and group
//! messaging.

use crate::diagnostic::{Argument, Findings, Fix, Severity, listing, listing_or, say, series_or};
use crate::model::{Access, Device, DeviceInfo, DeviceKind, Field, Object, Part, Place, Value};
use crate::rule::rules;
use crate::{Facts, stated};

rules! {
    source: "CiA 306-1 §4.5";

    "cia306/boot-up-master-without-startup" = BOOT_UP_MASTER_WITHOUT_STARTUP, Note,
        Device(boot_up_master_without_startup);
    summary: "a boot-up master lacks 1F80h, NMT startup",
    checks: "A device with `SimpleBootUpMaster=1` must have 1F80h, NMT startup.",
    why: "A configuration tool uses 1F80h to make the device the NMT master. Without 1F80h, a tool can neither configure how the device starts the network nor turn the master off.",
    example: "`SimpleBootUpMaster=1` without `[1F80]`",
    remedy: "Add 1F80h, an UNSIGNED32, or write `SimpleBootUpMaster=0`.",
    source: "CiA 306-1 §4.5, CiA 302-2",

    "cia306/group-messaging-flag" = GROUP_MESSAGING_FLAG, Warning, Facts(group_messaging_flag);
    summary: "`GroupMessaging` and the PDOs disagree",
    checks: "A device with multiplexed PDOs (mapping count 254 or 255) or their lists (1FA0h to 1FFFh) must have `GroupMessaging=1`. A device with `GroupMessaging=1` must have such a list or such a PDO. A device with a writable mapping, which can make a PDO multiplexed, is a note.",
    why: "Tools offer multiplexed PDOs only for devices with the flag. With a wrong flag they configure PDOs that the device does not support.",
    example: "`[1A00sub0]` with `DefaultValue=255` and `GroupMessaging=0`",
    remedy: "Correct the flag.",
    source: "CiA 306-1 §4.5, CiA 301 §7.5.2.36",

    "cia306/identity-mismatch" = IDENTITY_MISMATCH, Error, Device(identity_mismatch), fix Unsafe;
    summary: "`[DeviceInfo]` and the identity object disagree",
    checks: "`VendorNumber`, `ProductNumber` and `RevisionNumber` must equal 1018h sub-indexes 1, 2 and 3, where both values are given. In a DCF, the configured value takes precedence over the default. The finding is a warning if one of the two is 0, because it was probably never filled in, or if only the configured value differs.",
    why: "A tool looks up the EDS by the values read from 1018h. With different numbers in `[DeviceInfo]`, the tool finds no EDS or the wrong one.",
    example: "`VendorNumber=0x59` and `DefaultValue=0x5A` in `[1018sub1]`",
    remedy: "Write the number that the device reports in both places.",

    "cia306/lss-serial-number" = LSS_SERIAL_NUMBER, Warning, Device(lss_serial_number);
    summary: "the serial number for LSS differs from 1018h",
    checks: "`LSS_SerialNumber` must equal 1018h sub-index 4, where both are given and not 0.",
    why: "LSS selects the node by its serial number. With a wrong number the node does not respond.",
    example: "`LSS_SerialNumber=1234` and `ParameterValue=1235` in `[1018sub4]`",
    remedy: "Write the number from the device label in both places.",
    source: "CiA 306-1 §5.4",

    "cia306/lss-without-identity" = LSS_WITHOUT_IDENTITY, Warning, Device(lss_without_identity);
    summary: "the device supports LSS, but its identity is incomplete",
    checks: "On a device with `LSS_Supported=1`, 1018h must have vendor-ID, product code, revision number and serial number.",
    why: "LSS addresses a device by these four numbers. A device without one of them cannot be selected.",
    example: "`LSS_Supported=1` and a 1018h that ends with sub-index 1",
    remedy: "Describe sub-indexes 1 to 4 of 1018h, or write `LSS_Supported=0`.",
    source: "CiA 305, CiA 301 §7.5.2.21",

    "cia306/manager-without-nmt-master" = MANAGER_WITHOUT_NMT_MASTER, Warning,
        Device(manager_without_nmt_master);
    summary: "the network manager is not an NMT master",
    checks: "A DCF with `CANopenManager=1` must have `SimpleBootUpMaster=1` or 1F80h, NMT startup.",
    why: "The manager starts and monitors the other nodes. Without an NMT master they keep their state after power-on.",
    example: "`CANopenManager=1`, `SimpleBootUpMaster=0`, and no `[1F80]`",
    remedy: "Write `CANopenManager=0`, or correct `SimpleBootUpMaster`.",
    source: "CiA 306-1 §5.4, CiA 302-2",

    "cia306/missing-device-info-key" = MISSING_DEVICE_INFO_KEY, Warning,
        Device(missing_device_info_key), fix Unsafe;
    summary: "`[DeviceInfo]` lacks mandatory keys",
    checks: "Vendor, product, order code, boot-up behaviour, granularity, dynamic channels, group messaging, PDO counts and LSS must be given. Names may be empty, but numbers may not. `BaudRate_x` of unsupported bit rates may be missing. The finding is a note in a DCF, which is for one known device, and if only the order code is missing. In real files, mostly the order code is missing, or the numbers of products that were never sold. Nearly all files without granularity, boot-up or group messaging are DCFs written by a tool, so two of three findings are notes.",
    why: "A configuration tool looks up the description by its numbers and uses the other keys to enable its functions. A conformance test rejects the file.",
    example: "`[DeviceInfo]` without `NrOfRXPDO`",
    remedy: "Add the keys. Write 0 for unsupported features.",

    "cia306/no-baud-rate" = NO_BAUD_RATE, Warning, Device(no_baud_rate);
    summary: "no supported bit rate is given",
    checks: "At least one `BaudRate_x` must be 1, unless the device detects the bit rate (`BaudRate_auto=1`).",
    why: "Configuration tools offer only the bit rates given here, so they offer none.",
    example: "`[DeviceInfo]` without any `BaudRate_x`",
    remedy: "Add `BaudRate_125=1` and the other supported bit rates.",

    "cia306/reserved-key" = RESERVED_KEY, Note, Device(reserved_key), fix Safe;
    summary: "`[DeviceInfo]` has a key of EDS version 3.0",
    checks: "Reports `ProductVersion`, `ProductRevision`, `LMT_ManufacturerName`, `LMT_ProductName`, `ExtendedBootUpMaster` and `ExtendedBootUpSlave`.",
    why: "Version 4.0 reserves these keys and readers ignore them, so their values have no effect.",
    example: "`ExtendedBootUpMaster=0`",
    remedy: "Remove the keys.",
}

fn identity_mismatch(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let numbers = [
        (1, Field::VendorNumber, info.vendor_number),
        (2, Field::ProductNumber, info.product_number),
        (3, Field::RevisionNumber, info.revision_number),
    ];
    for (sub, field, stated) in numbers {
        let (Some(stated), Some(entry)) = (stated, device.entry(0x1018, sub)) else { continue };
        let is_stated = |value: i128| value == i128::from(stated);
        let Some(value) = entry.value().and_then(Value::as_integer).filter(|&value| !is_stated(value)) else {
            continue;
        };
        // a value that a tool may have read from one node
        let is_of_node = entry.default.as_ref().and_then(Value::as_integer).is_some_and(is_stated);
        let title = say!("write `{}`", Argument::setting(&field, format_args!("0x{value:X}")));
        // only the author knows which of the two is right
        let fix =
            Fix::risky(title).set(Place::of(Part::DeviceInfo).field(field.clone()), format!("0x{value:X}"));
        let message = say!("`{}` is {:h}, but 1018h sub-index {} is {:h}", field, stated, sub, value);
        let finding = IDENTITY_MISMATCH
            .at(Place::of(Part::DeviceInfo).field(field), message)
            .severity(if stated == 0 || value == 0 || is_of_node {
                Severity::Warning
            } else {
                Severity::Error
            })
            .label(device.value_place(0x1018, sub), "the identity object");
        let finding = finding.help("in both places, write the number that the device reports");
        findings.push(if value > 0 { finding.fix(fix) } else { finding });
    }
}

fn missing_device_info_key(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let missing: Vec<Field> = stated_keys(info)
        .into_iter()
        .filter(|(field, stated)| !stated && info.invalid_values.get(field).is_none())
        .map(|(field, _)| field)
        .collect();
    let Some(first) = missing.first() else { return };
    // a name may be empty, so its key is missing; the key of a number may be present
    let is_text = |field: &Field| matches!(field, Field::VendorName | Field::ProductName | Field::OrderCode);
    let lacks = if missing.iter().all(is_text) { "has no" } else { "has no value for" };
    let message = say!("`{[DeviceInfo]}` {} {}", lacks, listing_or(&missing));
    let light = device.kind == DeviceKind::Node || missing == [Field::OrderCode];
    let finding = MISSING_DEVICE_INFO_KEY
        .at(Place::of(Part::DeviceInfo).field(first.clone()), message)
        .severity(if light { Severity::Note } else { Severity::Warning });
    let title = say!("write {}", listing(missing.iter().map(example_line)));
    let fix = add_default_keys(device, &missing);
    let finding = finding.help(title);
    findings.push(match fix {
        Some(fix) => finding.fix(fix),
        None => finding,
    });
}

/// The mandatory keys and whether each has a value.
fn stated_keys(info: &DeviceInfo) -> [(Field, bool); 14] {
    [
        (Field::VendorName, info.vendor_name.is_some()),
        (Field::VendorNumber, info.vendor_number.is_some()),
        (Field::ProductName, info.product_name.is_some()),
        (Field::ProductNumber, info.product_number.is_some()),
        (Field::RevisionNumber, info.revision_number.is_some()),
        (Field::OrderCode, info.order_code.is_some()),
        (Field::SimpleBootUpMaster, info.simple_boot_up_master.is_some()),
        (Field::SimpleBootUpSlave, info.simple_boot_up_slave.is_some()),
        (Field::Granularity, info.granularity.is_some()),
        (Field::DynamicChannelsSupported, info.dynamic_channels_supported.is_some()),
        (Field::GroupMessaging, info.group_messaging.is_some()),
        (Field::NrOfRxPdo, info.rpdo_count.is_some()),
        (Field::NrOfTxPdo, info.tpdo_count.is_some()),
        (Field::LssSupported, info.lss_supported.is_some()),
    ]
}

/// An example line for the help.
fn example_line(field: &Field) -> Argument {
    let value = match field {
        Field::VendorName | Field::ProductName | Field::OrderCode => "",
        Field::Granularity => "8",
        _ => "0",
    };
    Argument::setting(field, value)
}

/// The missing keys with their known or most common values; `None` if a name is missing.
fn add_default_keys(device: &Device, missing: &[Field]) -> Option<Fix> {
    let count = |range: std::ops::RangeInclusive<u16>| device.objects.range(range).count().to_string();
    let identity = |sub: u8| {
        let number = device.entry(0x1018, sub)?.default.as_ref()?.as_integer()?;
        Some(format!("0x{number:X}"))
    };
    missing.iter().try_fold(Fix::risky(say!("write {the keys}")), |fix, field| {
        let value = match field {
            Field::VendorName | Field::ProductName => return None,
            Field::VendorNumber => identity(1)?,
            Field::ProductNumber => identity(2)?,
            Field::RevisionNumber => identity(3)?,
            Field::OrderCode => String::new(),
            Field::Granularity => "8".to_owned(),
            Field::NrOfRxPdo => count(0x1400..=0x15FF),
            Field::NrOfTxPdo => count(0x1800..=0x19FF),
            _ => "0".to_owned(),
        };
        Some(fix.set(Place::of(Part::DeviceInfo).field(field.clone()), value))
    })
}

fn no_baud_rate(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let rates = &info.baud_rates;
    let is_known = |field: &Field| info.invalid_values.get(field).is_none();
    let unreadable = rates.iter().any(|(_, field, _)| !is_known(&field)) || !is_known(&Field::BaudRateAuto);
    if rates.supported().next().is_some() || rates.auto == Some(true) || unreadable {
        return;
    }
    let stated = rates.iter().find(|(.., supported)| supported.is_some());
    let (place, message, help) = match stated {
        Some((_, field, _)) => (
            Place::of(Part::DeviceInfo).field(field),
            say!("every `{BaudRate_x}` is 0"),
            say!("write 1 for each supported bit rate, such as `{BaudRate_125=1}`"),
        ),
        None => (
            Place::of(Part::DeviceInfo),
            say!("`{[DeviceInfo]}` has no `{BaudRate_x}`"),
            say!("add a key such as `{BaudRate_125=1}` for each supported bit rate"),
        ),
    };
    findings.push(NO_BAUD_RATE.at(place, message).help(help));
}

fn reserved_key(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let keys: Vec<&str> =
        info.extra.iter().map(|(key, _)| key).filter(|key| DeviceInfo::is_reserved(key)).collect();
    let Some(first) = keys.first() else { return };
    let message = say!("readers ignore {} of EDS version 3.0", listing(&keys));
    let place = |key: &str| Place::of(Part::DeviceInfo).field(Field::from_name(key));
    let fix = keys.iter().fold(Fix::safe(say!("remove {the keys}")), |fix, key| fix.remove(place(key)));
    findings.push(RESERVED_KEY.at(place(first), message).help(say!("remove {the keys}")).fix(fix));
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
        findings.push(finding.help("write the device's serial number in both places"));
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
