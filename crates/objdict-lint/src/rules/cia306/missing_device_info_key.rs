use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, Severity, listing, say};
use crate::model::{Device, DeviceInfo, DeviceKind, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/missing-device-info-key", Warning, Device(check), fix Unsafe;
    summary: "`[DeviceInfo]` does not say all that it has to",
    checks: "Whether vendor, product, order code, boot-up behaviour, granularity, dynamic channels, group messaging, the numbers of PDOs and LSS are stated. Names may be empty, numbers may not. `BaudRate_x` of rates that the device does not support may be left out. In a DCF, which is for one known device, and where only the order code is missing, it is a note. In real files it is mostly the order code, and numbers of products that were never sold; the files that state nothing of granularity, boot-up or group messaging are nearly all DCFs that a tool wrote, so two in three findings are notes.",
    why: "A configuration tool finds the description of a device by its numbers, and asks the other keys what it may offer. A conformance test refuses the file.",
    example: "`[DeviceInfo]` without `NrOfRXPDO`",
    remedy: "Add the keys; what the device does not have is 0.",
    source: "CiA 306-1 §4.5",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let missing: Vec<Field> = stated(info)
        .into_iter()
        .filter(|(field, stated)| !stated && info.misfits.get(field).is_none())
        .map(|(field, _)| field)
        .collect();
    let Some(first) = missing.first() else { return };
    let message = say!("`{[DeviceInfo]}` gives no value for {}", listing(&missing));
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

/// What is demanded, with whether it is there.
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

/// A line that the author can start from.
fn example(field: &Field) -> Argument {
    let value = match field {
        Field::VendorName | Field::ProductName | Field::OrderCode => "",
        Field::Granularity => "8",
        _ => "0",
    };
    Argument::setting(field, value)
}

/// The missing keys with what can be known of them, or what most devices have; `None` where a name is missing.
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
