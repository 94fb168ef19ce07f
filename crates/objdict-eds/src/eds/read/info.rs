//! The sections about the file, the device and the node.

use super::EdsReader;
use super::items::Items;
use crate::diagnostic::{Fix, MAX_FIX_LINES, Severity};
use crate::eds::findings;
use crate::eds::item::Item;
use crate::ini;
use crate::literal;
use crate::model::{
    ClockTime, Commissioning, DataType, Date, DeviceInfo, DummyUsage, Extra, Field, FileInfo, InvalidValues,
    Reason,
};

const U8: (i64, u64) = (0, u8::MAX as u64);
const U16: (i64, u64) = (0, u16::MAX as u64);
const U32: (i64, u64) = (0, u32::MAX as u64);
/// The range of the mapping granularity in bits, and the number of PDOs of one direction (CiA 306-1 §4.5).
const GRANULARITY: (i64, u64) = (0, 64);
const PDO_COUNT: (i64, u64) = (0, 512);

impl EdsReader<'_> {
    pub(super) fn file_info(&mut self, section: &ini::Section) {
        let mut info = FileInfo::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|items, item| match item.field() {
            Some(Field::FileName) => info.file_name = Some(items.text(item).to_owned()),
            Some(Field::FileVersion) => info.file_version = items.integer(item, U8, &mut info.invalid_values),
            Some(Field::FileRevision) => {
                info.file_revision = items.integer(item, U8, &mut info.invalid_values);
            }
            Some(Field::EdsVersion) => info.eds_version = Some(items.text(item).to_owned()),
            Some(Field::Description) => info.description = Some(items.text(item).to_owned()),
            Some(Field::CreationTime) => {
                info.creation_time = clock_time(items, item, &mut info.invalid_values);
            }
            Some(Field::CreationDate) => info.creation_date = date(items, item, &mut info.invalid_values),
            Some(Field::CreatedBy) => info.created_by = Some(items.text(item).to_owned()),
            Some(Field::ModificationTime) => {
                info.modification_time = clock_time(items, item, &mut info.invalid_values);
            }
            Some(Field::ModificationDate) => {
                info.modification_date = date(items, item, &mut info.invalid_values);
            }
            Some(Field::ModifiedBy) => info.modified_by = Some(items.text(item).to_owned()),
            Some(Field::LastEds) => info.last_eds = Some(items.text(item).to_owned()),
            _ => items.unknown(item, &mut info.extra),
        });
        self.device.file_info = Some(info);
    }

    pub(super) fn device_info(&mut self, section: &ini::Section) {
        let mut info = DeviceInfo::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|items, item| device_info_item(&mut info, items, item));
        self.device.device_info = Some(info);
    }

    pub(super) fn dummy_usage(&mut self, section: &ini::Section) {
        let mut usage = DummyUsage::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|items, item| match dummy_type(item.name) {
            Some(data_type) => {
                if let Some(allowed) = items.boolean(item, &mut usage.invalid_values) {
                    usage.types.insert(data_type, allowed);
                }
            }
            None => items.unknown(item, &mut usage.extra),
        });
        self.device.dummy_usage = Some(usage);
    }

    pub(super) fn comments(&mut self, section: &ini::Section) {
        let mut extra = Extra::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        let lines = comment_lines(&mut items, &mut extra);
        self.device.comments = Some(lines);
        self.keep("Comments", &extra);
    }

    pub(super) fn commissioning(&mut self, section: &ini::Section) {
        let mut node = Commissioning::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|items, item| match item.field() {
            Some(Field::NodeId) => node.node_id = items.integer(item, U8, &mut node.invalid_values),
            Some(Field::NodeName) => node.node_name = Some(items.text(item).to_owned()),
            Some(Field::NodeRefd) => node.node_reference_designator = Some(items.text(item).to_owned()),
            Some(Field::Baudrate) => node.baud_rate = items.integer(item, U16, &mut node.invalid_values),
            Some(Field::NetNumber) => node.net_number = items.integer(item, U32, &mut node.invalid_values),
            Some(Field::NetworkName) => node.network_name = Some(items.text(item).to_owned()),
            Some(Field::NetRefd) => node.net_reference_designator = Some(items.text(item).to_owned()),
            Some(Field::CanOpenManager) => node.manager = items.boolean(item, &mut node.invalid_values),
            Some(Field::LssSerialNumber) => {
                node.lss_serial_number = items.integer(item, U32, &mut node.invalid_values);
            }
            _ => items.unknown(item, &mut node.extra),
        });
        self.device.commissioning = Some(node);
    }
}

fn device_info_item<'a>(info: &mut DeviceInfo, items: &mut Items<'a>, item: &Item<'a>) {
    let invalid_values = &mut info.invalid_values;
    let rates = &mut info.baud_rates;
    match item.field() {
        Some(Field::VendorName) => info.vendor_name = Some(items.text(item).to_owned()),
        Some(Field::VendorNumber) => info.vendor_number = items.integer(item, U32, invalid_values),
        Some(Field::ProductName) => info.product_name = Some(items.text(item).to_owned()),
        Some(Field::ProductNumber) => info.product_number = items.integer(item, U32, invalid_values),
        Some(Field::RevisionNumber) => info.revision_number = items.integer(item, U32, invalid_values),
        Some(Field::OrderCode) => info.order_code = Some(items.text(item).to_owned()),
        Some(Field::BaudRate10) => rates.kbit_10 = items.boolean(item, invalid_values),
        Some(Field::BaudRate20) => rates.kbit_20 = items.boolean(item, invalid_values),
        Some(Field::BaudRate50) => rates.kbit_50 = items.boolean(item, invalid_values),
        Some(Field::BaudRate125) => rates.kbit_125 = items.boolean(item, invalid_values),
        Some(Field::BaudRate250) => rates.kbit_250 = items.boolean(item, invalid_values),
        Some(Field::BaudRate500) => rates.kbit_500 = items.boolean(item, invalid_values),
        Some(Field::BaudRate800) => rates.kbit_800 = items.boolean(item, invalid_values),
        Some(Field::BaudRate1000) => rates.kbit_1000 = items.boolean(item, invalid_values),
        Some(Field::BaudRateAuto) => rates.auto = items.boolean(item, invalid_values),
        Some(Field::SimpleBootUpMaster) => info.simple_boot_up_master = items.boolean(item, invalid_values),
        Some(Field::SimpleBootUpSlave) => info.simple_boot_up_slave = items.boolean(item, invalid_values),
        Some(Field::Granularity) => info.granularity = items.integer(item, GRANULARITY, invalid_values),
        Some(Field::DynamicChannelsSupported) => {
            info.dynamic_channels_supported = items.integer(item, U8, invalid_values);
        }
        Some(Field::GroupMessaging) => info.group_messaging = items.boolean(item, invalid_values),
        Some(Field::NrOfRxPdo) => info.rpdo_count = items.integer(item, PDO_COUNT, invalid_values),
        Some(Field::NrOfTxPdo) => info.tpdo_count = items.integer(item, PDO_COUNT, invalid_values),
        Some(Field::LssSupported) => info.lss_supported = items.boolean(item, invalid_values),
        Some(Field::CompactPdo) => info.compact_pdo = items.integer(item, U8, invalid_values),
        Some(Field::CanOpenSafetySupported) => info.safety_supported = items.boolean(item, invalid_values),
        _ if DeviceInfo::is_reserved(item.name) => info.extra.push(item.name, item.value),
        _ => items.unknown(item, &mut info.extra),
    }
}

/// The data type of a key such as `Dummy0005`.
fn dummy_type(key: &str) -> Option<DataType> {
    let digits = key.get(..5).filter(|word| word.eq_ignore_ascii_case("Dummy")).map(|_| &key[5..])?;
    let digits = Some(digits).filter(|digits| digits.len() == 4)?;
    u16::from_str_radix(digits, 16).ok().map(DataType)
}

/// The lines of a comment section, by number.
pub(super) fn comment_lines(items: &mut Items<'_>, extra: &mut Extra) -> Vec<String> {
    let mut lines: Vec<(u32, Item<'_>)> = Vec::new();
    let mut count = None;
    items.each(|items, item| {
        let number =
            item.name.get(..4).filter(|word| word.eq_ignore_ascii_case("Line")).map(|_| &item.name[4..]);
        match (item.field(), number.and_then(|number| number.parse().ok())) {
            (Some(Field::Lines), _) => count = Some(*item),
            (_, Some(number)) => lines.push((number, *item)),
            _ => items.unknown(item, extra),
        }
    });
    super::lists::check_count(items, count, "Lines", lines.len());
    lines.sort_by_key(|(number, _)| *number);
    check_numbers(&lines, items);
    lines.into_iter().map(|(_, item)| item.value.to_owned()).collect()
}

/// Reports lines that are not numbered from 1 without gaps.
fn check_numbers(lines: &[(u32, Item<'_>)], items: &mut Items<'_>) {
    let numbered = || (1..).zip(lines).filter(|(expected, (number, _))| expected != number);
    let Some((expected, (_, item))) = numbered().next().filter(|_| lines.len() <= MAX_FIX_LINES) else {
        return;
    };
    let fix = numbered().fold(Fix::safe("number the lines 1, 2, 3 …"), |fix, (number, (_, item))| {
        fix.replace(item.name_at, format!("Line{number}"))
    });
    let finding = findings::list_numbering(item, &format!("Line{expected}"), fix);
    items.findings.push(finding.severity(Severity::Warning));
}

/// `mm-dd-yyyy`, or a different spelling of a date.
fn date(items: &mut Items<'_>, item: &Item<'_>, invalid_values: &mut InvalidValues) -> Option<Date> {
    let (date, is_clear) = or_invalid(item, literal::date(item.value), Reason::NotADate, invalid_values)?;
    spelling(items, item, date.to_string(), is_clear);
    Some(date)
}

/// `hh:mmAM`, or a different spelling of a time of day.
fn clock_time(
    items: &mut Items<'_>,
    item: &Item<'_>,
    invalid_values: &mut InvalidValues,
) -> Option<ClockTime> {
    let time = or_invalid(item, literal::clock_time(item.value), Reason::NotAClockTime, invalid_values)?;
    let meant = time.to_string();
    // the standard has no field for seconds
    let is_whole = literal::clock_time(&meant) == Some(time);
    spelling(items, item, meant, is_whole);
    Some(time)
}

/// Reports a date or time that is not spelled as the standard requires.
fn spelling(items: &mut Items<'_>, item: &Item<'_>, meant: String, is_certain: bool) {
    if item.value != meant {
        items.findings.push(findings::date_spelling(item, meant, is_certain));
    }
}

fn or_invalid<T>(
    item: &Item<'_>,
    value: Option<T>,
    reason: Reason,
    invalid_values: &mut InvalidValues,
) -> Option<T> {
    if value.is_none() && !item.value.is_empty() {
        invalid_values.push(item.to_field(), item.value, reason);
    }
    value
}
