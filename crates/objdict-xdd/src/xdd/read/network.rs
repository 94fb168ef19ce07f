//! The communication network profile but for its objects: features, bit rates, dummies, channels, the node.

use super::objects::count;
use super::text::{bit_rate, hex, value_text};
use super::{Reader, Text};
use crate::model::{
    BaudRates, DataType, DefaultBaudRate, DeviceInfo, DummyUsage, DynamicChannels, Field, ObjectList, Reason,
    Segment,
};
use crate::xdd::defaults;
use crate::xdd::layout::Profile;
use crate::xdd::shape::Shape;
use crate::xml::{Attribute, Element};

const U8: (i64, u64) = (0, u8::MAX as u64);
const U32: (i64, u64) = (0, u32::MAX as u64);
/// Bits of the mapping granularity, and the number of PDOs of one direction (CiA 306-1 §4.5).
const GRANULARITY: (i64, u64) = (0, 64);
const PDO_COUNT: (i64, u64) = (0, 512);

impl<'a> Reader<'a> {
    /// The communication network profile but for its file attributes and objects. Of two elements of a name the first counts.
    pub(super) fn network_body(&mut self) {
        let Some(Profile { body, .. }) = self.layout.network else { return };
        let mut seen = Vec::new();
        for element in body.children() {
            let is_first = !seen.contains(&element.name());
            seen.push(element.name());
            match element.name() {
                "ApplicationLayers" if is_first => self.application_layers(element),
                "TransportLayers" if is_first => self.transport_layers(element),
                "NetworkManagement" if is_first => self.network_management(element),
                _ => self.leftovers.element(element),
            }
        }
        self.leftovers.text(body);
    }

    fn application_layers(&mut self, layers: Element<'a>) {
        for attribute in layers.attributes() {
            match attribute.name() {
                "conformanceClass" => {
                    self.info().conformance_class = Some(attribute.value().trim_ascii().to_owned());
                }
                "communicationEntityType" => {
                    let words = attribute.value();
                    self.info().communication_entities =
                        words.split_ascii_whitespace().map(Into::into).collect();
                }
                _ => self.leftovers.attribute(layers, attribute),
            }
        }
        self.leftovers.text(layers);
        let mut seen = Vec::new();
        for element in layers.children() {
            let is_first = !seen.contains(&element.name());
            seen.push(element.name());
            match element.name() {
                "identity" if is_first => self.network_identity(element),
                "CANopenObjectList" if is_first => self.object_list(element),
                "dummyUsage" if is_first => self.dummy_usage(element),
                "dynamicChannels" if is_first => self.dynamic_channels(element),
                "moduleManagement" if is_first => {
                    let modules = Shape::read(element, &mut self.leftovers);
                    self.device.module_objects =
                        Some(modules).filter(|modules| *modules != Default::default());
                }
                _ => self.leftovers.element(element),
            }
        }
    }

    /// What the list says of itself. A count is left over where it is not the number of objects.
    fn object_list(&mut self, list: Element<'a>) {
        self.derive_lists();
        for attribute in list.attributes() {
            let counted = ObjectList::ALL.into_iter().find(|list| count_attribute(*list) == attribute.name());
            let count = counted.map(|counted| count(self.device.objects.keys(), counted).to_string());
            if count.as_deref() != Some(attribute.value().trim_ascii()) {
                self.leftovers.attribute(list, attribute);
            }
        }
        self.leftovers.text(list);
        list.children()
            .filter(|child| child.name() != "CANopenObject")
            .for_each(|child| self.leftovers.element(child));
    }

    /// `Dummy0005=1`.
    fn dummy_usage(&mut self, element: Element<'a>) {
        let mut usage = DummyUsage::default();
        for child in element.children() {
            let Some(entry) = child.attribute("entry").filter(|_| child.name() == "dummy") else {
                self.leftovers.element(child);
                continue;
            };
            let text = Text::of(entry);
            let (key, value) = text.trimmed().split_once('=').unwrap_or((text.trimmed(), ""));
            let (key, value) = (key.trim_ascii(), value.trim_ascii());
            let data_type = key.strip_prefix("Dummy").and_then(|digits| hex(digits, 4));
            let data_type = data_type.and_then(|index| u16::try_from(index).ok()).map(DataType);
            match (data_type, value) {
                (Some(data_type), "0" | "1") if !usage.types.contains_key(&data_type) => {
                    usage.types.insert(data_type, value == "1");
                }
                (Some(_), value) if !value.is_empty() => {
                    usage.misfits.push(Field::Named(key.into()), value, Reason::NotANumber);
                }
                _ => usage.extra.push(key, value),
            }
        }
        self.device.dummy_usage = Some(usage);
    }

    fn dynamic_channels(&mut self, element: Element<'a>) {
        let mut channels = DynamicChannels::default();
        for child in element.children() {
            if child.name() != "dynamicChannel" {
                self.leftovers.element(child);
                continue;
            }
            let number = channels.segments.len() + 1;
            let mut segment = Segment::default();
            let (mut first, mut last) = (None, None);
            for attribute in child.attributes() {
                let text = Text::of(attribute);
                let name = |word: &str| Field::Named(format!("{word}{number}").into());
                let misfits = &mut channels.misfits;
                match attribute.name() {
                    "dataType" => {
                        let index = text.hex(name("Type"), 4, misfits);
                        segment.data_type = index.and_then(|index| u16::try_from(index).ok()).map(DataType);
                    }
                    "accessType" => segment.direction = value_text(&text.text, None).map(direction),
                    "startIndex" => first = text.hex(name("startIndex"), 4, misfits),
                    "endIndex" => last = text.hex(name("endIndex"), 4, misfits),
                    "maxNumber" => {
                        segment.max_number =
                            text.integer(name("maxNumber"), U32, misfits, &mut self.findings);
                    }
                    "addressOffset" => segment.offset = value_text(&text.text, None).map(offset),
                    "bitAlignment" => {
                        segment.bit_alignment =
                            text.integer(name("bitAlignment"), U8, misfits, &mut self.findings);
                    }
                    _ => self.leftovers.attribute(child, attribute),
                }
            }
            let index = |number: Option<u32>| number.and_then(|number| u16::try_from(number).ok());
            segment.range = index(first).zip(index(last));
            segment.max_number =
                segment.max_number.filter(|number| Some(*number) != range_length(segment.range));
            channels.segments.push(segment);
        }
        self.device.dynamic_channels = Some(channels);
    }

    fn transport_layers(&mut self, layers: Element<'a>) {
        let mut rates = Vec::new();
        for physical in layers.children() {
            if physical.name() != "PhysicalLayer" {
                self.leftovers.element(physical);
                continue;
            }
            for rate in physical.children() {
                if rate.name() != "baudRate" {
                    self.leftovers.element(rate);
                    continue;
                }
                for attribute in rate.attributes() {
                    self.default_baud_rate(rate, attribute);
                }
                for supported in rate.children() {
                    match supported.attribute("value").filter(|_| supported.name() == "supportedBaudRate") {
                        Some(value) => rates.push(Text::of(value)),
                        None => self.leftovers.element(supported),
                    }
                }
            }
        }
        if !rates.is_empty() {
            let info = self.info();
            info.baud_rates = none_supported();
            rates.iter().for_each(|text| supported(info, text));
        }
    }

    fn default_baud_rate(&mut self, element: Element<'a>, attribute: Attribute<'a>) {
        if attribute.name() != "defaultValue" {
            return self.leftovers.attribute(element, attribute);
        }
        let info = self.info();
        let text = Text::of(attribute);
        info.default_baud_rate = text.word(default_rate_field(), default_rate, &mut info.misfits);
    }

    fn network_management(&mut self, management: Element<'a>) {
        let mut seen = Vec::new();
        for element in management.children() {
            let is_first = !seen.contains(&element.name());
            seen.push(element.name());
            match element.name() {
                "CANopenGeneralFeatures" if is_first => {
                    element.attributes().for_each(|attribute| self.general_feature(element, attribute));
                }
                "CANopenMasterFeatures" if is_first => {
                    element.attributes().for_each(|attribute| self.master_feature(element, attribute));
                }
                "deviceCommissioning" if is_first => self.commissioning(element),
                _ => {
                    self.leftovers.element(element);
                    continue;
                }
            }
            element.children().for_each(|child| self.leftovers.element(child));
            self.leftovers.text(element);
        }
    }

    fn general_feature(&mut self, element: Element<'a>, attribute: Attribute<'a>) {
        let info = self.device.device_info.get_or_insert_default();
        let (misfits, findings) = (&mut info.misfits, &mut self.findings);
        let text = Text::of(attribute);
        match attribute.name() {
            "groupMessaging" => info.group_messaging = text.boolean(Field::GroupMessaging, misfits),
            "dynamicChannels" => {
                info.dynamic_channels_supported =
                    text.integer(Field::DynamicChannelsSupported, U8, misfits, findings);
            }
            "selfStartingDevice" => {
                info.self_starting = text.boolean(Field::Named(attribute.name().into()), misfits);
            }
            "SDORequestingDevice" => {
                info.sdo_requesting = text.boolean(Field::Named(attribute.name().into()), misfits);
            }
            "granularity" if text.text == defaults::NUMBER => {}
            "granularity" => {
                info.granularity = text.integer(Field::Granularity, GRANULARITY, misfits, findings);
            }
            "nrOfRxPDO" => info.rpdo_count = text.integer(Field::NrOfRxPdo, PDO_COUNT, misfits, findings),
            "nrOfTxPDO" => info.tpdo_count = text.integer(Field::NrOfTxPdo, PDO_COUNT, misfits, findings),
            "bootUpSlave" => info.simple_boot_up_slave = text.boolean(Field::SimpleBootUpSlave, misfits),
            "layerSettingServiceSlave" => info.lss_supported = text.boolean(Field::LssSupported, misfits),
            _ => self.leftovers.attribute(element, attribute),
        }
    }

    fn master_feature(&mut self, element: Element<'a>, attribute: Attribute<'a>) {
        let info = self.device.device_info.get_or_insert_default();
        let misfits = &mut info.misfits;
        let text = Text::of(attribute);
        let named = Field::Named(attribute.name().into());
        match attribute.name() {
            "bootUpMaster" => info.simple_boot_up_master = text.boolean(Field::SimpleBootUpMaster, misfits),
            "flyingMaster" => info.flying_master = text.boolean(named, misfits),
            "SDOManager" => info.sdo_manager = text.boolean(named, misfits),
            "configurationManager" => info.configuration_manager = text.boolean(named, misfits),
            "layerSettingServiceMaster" => info.lss_master = text.boolean(named, misfits),
            _ => self.leftovers.attribute(element, attribute),
        }
    }

    fn commissioning(&mut self, element: Element<'a>) {
        let mut node = crate::model::Commissioning::default();
        for attribute in element.attributes() {
            let text = Text::of(attribute);
            let owned = || Some(text.trimmed().to_owned()).filter(|_| text.text != defaults::NAME);
            let (misfits, findings) = (&mut node.misfits, &mut self.findings);
            match attribute.name() {
                "nodeID" | "networkNumber" if text.text == defaults::NUMBER => {}
                "CANopenManager" if text.text == defaults::FLAG => {}
                // CANopenEditor writes the second
                "nodeID" | "NodeID" if node.node_id.is_none() => {
                    node.node_id = text.integer(Field::NodeId, U8, misfits, findings);
                }
                "nodeName" => node.node_name = owned(),
                "actualBaudRate" => node.baud_rate = text.word(Field::Baudrate, bit_rate, misfits),
                "networkNumber" => node.net_number = text.integer(Field::NetNumber, U32, misfits, findings),
                "networkName" => node.network_name = owned(),
                "CANopenManager" => node.manager = text.boolean(Field::CanOpenManager, misfits),
                _ => node.extra.push(attribute.name(), &attribute.value()),
            }
        }
        self.device.commissioning = Some(node);
    }
}

/// The attribute that counts the objects of a list.
pub(crate) const fn count_attribute(list: ObjectList) -> &'static str {
    match list {
        ObjectList::Mandatory => "mandatoryObjects",
        ObjectList::Optional => "optionalObjects",
        ObjectList::Manufacturer => "manufacturerObjects",
    }
}

/// The word of an EDS for a direction.
fn direction(word: &str) -> Box<str> {
    DIRECTIONS.iter().find(|(xdd, _)| *xdd == word).map_or(word, |(_, eds)| eds).into()
}

/// The offset of a segment as an EDS writes it.
fn offset(text: &str) -> Box<str> {
    let is_digits = text.len().is_multiple_of(2) && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_digits { format!("0x{text}").into() } else { text.into() }
}

/// `accessType` of a channel, and `DirN` of an EDS.
pub(crate) const DIRECTIONS: [(&str, &str); 3] =
    [("readOnly", "ro"), ("writeOnly", "wo"), ("readWriteOutput", "rww")];

/// How many indexes there are in a range: the number of objects of a channel that does not say it.
pub(crate) fn range_length(range: Option<(u16, u16)>) -> Option<u32> {
    range.map(|(first, last)| u32::from(last.saturating_sub(first)) + 1)
}

/// What a list of supported bit rates says of those that are not in it. 100 kbit/s and detection are no keys of an EDS.
const fn none_supported() -> BaudRates {
    BaudRates {
        kbit_10: Some(false),
        kbit_20: Some(false),
        kbit_50: Some(false),
        kbit_100: None,
        kbit_125: Some(false),
        kbit_250: Some(false),
        kbit_500: Some(false),
        kbit_800: Some(false),
        kbit_1000: Some(false),
        auto: None,
    }
}

fn supported(info: &mut DeviceInfo, text: &Text<'_>) {
    let rates = &mut info.baud_rates;
    let place = match default_rate(text.trimmed()) {
        Some(DefaultBaudRate::Auto) => &mut rates.auto,
        Some(DefaultBaudRate::Kbit(kbit)) => match kbit {
            10 => &mut rates.kbit_10,
            20 => &mut rates.kbit_20,
            50 => &mut rates.kbit_50,
            100 => &mut rates.kbit_100,
            125 => &mut rates.kbit_125,
            250 => &mut rates.kbit_250,
            500 => &mut rates.kbit_500,
            800 => &mut rates.kbit_800,
            1000 => &mut rates.kbit_1000,
            _ => return text.misfit(supported_field(), Reason::UnknownWord, &mut info.misfits),
        },
        None => return text.misfit(supported_field(), Reason::UnknownWord, &mut info.misfits),
    };
    *place = Some(true);
}

/// The field of a bit rate that there is not.
pub(crate) fn supported_field() -> Field {
    Field::Named("supportedBaudRate".into())
}

/// The field of the bit rate of a new device.
pub(crate) fn default_rate_field() -> Field {
    Field::Named("defaultBaudRate".into())
}

fn default_rate(text: &str) -> Option<DefaultBaudRate> {
    let is_auto =
        ["auto-baudRate", "autoBaudRate", "auto"].iter().any(|word| word.eq_ignore_ascii_case(text));
    if is_auto { Some(DefaultBaudRate::Auto) } else { bit_rate(text).map(DefaultBaudRate::Kbit) }
}
