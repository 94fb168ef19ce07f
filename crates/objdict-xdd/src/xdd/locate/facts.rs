//! Places of everything but objects.

use super::{text_of, value_of};
use crate::model::{Field, ObjectList, Part};
use crate::source::Span;
use crate::xdd::layout::{Layout, Profile, below};
use crate::xdd::read::{bit_rate, count_attribute};
use crate::xml::Element;

/// The span of a field of a part, else the tag of the part.
pub(super) fn locate(layout: &Layout<'_>, part: &Part, field: Option<&Field>) -> Option<Span> {
    let tag = |element: Option<Element<'_>>| element.map(Element::tag_span);
    match part {
        Part::FileInfo => file_info(layout, field),
        Part::DeviceInfo => device_info(layout, field),
        Part::Commissioning => {
            let node = layout.in_network(&["NetworkManagement", "deviceCommissioning"])?;
            let value = field.and_then(|field| commissioning(node, field));
            Some(value.unwrap_or(node.tag_span()))
        }
        Part::DummyUsage => {
            let usage = layout.in_network(&["ApplicationLayers", "dummyUsage"])?;
            let value = field.and_then(|field| dummy(usage, &field.name()));
            Some(value.unwrap_or(usage.tag_span()))
        }
        Part::List(list) => {
            let element = layout.in_network(&["ApplicationLayers", "CANopenObjectList"])?;
            let count = element.attribute(count_attribute(*list)).map(value_of);
            let item = || match field? {
                Field::Item(number) => {
                    let of_list = |object: &Element<'_>| {
                        let index = super::super::read::EntryAttributes::of(*object).index();
                        index.and_then(ObjectList::of) == Some(*list)
                    };
                    let position = usize::try_from(*number).ok()?.checked_sub(1)?;
                    layout.objects().filter(of_list).nth(position).map(Element::tag_span)
                }
                _ => None,
            };
            item().or(count).or(Some(element.tag_span()))
        }
        Part::DynamicChannels => {
            let channels = layout.in_network(&["ApplicationLayers", "dynamicChannels"])?;
            let value = field.and_then(|field| channel(channels, &field.name()));
            Some(value.unwrap_or(channels.tag_span()))
        }
        Part::Headers => {
            let profile = layout.device.or(layout.network)?;
            tag(profile.header)
        }
        Part::Identity => tag(layout.in_device(&["DeviceIdentity"])),
        Part::NetworkIdentity => tag(layout.in_network(&["ApplicationLayers", "identity"])),
        Part::Manager => tag(layout.in_device(&["DeviceManager"])),
        Part::Functions => tag(layout.in_device(&["DeviceFunction"])),
        Part::Application => tag(layout.in_device(&["ApplicationProcess"])),
        Part::ModuleObjects => tag(layout.in_network(&["ApplicationLayers", "moduleManagement"])),
        _ => None,
    }
}

/// The characteristics that carry what CiA 311 has no place for, by their category.
pub(super) fn carried(layout: &Layout<'_>, name: &str) -> Option<Span> {
    let capabilities = layout.in_device(&["DeviceFunction", "capabilities"])?;
    let is_it = |list: &Element<'_>| {
        let label = below(*list, &["category", "label"]);
        label.is_some_and(|label| label.text().trim_ascii().eq_ignore_ascii_case(name))
    };
    capabilities.children_named("characteristicsList").find(is_it).map(Element::tag_span)
}

fn file_info(layout: &Layout<'_>, field: Option<&Field>) -> Option<Span> {
    let Profile { body, .. } = layout.device.or(layout.network)?;
    let name = match field? {
        Field::FileName => "fileName",
        Field::FileVersion | Field::FileRevision => "fileVersion",
        Field::CreationTime => "fileCreationTime",
        Field::CreationDate => "fileCreationDate",
        Field::CreatedBy => "fileCreator",
        Field::ModificationTime => "fileModificationTime",
        Field::ModificationDate => "fileModificationDate",
        Field::ModifiedBy => "fileModifiedBy",
        Field::Description => {
            let description = layout.in_device(&["DeviceIdentity", "productText", "description"]);
            return description.map(text_of).or(Some(body.tag_span()));
        }
        other => return Some(body.attribute(&other.name()).map_or(body.tag_span(), value_of)),
    };
    Some(body.attribute(name).map_or(body.tag_span(), value_of))
}

fn device_info(layout: &Layout<'_>, field: Option<&Field>) -> Option<Span> {
    let identity = layout.in_device(&["DeviceIdentity"]);
    let whole = || {
        let element = identity.or(layout.in_network(&["NetworkManagement"]));
        let body = layout.device.or(layout.network).map(|profile| profile.body);
        element.or(body).map(Element::tag_span)
    };
    let Some(field) = field else { return whole() };
    let in_identity = |name: &str| identity?.child(name).map(text_of);
    let found = match field {
        Field::VendorName => in_identity("vendorName"),
        Field::VendorNumber => in_identity("vendorID"),
        Field::ProductName => in_identity("productName"),
        Field::ProductNumber => in_identity("productID"),
        Field::OrderCode => in_identity("orderNumber"),
        _ => match rate_of(field) {
            Some(rate) => bit_rates(layout, rate),
            None => feature(layout, field),
        },
    };
    found.or_else(whole)
}

/// An attribute of the features or of `ApplicationLayers`; else the features.
fn feature(layout: &Layout<'_>, field: &Field) -> Option<Span> {
    let name = field.name();
    let (is_master, name) = match field {
        Field::SimpleBootUpMaster => (true, "bootUpMaster"),
        Field::SimpleBootUpSlave => (false, "bootUpSlave"),
        Field::Granularity => (false, "granularity"),
        Field::DynamicChannelsSupported => (false, "dynamicChannels"),
        Field::GroupMessaging => (false, "groupMessaging"),
        Field::NrOfRxPdo => (false, "nrOfRxPDO"),
        Field::NrOfTxPdo => (false, "nrOfTxPDO"),
        Field::LssSupported => (false, "layerSettingServiceSlave"),
        _ => (false, name.as_ref()),
    };
    let general = layout.in_network(&["NetworkManagement", "CANopenGeneralFeatures"]);
    let master = layout.in_network(&["NetworkManagement", "CANopenMasterFeatures"]);
    let layers = layout.in_network(&["ApplicationLayers"]);
    let attribute =
        [general, master, layers].into_iter().flatten().find_map(|element| element.attribute(name));
    let part = if is_master { master } else { general };
    let is_feature = !matches!(field, Field::Named(_) | Field::RevisionNumber | Field::CompactPdo);
    attribute.map(value_of).or(part.filter(|_| is_feature).map(Element::tag_span))
}

/// What a field says of a bit rate.
#[derive(Clone, Copy)]
enum Rate {
    Kbit(u16),
    Auto,
    Default,
    /// One that there is not.
    Wrong,
}

fn rate_of(field: &Field) -> Option<Rate> {
    Some(match field {
        Field::BaudRate10 => Rate::Kbit(10),
        Field::BaudRate20 => Rate::Kbit(20),
        Field::BaudRate50 => Rate::Kbit(50),
        Field::BaudRate125 => Rate::Kbit(125),
        Field::BaudRate250 => Rate::Kbit(250),
        Field::BaudRate500 => Rate::Kbit(500),
        Field::BaudRate800 => Rate::Kbit(800),
        Field::BaudRate1000 => Rate::Kbit(1000),
        Field::BaudRateAuto => Rate::Auto,
        Field::Named(name) if &**name == "defaultBaudRate" => Rate::Default,
        Field::Named(name) if &**name == "supportedBaudRate" => Rate::Wrong,
        _ => return None,
    })
}

/// The element of a bit rate, else that around all of them.
fn bit_rates(layout: &Layout<'_>, rate: Rate) -> Option<Span> {
    let list = layout.in_network(&["TransportLayers", "PhysicalLayer", "baudRate"])?;
    let mut values =
        list.children_named("supportedBaudRate").filter_map(|element| element.attribute("value"));
    let found = match rate {
        Rate::Default => list.attribute("defaultValue"),
        Rate::Kbit(kbit) => values.find(|value| bit_rate(value.value().trim_ascii()) == Some(kbit)),
        Rate::Auto => values.find(|value| value.value().to_ascii_lowercase().contains("auto")),
        Rate::Wrong => values.find(|value| {
            let text = value.value();
            let is_known = bit_rate(text.trim_ascii()).is_some_and(|kbit| KNOWN.contains(&kbit));
            !is_known && !text.to_ascii_lowercase().contains("auto")
        }),
    };
    Some(found.map_or(list.tag_span(), value_of))
}

/// The bit rates of CiA 311 in kbit/s.
const KNOWN: [u16; 9] = [10, 20, 50, 100, 125, 250, 500, 800, 1000];

fn commissioning(node: Element<'_>, field: &Field) -> Option<Span> {
    let name = field.name();
    let names: &[&str] = match field {
        Field::NodeId => &["nodeID", "NodeID"],
        Field::NodeName => &["nodeName"],
        Field::Baudrate => &["actualBaudRate"],
        Field::NetNumber => &["networkNumber"],
        Field::NetworkName => &["networkName"],
        Field::CanOpenManager => &["CANopenManager"],
        _ => &[&name],
    };
    names.iter().find_map(|name| node.attribute(name)).map(value_of)
}

/// The entry of `Dummy0005`.
fn dummy(usage: Element<'_>, name: &str) -> Option<Span> {
    let entries = usage.children_named("dummy").filter_map(|dummy| dummy.attribute("entry"));
    let mut entries = entries.filter(|entry| {
        let text = entry.value();
        text.split('=').next().is_some_and(|key| key.trim_ascii().eq_ignore_ascii_case(name))
    });
    entries.next().map(value_of)
}

/// An attribute of a channel: `Type2` is the data type of the second.
fn channel(channels: Element<'_>, name: &str) -> Option<Span> {
    let digits = name.bytes().rev().take_while(u8::is_ascii_digit).count();
    let (word, number) = name.split_at(name.len() - digits);
    let position = number.parse::<usize>().ok()?.checked_sub(1)?;
    let channel = channels.children_named("dynamicChannel").nth(position)?;
    let attribute = match word {
        "Type" => "dataType",
        "Dir" => "accessType",
        "Range" => "startIndex",
        "PPOffset" => "addressOffset",
        other => other,
    };
    Some(channel.attribute(attribute).map_or(channel.tag_span(), value_of))
}
