//! Places of everything but objects.

use super::{text_of, value_of};
use crate::model::{Field, ObjectList, Part};
use crate::source::Span;
use crate::xdd::fact::bit_rate;
use crate::xdd::layout::{Layout, Profile, below};
use crate::xdd::read::{EntryAttributes, channel_attribute, count_attribute};
use crate::xdd::schema::{self, DEVICE_BODY, DEVICE_COMMISSIONING, GENERAL_FEATURES, MASTER_FEATURES};
use crate::xml::{Attribute, Element, n};

/// The span of a field of a part, else the tag of the part.
pub(super) fn locate(layout: &Layout<'_>, part: &Part, field: Option<&Field>) -> Option<Span> {
    let tag = |element: Option<Element<'_>>| element.map(Element::tag_span);
    match part {
        Part::FileInfo => file_info(layout, field),
        Part::DeviceInfo => device_info(layout, field),
        Part::Commissioning => {
            let node = layout.in_network(&[n::NetworkManagement, n::deviceCommissioning])?;
            let value = field.and_then(|field| commissioning(node, field));
            Some(value.unwrap_or(node.tag_span()))
        }
        Part::DummyUsage => {
            let usage = layout.in_network(&[n::ApplicationLayers, n::dummyUsage])?;
            let value = field.and_then(|field| dummy(usage, &field.name()));
            Some(value.unwrap_or(usage.tag_span()))
        }
        Part::List(list) => {
            let element = layout.in_network(&[n::ApplicationLayers, n::CANopenObjectList])?;
            let count = element.attribute(count_attribute(*list)).map(value_of);
            let item = || match field? {
                Field::Item(number) => {
                    let of_list = |object: &Element<'_>| {
                        let index = EntryAttributes::of(*object).index();
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
            let channels = layout.in_network(&[n::ApplicationLayers, n::dynamicChannels])?;
            let value = field.and_then(|field| channel(channels, &field.name()));
            Some(value.unwrap_or(channels.tag_span()))
        }
        Part::Headers => {
            let profile = layout.device.or(layout.network)?;
            tag(profile.header)
        }
        Part::Identity => tag(layout.in_device(&[n::DeviceIdentity])),
        Part::NetworkIdentity => tag(layout.in_network(&[n::ApplicationLayers, n::identity])),
        Part::Manager => tag(layout.in_device(&[n::DeviceManager])),
        Part::Functions => tag(layout.in_device(&[n::DeviceFunction])),
        Part::Application => tag(layout.in_device(&[n::ApplicationProcess])),
        Part::ModuleObjects => tag(layout.in_network(&[n::ApplicationLayers, n::moduleManagement])),
        _ => None,
    }
}

/// The characteristics that carry what CiA 311 has no place for, by their category.
pub(super) fn carried(layout: &Layout<'_>, name: &str) -> Option<Span> {
    let capabilities = layout.in_device(&[n::DeviceFunction, n::capabilities])?;
    let is_it = |list: &Element<'_>| {
        let label = below(*list, &[n::category, n::label]);
        label.is_some_and(|label| label.text().trim_ascii().eq_ignore_ascii_case(name))
    };
    capabilities.children_named(n::characteristicsList).find(is_it).map(Element::tag_span)
}

/// The attribute that a field is by the table, else the one that is called like the field.
fn named<'a>(element: Element<'a>, schema: &schema::Element, field: &Field) -> Option<Attribute<'a>> {
    match schema.attribute_of(field) {
        Some(known) => element.attribute(known.name),
        None => element.attribute(&*field.name()),
    }
}

fn file_info(layout: &Layout<'_>, field: Option<&Field>) -> Option<Span> {
    let Profile { body, .. } = layout.device.or(layout.network)?;
    let found = match field? {
        Field::Description => {
            layout.in_device(&[n::DeviceIdentity, n::productText, n::description]).map(text_of)
        }
        Field::FileRevision => body.attribute(n::fileVersion).map(value_of),
        field => named(body, &DEVICE_BODY, field).map(value_of),
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

/// An attribute of the features or of `ApplicationLayers`; else the features.
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
    let list = layout.in_network(&[n::TransportLayers, n::PhysicalLayer, n::baudRate])?;
    let mut values =
        list.children_named(n::supportedBaudRate).filter_map(|element| element.attribute(n::value));
    let found = match rate {
        Rate::Default => list.attribute(n::defaultValue),
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
    let found = named(node, &DEVICE_COMMISSIONING, field);
    // CANopenEditor writes the second
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

/// An attribute of a channel: `Type2` is the data type of the second.
fn channel(channels: Element<'_>, name: &str) -> Option<Span> {
    let digits = name.bytes().rev().take_while(u8::is_ascii_digit).count();
    let (word, number) = name.split_at(name.len() - digits);
    let position = number.parse::<usize>().ok()?.checked_sub(1)?;
    let channel = channels.children_named(n::dynamicChannel).nth(position)?;
    Some(channel.attribute(channel_attribute(word)).map_or(channel.tag_span(), value_of))
}
