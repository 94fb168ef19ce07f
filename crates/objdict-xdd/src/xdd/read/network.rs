//! The communication network profile without its objects: features, bit rates, dummies, channels, the node.

use super::XddReader;
use crate::model::{
    BaudRates, Commissioning, DataType, DefaultBaudRate, DeviceInfo, DummyUsage, DynamicChannels, Field,
    ModuleObjects, ObjectList, Reason, Segment,
};
use crate::xdd::defaults::{
    DIRECTIONS, channel_field, count, count_attribute, default_rate_field, range_length, supported_field,
};
use crate::xdd::fact::{PlacedText, bit_rate, hex, stated_text};
use crate::xdd::layout::DescriptionProfile;
use crate::xdd::leftovers::Leftovers;
use crate::xdd::schema::network::{DEVICE_COMMISSIONING, GENERAL_FEATURES, MASTER_FEATURES};
use crate::xdd::schema::{APPLICATION_LAYERS, MODULE_MANAGEMENT, Shape};
use crate::xdd::shape::facts;
use crate::xdd::{defaults, shape};
use crate::xml::{Element, Name, n};

impl<'a> XddReader<'a> {
    /// The communication network profile without its file attributes and objects.
    pub(super) fn network_body(&mut self) {
        let Some(DescriptionProfile { body, .. }) = self.layout.network else { return };
        self.children(body, |this, element| match element.tag() {
            n::ApplicationLayers => this.application_layers(element),
            n::TransportLayers => this.transport_layers(element),
            n::NetworkManagement => this.network_management(element),
            _ => false,
        });
        self.leftovers.text(body);
    }

    /// Passes each child to `read`. Children that it does not read, and repeated children, become
    /// leftovers.
    fn children(&mut self, parent: Element<'a>, mut read: impl FnMut(&mut Self, Element<'a>) -> bool) {
        let mut seen = Vec::new();
        for element in parent.children() {
            let is_first = !seen.contains(&element.tag());
            if is_first {
                seen.push(element.tag());
            }
            if !is_first || !read(self, element) {
                self.leftovers.element(element);
            }
        }
    }

    /// The attributes of an element that are fields of the device.
    fn facts(&mut self, element: Element<'a>, shape: &'static Shape<DeviceInfo>) {
        let info = self.device.device_info.get_or_insert_default();
        for attribute in element.attributes() {
            let (name, text) = (attribute.tag(), PlacedText::of(attribute));
            if !facts::take(info, shape, name, &text, self.placeholders, &mut self.findings) {
                self.leftovers.attribute(element, attribute);
            }
        }
        self.leftovers.text(element);
    }

    fn application_layers(&mut self, layers: Element<'a>) -> bool {
        self.facts(layers, &APPLICATION_LAYERS);
        self.children(layers, |this, element| {
            match element.tag() {
                n::identity => this.network_identity(element),
                n::CANopenObjectList => this.object_list(element),
                n::dummyUsage => this.dummy_usage(element),
                n::dynamicChannels => this.dynamic_channels(element),
                n::moduleManagement => {
                    let modules: ModuleObjects =
                        shape::read(element, &MODULE_MANAGEMENT, &mut this.leftovers);
                    let says_something = modules != ModuleObjects::default();
                    this.device.module_objects = Some(Box::new(modules)).filter(|_| says_something);
                }
                _ => return false,
            }
            true
        });
        true
    }

    /// The attributes of an object list. A count that differs from the number of objects becomes a leftover.
    fn object_list(&mut self, list: Element<'a>) {
        self.derive_lists();
        for attribute in list.attributes() {
            let counted = ObjectList::ALL.into_iter().find(|list| count_attribute(*list) == attribute.tag());
            let count = counted.map(|counted| count(self.device.objects.keys(), counted).to_string());
            if count.as_deref() != Some(attribute.value().trim_ascii()) {
                self.leftovers.attribute(list, attribute);
            }
        }
        self.leftovers.text(list);
        list.children()
            .filter(|child| child.tag() != n::CANopenObject)
            .for_each(|child| self.leftovers.element(child));
    }

    /// `Dummy0005=1`.
    pub(super) fn dummy_usage(&mut self, element: Element<'a>) {
        let mut usage = DummyUsage::default();
        for child in element.children() {
            let Some(entry) = child.attribute(n::entry).filter(|_| child.tag() == n::dummy) else {
                self.leftovers.element(child);
                continue;
            };
            let text = PlacedText::of(entry);
            let (key, value) = text.trimmed().split_once('=').unwrap_or((text.trimmed(), ""));
            let (key, value) = (key.trim_ascii(), value.trim_ascii());
            let data_type = key.strip_prefix("Dummy").and_then(|digits| hex(digits, 4));
            let data_type = data_type.and_then(|index| u16::try_from(index).ok()).map(DataType);
            match (data_type, value) {
                (Some(data_type), "0" | "1") if !usage.types.contains_key(&data_type) => {
                    usage.types.insert(data_type, value == "1");
                }
                (Some(_), value) if !value.is_empty() => {
                    usage.invalid_values.push(Field::Named(key.into()), value, Reason::NotANumber);
                }
                _ => usage.extra.push(key, value),
            }
        }
        self.device.dummy_usage = Some(usage);
    }

    fn dynamic_channels(&mut self, element: Element<'a>) {
        let mut channels = DynamicChannels::default();
        for child in element.children() {
            if child.tag() == n::dynamicChannel {
                let channel = self.dynamic_channel(child, &mut channels);
                channels.segments.push(channel);
            } else {
                self.leftovers.element(child);
            }
        }
        self.device.dynamic_channels = Some(channels);
    }

    fn dynamic_channel(&mut self, child: Element<'a>, channels: &mut DynamicChannels) -> Segment {
        let number = channels.segments.len() + 1;
        let mut segment = Segment::default();
        let (mut first, mut last) = (None, None);
        for attribute in child.attributes() {
            let text = PlacedText::of(attribute);
            let index = || Ok(text.hex(4)?.and_then(|number| u16::try_from(number).ok()));
            let word = |to_eds: fn(&str) -> Box<str>| Ok(stated_text(&text.text, None).map(to_eds));
            let findings = &mut self.findings;
            let is_read = match attribute.tag() {
                n::dataType => index().map(|index| segment.data_type = index.map(DataType)),
                n::accessType => word(direction).map(|word| segment.direction = word),
                n::startIndex => index().map(|index| first = index),
                n::endIndex => index().map(|index| last = index),
                n::maxNumber => {
                    text.integer(u32::MAX.into(), findings).map(|number| segment.max_number = number)
                }
                n::addressOffset => word(offset).map(|word| segment.offset = word),
                n::bitAlignment => {
                    text.integer(u8::MAX.into(), findings).map(|bits| segment.bit_alignment = bits)
                }
                _ => {
                    self.leftovers.attribute(child, attribute);
                    Ok(())
                }
            };
            if let Err(reason) = is_read {
                channels.invalid_values.push(channel_field(attribute.tag(), number), &text.text, reason);
            }
        }
        segment.range = first.zip(last);
        segment.max_number = segment.max_number.filter(|number| Some(*number) != range_length(segment.range));
        segment
    }

    fn transport_layers(&mut self, layers: Element<'a>) -> bool {
        let below = |parents: Vec<Element<'a>>, name: Name, leftovers: &mut Leftovers<'a>| {
            let (found, others): (Vec<_>, Vec<_>) =
                parents.into_iter().flat_map(Element::children).partition(|child| child.tag() == name);
            others.into_iter().for_each(|other| leftovers.element(other));
            found
        };
        let physical = below(vec![layers], n::PhysicalLayer, &mut self.leftovers);
        let lists = below(physical, n::baudRate, &mut self.leftovers);
        self.bit_rates(lists);
        true
    }

    /// The bit rates of all `baudRate`.
    pub(super) fn bit_rates(&mut self, lists: Vec<Element<'a>>) {
        let mut rates = Vec::new();
        for rate in lists {
            for attribute in rate.attributes() {
                if attribute.tag() != n::defaultValue {
                    self.leftovers.attribute(rate, attribute);
                    continue;
                }
                let info = self.info();
                let text = PlacedText::of(attribute);
                match text.word(default_rate, Reason::UnknownWord) {
                    Ok(rate) => info.default_baud_rate = rate,
                    Err(reason) => info.invalid_values.push(default_rate_field(), &text.text, reason),
                }
            }
            for supported in rate.children() {
                match supported.attribute(n::value).filter(|_| supported.tag() == n::supportedBaudRate) {
                    Some(value) => rates.push(PlacedText::of(value)),
                    None => self.leftovers.element(supported),
                }
            }
        }
        // a placeholder for no bit rate
        let is_twice = rates.len() == 2 && rates.iter().all(|text| text.text == defaults::BIT_RATE);
        let is_placeholder = is_twice && self.placeholders.are_dropped();
        if !rates.is_empty() && !is_placeholder {
            let info = self.info();
            info.baud_rates = none_supported();
            rates.iter().for_each(|text| supported(info, text));
        }
    }

    fn network_management(&mut self, management: Element<'a>) -> bool {
        self.children(management, |this, element| {
            match element.tag() {
                n::CANopenGeneralFeatures => this.facts(element, &GENERAL_FEATURES),
                n::CANopenMasterFeatures => this.facts(element, &MASTER_FEATURES),
                n::deviceCommissioning => this.commissioning(element),
                _ => return false,
            }
            element.children().for_each(|child| this.leftovers.element(child));
            true
        });
        true
    }

    fn commissioning(&mut self, element: Element<'a>) {
        let mut node = Commissioning::default();
        for attribute in element.attributes() {
            // CANopenEditor writes `NodeID`
            let name = match attribute.tag() {
                n::nodeID | n::NodeID if node.node_id.is_some() => Name::OTHER,
                n::NodeID => n::nodeID,
                name => name,
            };
            let (shape, text) = (&DEVICE_COMMISSIONING, PlacedText::of(attribute));
            if !facts::take(&mut node, shape, name, &text, self.placeholders, &mut self.findings) {
                node.extra.push(attribute.name(), &attribute.value());
            }
        }
        self.leftovers.text(element);
        self.device.commissioning = Some(node);
    }
}

/// The keyword of an EDS for a direction.
fn direction(word: &str) -> Box<str> {
    DIRECTIONS.iter().find(|(xdd, _)| *xdd == word).map_or(word, |(_, eds)| eds).into()
}

/// The offset of a segment as an EDS writes it.
fn offset(text: &str) -> Box<str> {
    let is_digits = text.len().is_multiple_of(2) && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_digits { format!("0x{text}").into() } else { text.into() }
}

/// The bit rates that a list of supported ones does not contain. 100 kbit/s and automatic detection have no
/// keys in an EDS.
fn none_supported() -> BaudRates {
    let mut rates = BaudRates::default();
    for (kbit, ..) in BaudRates::default().iter() {
        rate(&mut rates, kbit).into_iter().for_each(|supported| *supported = Some(false));
    }
    rates
}

/// The field of a bit rate of CiA 311.
fn rate(rates: &mut BaudRates, kbit: u16) -> Option<&mut Option<bool>> {
    Some(match kbit {
        10 => &mut rates.kbit_10,
        20 => &mut rates.kbit_20,
        50 => &mut rates.kbit_50,
        100 => &mut rates.kbit_100,
        125 => &mut rates.kbit_125,
        250 => &mut rates.kbit_250,
        500 => &mut rates.kbit_500,
        800 => &mut rates.kbit_800,
        1000 => &mut rates.kbit_1000,
        _ => return None,
    })
}

fn supported(info: &mut DeviceInfo, text: &PlacedText<'_>) {
    let place = match default_rate(text.trimmed()) {
        Some(DefaultBaudRate::Auto) => Some(&mut info.baud_rates.auto),
        Some(DefaultBaudRate::Kbit(kbit)) => rate(&mut info.baud_rates, kbit),
        None => None,
    };
    match place {
        Some(supported) => *supported = Some(true),
        None => info.invalid_values.push(supported_field(), &text.text, Reason::UnknownWord),
    }
}

fn default_rate(text: &str) -> Option<DefaultBaudRate> {
    let is_auto =
        ["auto-baudRate", "autoBaudRate", "auto"].iter().any(|word| word.eq_ignore_ascii_case(text));
    if is_auto { Some(DefaultBaudRate::Auto) } else { bit_rate(text).map(DefaultBaudRate::Kbit) }
}
