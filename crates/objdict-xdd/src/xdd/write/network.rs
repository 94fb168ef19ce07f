//! The communication network profile but for its objects.

use super::Writer;
use super::attributes::{Attributes, misfit};
use crate::model::{
    Commissioning, DefaultBaudRate, DeviceInfo, DummyUsage, DynamicChannels, Field, Misfits, NetworkIdentity,
    Segment,
};
use crate::xdd::defaults;
use crate::xdd::markup::Markup;
use crate::xdd::read::{DIRECTIONS, default_rate_field, hex as hex_number, range_length, supported_field};
use crate::xdd::shape::{Identity, Shape};
use crate::xdd::version::XddVersion;

/// The data types that may stand in `dummyUsage`.
const DUMMIES: std::ops::RangeInclusive<u16> = 1..=7;

impl Writer<'_> {
    pub(super) fn network_body(&self, out: &mut Markup) {
        let unknown = DeviceInfo::default();
        let info = self.device.device_info.as_ref().unwrap_or(&unknown);
        self.application_layers(info, out);
        transport_layers(info, out);
        self.network_management(info, out);
    }

    fn application_layers(&self, info: &DeviceInfo, out: &mut Markup) {
        out.open("ApplicationLayers");
        if let Some(class) = &info.conformance_class {
            out.attribute("conformanceClass", class);
        }
        if !info.communication_entities.is_empty() {
            out.attribute("communicationEntityType", &info.communication_entities.join(" "));
        }
        if let Some(identity) = &self.device.network_identity {
            network_identity(identity, out);
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
            Shape::write(&**modules, "moduleManagement", out);
        }
        out.close();
    }

    fn network_management(&self, info: &DeviceInfo, out: &mut Markup) {
        let mut general = general_features(info);
        let master = master_features(info);
        let node = self.device.commissioning.as_ref();
        if general.is_empty() && master.is_empty() && node.is_none() {
            return;
        }
        out.open("NetworkManagement");
        out.open("CANopenGeneralFeatures");
        general.demand("granularity", defaults::NUMBER);
        general.write(out);
        out.close();
        if !master.is_empty() {
            out.open("CANopenMasterFeatures");
            master.write(out);
            out.close();
        }
        if let Some(node) = node {
            commissioning(node, out);
        }
        out.close();
    }
}

fn network_identity(identity: &NetworkIdentity, out: &mut Markup) {
    let identity = Identity {
        vendor_id: identity.vendor_id.clone(),
        product_id: identity.product_id.clone(),
        rest: identity.identity.clone(),
        ..Identity::default()
    };
    identity.write("identity", out);
}

fn dummy_usage(usage: &DummyUsage, out: &mut Markup) {
    out.open_unless_empty("dummyUsage");
    let types = usage.types.iter().filter(|(data_type, _)| DUMMIES.contains(&data_type.0));
    let types = types.map(|(data_type, allowed)| format!("Dummy{:04X}={}", data_type.0, u8::from(*allowed)));
    let misfits = usage.misfits.iter().map(|misfit| format!("{}={}", misfit.field, misfit.text));
    for entry in types.chain(misfits) {
        out.open("dummy");
        out.attribute("entry", &entry);
        out.close();
    }
    out.close();
}

fn dynamic_channels(channels: &DynamicChannels, out: &mut Markup) {
    out.open_unless_empty("dynamicChannels");
    for (number, segment) in (1..).zip(&channels.segments) {
        out.open("dynamicChannel");
        dynamic_channel(number, segment, &channels.misfits).write(out);
        out.close();
    }
    out.close();
}

fn dynamic_channel<'a>(number: usize, segment: &Segment, misfits: &'a Misfits) -> Attributes<'a> {
    let mut attributes = Attributes::of(misfits);
    let field = |word: &str| Field::Named(format!("{word}{number}").into());
    let mut put = |name: &'static str, word: &str, text: Option<String>| {
        attributes.text(name, &field(word), text);
    };
    let hex = |index: u16| format!("{index:04X}");
    let word =
        |eds: &str| DIRECTIONS.iter().find(|(_, known)| *known == eds).map_or(eds, |(xdd, _)| xdd).to_owned();
    put("dataType", "Type", segment.data_type.map(|data_type| hex(data_type.0)));
    put("accessType", "Dir", segment.direction.as_deref().map(word));
    put("startIndex", "startIndex", segment.range.map(|(first, _)| hex(first)));
    put("endIndex", "endIndex", segment.range.map(|(_, last)| hex(last)));
    let number = segment.max_number.or_else(|| range_length(segment.range));
    put("maxNumber", "maxNumber", number.map(|number| number.to_string()));
    put("addressOffset", "PPOffset", segment.offset.as_deref().map(address_offset));
    put("bitAlignment", "bitAlignment", segment.bit_alignment.map(|bits| bits.to_string()));
    attributes
}

/// The offset of a segment as pairs of hex digits, where it is a number: an EDS writes `0x100` or `256`.
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

fn transport_layers(info: &DeviceInfo, out: &mut Markup) {
    let rates = &info.baud_rates;
    let supported = rates.iter().filter(|(.., supported)| *supported == Some(true)).map(|(rate, ..)| rate);
    let mut supported: Vec<u16> = supported.chain((rates.kbit_100 == Some(true)).then_some(100)).collect();
    supported.sort_unstable();
    let mut words: Vec<String> = supported.into_iter().map(bit_rate).collect();
    words.extend((rates.auto == Some(true)).then(|| AUTO.to_owned()));
    let field = supported_field();
    let misfits = info.misfits.iter().filter(|misfit| misfit.field == field);
    words.extend(misfits.map(|misfit| misfit.text.to_string()));
    if words.is_empty() {
        words.push(bit_rate(defaults::BIT_RATE));
    }
    out.open("TransportLayers");
    out.open("PhysicalLayer");
    out.open("baudRate");
    let mut attributes = Attributes::default();
    let default = info.default_baud_rate.map(|rate| match rate {
        DefaultBaudRate::Kbit(kbit) => bit_rate(kbit),
        DefaultBaudRate::Auto => AUTO.to_owned(),
    });
    attributes.put("defaultValue", default.or_else(|| misfit(&info.misfits, &default_rate_field())));
    attributes.write(out);
    for word in words {
        out.open("supportedBaudRate");
        out.attribute("value", &word);
        out.close();
    }
    for _ in 0..3 {
        out.close();
    }
}

/// What CiA 311 calls the detection of the bit rate.
const AUTO: &str = "auto-baudRate";

fn bit_rate(kbit: u16) -> String {
    format!("{kbit} Kbps")
}

fn general_features(info: &DeviceInfo) -> Attributes<'_> {
    let mut attributes = Attributes::of(&info.misfits);
    attributes.flag("groupMessaging", &Field::GroupMessaging, info.group_messaging);
    attributes.number("dynamicChannels", &Field::DynamicChannelsSupported, info.dynamic_channels_supported);
    attributes.flag("selfStartingDevice", &Field::Named("selfStartingDevice".into()), info.self_starting);
    attributes.flag("SDORequestingDevice", &Field::Named("SDORequestingDevice".into()), info.sdo_requesting);
    attributes.number("granularity", &Field::Granularity, info.granularity);
    attributes.number("nrOfRxPDO", &Field::NrOfRxPdo, info.rpdo_count);
    attributes.number("nrOfTxPDO", &Field::NrOfTxPdo, info.tpdo_count);
    attributes.flag("bootUpSlave", &Field::SimpleBootUpSlave, info.simple_boot_up_slave);
    attributes.flag("layerSettingServiceSlave", &Field::LssSupported, info.lss_supported);
    attributes
}

fn master_features(info: &DeviceInfo) -> Attributes<'_> {
    let mut attributes = Attributes::of(&info.misfits);
    let mut named = |name: &'static str, flag| attributes.flag(name, &Field::Named(name.into()), flag);
    named("flyingMaster", info.flying_master);
    named("SDOManager", info.sdo_manager);
    named("configurationManager", info.configuration_manager);
    named("layerSettingServiceMaster", info.lss_master);
    attributes.flag("bootUpMaster", &Field::SimpleBootUpMaster, info.simple_boot_up_master);
    attributes
}

/// All six attributes, which the standard demands.
fn commissioning(node: &Commissioning, out: &mut Markup) {
    let text = |text: &Option<String>| text.clone().unwrap_or_else(|| defaults::NAME.to_owned());
    let or = |text: Option<String>, field: Field, nothing: &str| {
        Some(text.or_else(|| misfit(&node.misfits, &field)).unwrap_or_else(|| nothing.to_owned()))
    };
    let mut attributes = Attributes::default();
    attributes.put("nodeID", or(node.node_id.map(|id| id.to_string()), Field::NodeId, defaults::NUMBER));
    attributes.put("nodeName", Some(text(&node.node_name)));
    attributes.put("actualBaudRate", or(node.baud_rate.map(bit_rate), Field::Baudrate, ""));
    attributes.put(
        "networkNumber",
        or(node.net_number.map(|id| id.to_string()), Field::NetNumber, defaults::NUMBER),
    );
    attributes.put("networkName", Some(text(&node.network_name)));
    attributes.put(
        "CANopenManager",
        or(node.manager.map(|is| is.to_string()), Field::CanOpenManager, defaults::FLAG),
    );
    out.open("deviceCommissioning");
    attributes.write(out);
    out.close();
}
