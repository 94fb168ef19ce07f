use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, Severity, listing, listing_or, say};
use crate::model::{Device, DeviceInfo, DeviceKind, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-device-info-key", Warning, Device(check), fix Unsafe;
    summary: "`[DeviceInfo]` lacks mandatory keys",
    checks: "Whether vendor, product, order code, boot-up behaviour, granularity, dynamic channels, group messaging, PDO counts and LSS are given. Names may be empty, numbers may not. `BaudRate_x` of unsupported bit rates may be missing. The finding is a note in a DCF, which is for one known device, and if only the order code is missing. In real files, mostly the order code is missing, or the numbers of products that were never sold; nearly all files without granularity, boot-up or group messaging are DCFs written by a tool, so two of three findings are notes.",
    why: "A configuration tool looks up the description by its numbers and uses the other keys to enable its functions. A conformance test refuses the file.",
    example: "`[DeviceInfo]` without `NrOfRXPDO`",
    remedy: "Add the keys. Write 0 for unsupported features.",
    source: "CiA 306-1 §4.5",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let missing: Vec<Field> = stated(info)
        .into_iter()
        .filter(|(field, stated)| !stated && info.invalid_values.get(field).is_none())
        .map(|(field, _)| field)
        .collect();
    let Some(first) = missing.first() else { return };
    let message = say!("`{[DeviceInfo]}` has no {}", listing_or(&missing));
    let light = device.kind == DeviceKind::Node || missing == [Field::OrderCode];
    let finding = Diagnostic::new(&RULE.info, Place::of(Part::DeviceInfo).field(first.clone()), message)
        .severity(if light { Severity::Note } else { Severity::Warning });
    let title = say!("add {}", listing(missing.iter().map(example)));
    let fix = defaults(device, &missing);
    let finding = finding.help(title);
    findings.push(match fix {
        Some(fix) => finding.fix(fix),
        None => finding,
    });
}

/// The mandatory keys and whether each has a value.
fn stated(info: &DeviceInfo) -> [(Field, bool); 14] {
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
fn example(field: &Field) -> Argument {
    let value = match field {
        Field::VendorName | Field::ProductName | Field::OrderCode => "",
        Field::Granularity => "8",
        _ => "0",
    };
    Argument::setting(field, value)
}

/// The missing keys with their known or most common values; `None` if a name is missing.
fn defaults(device: &Device, missing: &[Field]) -> Option<Fix> {
    let count = |range: std::ops::RangeInclusive<u16>| device.objects.range(range).count().to_string();
    let identity = |sub: u8| {
        let number = device.entry(0x1018, sub)?.default.as_ref()?.as_integer()?;
        Some(format!("0x{number:X}"))
    };
    missing.iter().try_fold(Fix::risky(say!("add {the keys}")), |fix, field| {
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
