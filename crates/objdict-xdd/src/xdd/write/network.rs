//! The communication network profile without its objects.

use super::Writer;
use crate::model::{DefaultBaudRate, DeviceInfo, DummyUsage, DynamicChannels, InvalidValues, Segment};
use crate::xdd::defaults::{
    self, DIRECTIONS, channel_field, default_rate_field, range_length, supported_field,
};
use crate::xdd::fact::{self, hex as hex_number};
use crate::xdd::schema::SchemaElement;
use crate::xdd::schema::network::{
    APPLICATION_LAYERS, BAUD_RATE, DEVICE_COMMISSIONING, DUMMY, DUMMY_USAGE, DYNAMIC_CHANNEL,
    DYNAMIC_CHANNELS, GENERAL_FEATURES, IDENTITY, MASTER_FEATURES, MODULE_MANAGEMENT, NETWORK_MANAGEMENT,
    PHYSICAL_LAYER, SUPPORTED_BAUD_RATE, TRANSPORT_LAYERS,
};
use crate::xdd::shape::{self, IdentityContent, facts};
use crate::xdd::version::XddVersion;
use crate::xdd::xdd_writer::XddWriter;
use crate::xml::{Name, n};

/// The data types allowed in `dummyUsage`.
const DUMMIES: std::ops::RangeInclusive<u16> = 1..=7;

impl Writer<'_> {
    pub(super) fn network_body(&self, out: &mut XddWriter) {
        let unknown = DeviceInfo::default();
        let info = self.device.device_info.as_ref().unwrap_or(&unknown);
        self.application_layers(info, out);
        transport_layers(info, out);
        self.network_management(info, out);
    }

    fn application_layers(&self, info: &DeviceInfo, out: &mut XddWriter) {
        out.open(&APPLICATION_LAYERS);
        put(&facts::texts(info, &APPLICATION_LAYERS, false), out);
        if let Some(identity) = &self.device.network_identity {
            let identity = IdentityContent {
                vendor_id: identity.vendor_id.clone(),
                product_id: identity.product_id.clone(),
                rest: identity.identity.clone(),
                ..IdentityContent::default()
            };
            shape::write(&identity, &IDENTITY, out);
        }
        self.object_list(out);
        if let Some(usage) = &self.device.dummy_usage {
            dummy_usage(usage, out);
        }
        if let Some(channels) = &self.device.dynamic_channels {
            dynamic_channels(channels, out);
        }
        if let Some(modules) =
            self.device.module_objects.as_ref().filter(|_| out.version() > XddVersion::V1_0)
        {
            shape::write(&**modules, &MODULE_MANAGEMENT, out);
        }
        out.close();
    }

    fn network_management(&self, info: &DeviceInfo, out: &mut XddWriter) {
        let mut general = facts::texts(info, &GENERAL_FEATURES, false);
        let master = facts::texts(info, &MASTER_FEATURES, false);
        let node = self.device.commissioning.as_ref();
        if general.is_empty() && master.is_empty() && node.is_none() {
            return;
        }
        if !general.iter().any(|(name, _)| *name == n::granularity) {
            general.insert(0, (n::granularity, defaults::NUMBER.to_owned()));
        }
        let mut node = node.map(|node| facts::texts(node, &DEVICE_COMMISSIONING, true));
        if out.version() == XddVersion::V1_0 {
            node.iter_mut().flatten().for_each(without_unit);
        }
        out.open(&NETWORK_MANAGEMENT);
        let elements: [(&'static SchemaElement, _); 3] = [
            (&GENERAL_FEATURES, general),
            (&MASTER_FEATURES, master),
            (&DEVICE_COMMISSIONING, node.unwrap_or_default()),
        ];
        for (element, attributes) in elements.into_iter().filter(|(_, attributes)| !attributes.is_empty()) {
            out.open(element);
            put(&attributes, out);
            out.close();
        }
        out.close();
    }
}

/// Removes the unit of the bit rate, because CANopenEditor requires a plain number in version 1.0.
fn without_unit((name, text): &mut (Name, String)) {
    if *name == n::actualBaudRate {
        let kbit = fact::bit_rate(text).unwrap_or_default();
        *text = kbit.to_string();
    }
}

fn put(attributes: &[(Name, String)], out: &mut XddWriter) {
    attributes.iter().for_each(|(name, text)| out.attribute(*name, text));
}

fn dummy_usage(usage: &DummyUsage, out: &mut XddWriter) {
    out.open_unless_empty(&DUMMY_USAGE);
    let types = usage.types.iter().filter(|(data_type, _)| DUMMIES.contains(&data_type.0));
    let types = types.map(|(data_type, allowed)| format!("Dummy{:04X}={}", data_type.0, u8::from(*allowed)));
    let invalid_values =
        usage.invalid_values.iter().map(|invalid| format!("{}={}", invalid.field, invalid.text));
    for entry in types.chain(invalid_values) {
        out.empty(&DUMMY, &[(n::entry, &entry)]);
    }
    out.close();
}

fn dynamic_channels(channels: &DynamicChannels, out: &mut XddWriter) {
    out.open_unless_empty(&DYNAMIC_CHANNELS);
    for (number, segment) in (1..).zip(&channels.segments) {
        out.open(&DYNAMIC_CHANNEL);
        dynamic_channel(number, segment, &channels.invalid_values, out);
        out.close();
    }
    out.close();
}

fn dynamic_channel(number: usize, segment: &Segment, invalid_values: &InvalidValues, out: &mut XddWriter) {
    let hex = |index: u16| format!("{index:04X}");
    let word = |eds: &str| {
        DIRECTIONS
            .iter()
            .find(|(_, known)| known.eq_ignore_ascii_case(eds))
            .map_or(eds, |(xdd, _)| xdd)
            .to_owned()
    };
    let length = segment.max_number.or_else(|| range_length(segment.range));
    for (name, text) in [
        (n::dataType, segment.data_type.map(|data_type| hex(data_type.0))),
        (n::accessType, segment.direction.as_deref().map(word)),
        (n::startIndex, segment.range.map(|(first, _)| hex(first))),
        (n::endIndex, segment.range.map(|(_, last)| hex(last))),
        (n::maxNumber, length.map(|number| number.to_string())),
        (n::addressOffset, segment.offset.as_deref().map(address_offset)),
        (n::bitAlignment, segment.bit_alignment.map(|bits| bits.to_string())),
    ] {
        let invalid = || Some(invalid_values.get(&channel_field(name, number))?.text.to_string());
        if let Some(text) = text.or_else(invalid) {
            out.attribute(name, &text);
        }
    }
}

/// The offset of a segment as pairs of hex digits, if it is a number: an EDS writes `0x100` or `256`.
fn address_offset(text: &str) -> String {
    let number = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) if digits.len().is_multiple_of(2) && hex_number(digits, 8).is_some() => {
            return digits.to_owned();
        }
        Some(digits) => hex_number(digits, 8),
        None => text.parse::<u32>().ok(),
    };
    match number.map(|number| format!("{number:X}")) {
        Some(digits) if digits.len().is_multiple_of(2) => digits,
        Some(digits) => format!("0{digits}"),
        None => text.to_owned(),
    }
}

fn transport_layers(info: &DeviceInfo, out: &mut XddWriter) {
    let rates = &info.baud_rates;
    let supported = rates.iter().filter(|(.., supported)| *supported == Some(true)).map(|(rate, ..)| rate);
    let mut supported: Vec<u16> = supported.chain((rates.kbit_100 == Some(true)).then_some(100)).collect();
    supported.sort_unstable();
    let mut words: Vec<String> = supported.into_iter().map(bit_rate).collect();
    words.extend((rates.auto == Some(true)).then(|| AUTO.to_owned()));
    let field = supported_field();
    let invalid_values = info.invalid_values.iter().filter(|invalid| invalid.field == field);
    words.extend(invalid_values.map(|invalid| invalid.text.to_string()));
    out.open(&TRANSPORT_LAYERS);
    out.open(&PHYSICAL_LAYER);
    out.open(&BAUD_RATE);
    let default = info.default_baud_rate.map(|rate| match rate {
        DefaultBaudRate::Kbit(kbit) => bit_rate(kbit),
        DefaultBaudRate::Auto => AUTO.to_owned(),
    });
    let invalid = || Some(info.invalid_values.get(&default_rate_field())?.text.to_string());
    if let Some(default) = default.or_else(invalid) {
        out.attribute(n::defaultValue, &default);
    }
    let supported = |word: &str, out: &mut XddWriter| out.empty(&SUPPORTED_BAUD_RATE, &[(n::value, word)]);
    words.iter().for_each(|word| supported(word, out));
    if out.count_of(n::supportedBaudRate) == 0 {
        // twice, as no other tool writes it
        [defaults::BIT_RATE; 2].iter().for_each(|word| supported(word, out));
    }
    for _ in 0..3 {
        out.close();
    }
}

/// The term of CiA 311 for automatic bit rate detection.
const AUTO: &str = "auto-baudRate";

fn bit_rate(kbit: u16) -> String {
    format!("{kbit} Kbps")
}
