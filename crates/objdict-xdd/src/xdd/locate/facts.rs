//! Locates everything except objects.

use super::{attribute_of, text_of, value_of};
use crate::model::{BaudRates, Field, Part};
use crate::source::Span;
use crate::xdd::defaults::{channel_attribute, count_attribute, default_rate_field, supported_field};
use crate::xdd::fact::bit_rate;
use crate::xdd::layout::{DescriptionProfile, Layout, below};
use crate::xdd::schema::{
    self, BAUD_RATES, DEVICE_BODY, DEVICE_COMMISSIONING, GENERAL_FEATURES, MASTER_FEATURES,
};
use crate::xml::{Element, n};

/// The span of a field of a part, otherwise the tag of the part.
pub(super) fn locate(layout: &Layout<'_>, part: &Part, field: Option<&Field>) -> Option<Span> {
    if let Some(device) = layout.project() {
        return in_project(device, part, field);
    }
    let element = match part {
        Part::FileInfo => return file_info(layout, field),
        Part::DeviceInfo => return device_info(layout, field),
        part => element(layout, part)?,
    };
    let value = match (part, field) {
        (Part::List(list), _) => element.attribute(count_attribute(*list)).map(value_of),
        (Part::Commissioning, Some(field)) => commissioning(element, field),
        (Part::DummyUsage, Some(field)) => dummy(element, &field.name()),
        (Part::DynamicChannels, Some(field)) => channel(element, &field.name()),
        _ => None,
    };
    Some(value.unwrap_or(element.tag_span()))
}

/// The span in a project of the editors for CANopenNode from before XDD.
fn in_project(device: Element<'_>, part: &Part, field: Option<&Field>) -> Option<Span> {
    let element = match part {
        Part::List(_) => device.child(n::CANopenObjectList)?,
        Part::FileInfo => device.child("other")?.child("file")?,
        Part::DummyUsage => device.child("other")?.child(n::dummyUsage)?,
        Part::DeviceInfo if field.and_then(rate_of).is_some() => device.child("other")?.child(n::baudRate)?,
        Part::DeviceInfo | Part::Commissioning => device.child("other")?.child(n::DeviceIdentity)?,
        _ => return None,
    };
    let attribute = field.and_then(|field| attribute_of(element, DEVICE_BODY, field).map(value_of));
    Some(attribute.unwrap_or(element.tag_span()))
}

/// The element of a part.
fn element<'a>(layout: &Layout<'a>, part: &Part) -> Option<Element<'a>> {
    match part {
        Part::Commissioning => layout.in_network(&[n::NetworkManagement, n::deviceCommissioning]),
        Part::DummyUsage => layout.in_network(&[n::ApplicationLayers, n::dummyUsage]),
        Part::List(_) => layout.in_network(&[n::ApplicationLayers, n::CANopenObjectList]),
        Part::DynamicChannels => layout.in_network(&[n::ApplicationLayers, n::dynamicChannels]),
        Part::NetworkIdentity => layout.in_network(&[n::ApplicationLayers, n::identity]),
        Part::ModuleObjects => layout.in_network(&[n::ApplicationLayers, n::moduleManagement]),
        Part::Headers => layout.device.or(layout.network)?.header,
        Part::Identity => layout.in_device(&[n::DeviceIdentity]),
        Part::Manager => layout.in_device(&[n::DeviceManager]),
        Part::Functions => layout.in_device(&[n::DeviceFunction]),
        Part::Application => layout.in_device(&[n::ApplicationProcess]),
        _ => None,
    }
}

/// The characteristics with content that CiA 311 does not support, by category.
pub(super) fn carried(layout: &Layout<'_>, name: &str) -> Option<Span> {
    let capabilities = layout.in_device(&[n::DeviceFunction, n::capabilities])?;
    let is_it = |list: &Element<'_>| {
        let label = below(*list, &[n::category, n::label]);
        label.is_some_and(|label| label.text().trim_ascii().eq_ignore_ascii_case(name))
    };
    capabilities.children_named(n::characteristicsList).find(is_it).map(Element::tag_span)
}

fn file_info(layout: &Layout<'_>, field: Option<&Field>) -> Option<Span> {
    let DescriptionProfile { body, .. } = layout.device.or(layout.network)?;
    let found = match field? {
        Field::Description => {
            layout.in_device(&[n::DeviceIdentity, n::productText, n::description]).map(text_of)
        }
        Field::FileRevision => body.attribute(n::fileVersion).map(value_of),
        field => attribute_of(body, DEVICE_BODY, field).map(value_of),
    };
    found.or(Some(body.tag_span()))
}

fn device_info(layout: &Layout<'_>, field: Option<&Field>) -> Option<Span> {
    let identity = layout.in_device(&[n::DeviceIdentity]);
    let whole = || {
        let element = identity.or(layout.in_network(&[n::NetworkManagement]));
        let body = layout.device.or(layout.network).map(|profile| profile.body);
        element.or(body).map(Element::tag_span)
    };
    let Some(field) = field else { return whole() };
    let found = match (schema::identity_element(field), rate_of(field)) {
        (Some(element), _) => identity.and_then(|identity| identity.child(element.name)).map(text_of),
        (None, Some(rate)) => bit_rates(layout, rate),
        (None, None) => feature(layout, field),
    };
    found.or_else(whole)
}

/// An attribute of the features or of `ApplicationLayers`; otherwise the features.
fn feature(layout: &Layout<'_>, field: &Field) -> Option<Span> {
    let general = layout.in_network(&[n::NetworkManagement, n::CANopenGeneralFeatures]);
    let master = layout.in_network(&[n::NetworkManagement, n::CANopenMasterFeatures]);
    let layers = layout.in_network(&[n::ApplicationLayers]);
    let known = GENERAL_FEATURES.attribute_of(field).or_else(|| MASTER_FEATURES.attribute_of(field));
    let attribute = [general, master, layers].into_iter().flatten().find_map(|element| match known {
        Some(known) => element.attribute(known.name),
        None => element.attribute(&*field.name()),
    });
    let part = if *field == Field::SimpleBootUpMaster { master } else { general };
    let is_feature = !matches!(field, Field::Named(_) | Field::RevisionNumber | Field::CompactPdo);
    attribute.map(value_of).or(part.filter(|_| is_feature).map(Element::tag_span))
}

/// The meaning of a field of a bit rate.
#[derive(Clone, Copy)]
enum RateField {
    Kbit(u16),
    Auto,
    Default,
    /// A bit rate that does not exist.
    Wrong,
}

fn rate_of(field: &Field) -> Option<RateField> {
    if let Some((kbit, ..)) = BaudRates::default().iter().find(|(_, known, _)| known == field) {
        return Some(RateField::Kbit(kbit));
    }
    match field {
        Field::BaudRateAuto => Some(RateField::Auto),
        field if *field == default_rate_field() => Some(RateField::Default),
        field if *field == supported_field() => Some(RateField::Wrong),
        _ => None,
    }
}

/// The element of a bit rate, otherwise the element that contains all of them.
fn bit_rates(layout: &Layout<'_>, rate: RateField) -> Option<Span> {
    let list = layout.in_network(&[n::TransportLayers, n::PhysicalLayer, n::baudRate])?;
    let mut values =
        list.children_named(n::supportedBaudRate).filter_map(|element| element.attribute(n::value));
    let found = match rate {
        RateField::Default => list.attribute(n::defaultValue),
        RateField::Kbit(kbit) => values.find(|value| bit_rate(value.value().trim_ascii()) == Some(kbit)),
        RateField::Auto => values.find(|value| value.value().to_ascii_lowercase().contains("auto")),
        RateField::Wrong => values.find(|value| {
            let text = value.value();
            let kbit = bit_rate(text.trim_ascii());
            let is_known = kbit.is_some() && BAUD_RATES.iter().any(|known| bit_rate(known) == kbit);
            !is_known && !text.to_ascii_lowercase().contains("auto")
        }),
    };
    Some(found.map_or(list.tag_span(), value_of))
}

fn commissioning(node: Element<'_>, field: &Field) -> Option<Span> {
    let found = attribute_of(node, DEVICE_COMMISSIONING, field);
    // CANopenEditor writes `NodeID`
    let other = || node.attribute(n::NodeID).filter(|_| *field == Field::NodeId);
    found.or_else(other).map(value_of)
}

/// The entry of `Dummy0005`.
fn dummy(usage: Element<'_>, name: &str) -> Option<Span> {
    let entries = usage.children_named(n::dummy).filter_map(|dummy| dummy.attribute(n::entry));
    let mut entries = entries.filter(|entry| {
        let text = entry.value();
        text.split('=').next().is_some_and(|key| key.trim_ascii().eq_ignore_ascii_case(name))
    });
    entries.next().map(value_of)
}

/// An attribute of a channel: `Type2` is the data type of the second channel.
fn channel(channels: Element<'_>, name: &str) -> Option<Span> {
    let digits = name.bytes().rev().take_while(u8::is_ascii_digit).count();
    let (word, number) = name.split_at(name.len() - digits);
    let position = number.parse::<usize>().ok()?.checked_sub(1)?;
    let channel = channels.children_named(n::dynamicChannel).nth(position)?;
    Some(channel.attribute(channel_attribute(word)).map_or(channel.tag_span(), value_of))
}
