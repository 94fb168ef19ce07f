//! Summary of a device.

use super::context::{Context, Subject};
use crate::Language;
use crate::model::{ClockTime, Date, Device, DeviceInfo, FileInfo, Part, PdoKind};

/// Properties of a device and its file.
pub(crate) struct Card {
    /// The product name.
    pub(crate) title: String,
    /// Vendor name and device profile.
    pub(crate) subtitle: String,
    /// Identity and capabilities.
    pub(crate) device: Vec<CardLine>,
    /// The configured node; empty for a device type.
    pub(crate) node: Vec<CardLine>,
    /// Metadata of the description.
    pub(crate) file: Vec<CardLine>,
    /// The comment lines.
    pub(crate) comments: Vec<String>,
    /// Vendor-specific or tool-specific keys that belong to no object, as in the file.
    pub(crate) sections: Vec<VendorSection>,
}

/// A section with vendor-specific or tool-specific keys.
pub(crate) struct VendorSection {
    pub(crate) name: String,
    pub(crate) keys: Vec<(String, String)>,
}

/// A named property.
pub(crate) struct CardLine {
    pub(crate) name: &'static str,
    pub(crate) text: String,
}

/// Collects properties and omits empty ones.
struct CardLines(Vec<CardLine>);

impl CardLines {
    fn put(&mut self, name: &'static str, text: impl Into<String>) {
        let text = text.into();
        if !text.trim().is_empty() {
            self.0.push(CardLine { name, text });
        }
    }

    fn put_some(&mut self, name: &'static str, text: Option<impl Into<String>>) {
        if let Some(text) = text {
            self.put(name, text);
        }
    }
}

impl Card {
    pub(super) fn new<'a>(subject: &Subject<'a>, context: &Context<'a>) -> Self {
        let device = subject.device;
        let info = device.device_info.as_ref();
        let stated = |text: Option<&'a String>| text.map(|text| text.trim()).filter(|text| !text.is_empty());
        let title = stated(info.and_then(|info| info.product_name.as_ref()));
        let vendor = stated(info.and_then(|info| info.vendor_name.as_ref())).map(str::to_owned);
        let subtitle: Vec<String> = vendor.into_iter().chain(context.decoder.device_profile()).collect();
        Self {
            title: title.unwrap_or(subject.file).to_owned(),
            subtitle: subtitle.join(" · "),
            device: device_facts(context),
            node: node_facts(context),
            file: file_facts(subject, context),
            comments: device.comments.clone().unwrap_or_default(),
            sections: sections(device),
        }
    }
}

fn device_facts(context: &Context<'_>) -> Vec<CardLine> {
    let (device, texts) = (context.device, context.texts);
    let default = DeviceInfo::default();
    let info = device.device_info.as_ref().unwrap_or(&default);
    let identity = device.identity();
    let hex = |stated: Option<u32>, in_dictionary: Option<u32>| {
        stated.or(in_dictionary).map(|number| format!("0x{number:08X}"))
    };
    let mut facts = CardLines(Vec::new());
    facts.put_some(texts.vendor, info.vendor_name.clone());
    facts.put_some(texts.vendor_id, hex(info.vendor_number, identity.vendor_id));
    facts.put_some(texts.product, info.product_name.clone());
    facts.put_some(texts.product_code, hex(info.product_number, identity.product_code));
    facts.put_some(texts.revision, hex(info.revision_number, identity.revision_number));
    facts.put_some(texts.order_code, info.order_code.clone());
    further_identity(context, &mut facts);
    if let Some(value) = device.value(0x1000, 0) {
        facts.put_some(texts.profile, context.decoder.of(0x1000, 0, &value));
    }
    facts.put(texts.bit_rates, bit_rates(info, context));
    facts.put(texts.features, features(info, device, context).join(", "));
    if let Some(modules) = device.modules.as_ref().filter(|modules| !modules.supported.is_empty()) {
        let names = modules.supported.values().map(|module| module.product_name.as_deref().unwrap_or("?"));
        facts.put(texts.modules, names.collect::<Vec<_>>().join(", "));
    }
    facts.0
}

/// Properties that only an XDD contains.
fn further_identity(context: &Context<'_>, facts: &mut CardLines) {
    let Some(identity) = context.device.identity.as_deref() else { return };
    let texts = context.texts;
    facts.put_some(texts.family, identity.device_family.description_in(context.tag));
    facts.put_some(texts.family, identity.product_family.as_deref());
    facts.put_some(texts.description, identity.product_text.description_in(context.tag));
    let versions: Vec<String> =
        identity.versions.iter().map(|version| format!("{} {}", version.kind, version.version)).collect();
    facts.put(texts.versions, versions.join(", "));
}

fn bit_rates(info: &DeviceInfo, context: &Context<'_>) -> String {
    let mut rates: Vec<u16> = info.baud_rates.supported().collect();
    rates.extend(info.baud_rates.kbit_100.filter(|&has| has).map(|_| 100));
    rates.sort_unstable();
    let rates: Vec<String> = rates.iter().map(ToString::to_string).collect();
    let mut text = rates.join(", ");
    if !text.is_empty() {
        text.push_str(" kbit/s");
    }
    if info.baud_rates.auto == Some(true) {
        let detected = context.language.pick("detected automatically", "selbst erkannt");
        text = if text.is_empty() { detected.to_owned() } else { format!("{text}; {detected}") };
    }
    text
}

/// The capabilities of the device, as text.
fn features(info: &DeviceInfo, device: &Device, context: &Context<'_>) -> Vec<String> {
    let language = context.language;
    let flags = [
        (info.lss_supported, "LSS", "LSS"),
        (info.lss_master, "LSS master", "LSS-Master"),
        (info.simple_boot_up_master, "boot-up master", "Boot-up-Master"),
        (info.simple_boot_up_slave, "boot-up slave", "Boot-up-Slave"),
        (info.group_messaging, "multiplexed PDOs", "multiplexte PDOs"),
        (info.dynamic_channels_supported.map(|count| count > 0), "dynamic channels", "dynamische Kanäle"),
        (info.safety_supported, "CANopen Safety", "CANopen Safety"),
        (info.self_starting, "starts by itself", "startet selbst"),
        (info.flying_master, "flying master", "Flying Master"),
        (info.sdo_manager, "SDO manager", "SDO-Manager"),
        (info.sdo_requesting, "SDO requesting device", "fordert SDOs an"),
        (info.configuration_manager, "configuration manager", "Konfigurationsmanager"),
    ];
    let count = |stated: Option<u16>, kind| stated.map_or_else(|| device.pdo_count(kind), usize::from);
    let mut features = vec![
        format!("{} RPDO", count(info.rpdo_count, PdoKind::Rpdo)),
        format!("{} TPDO", count(info.tpdo_count, PdoKind::Tpdo)),
    ];
    match info.granularity {
        Some(0) => features.push(language.pick("fixed PDO mapping", "festes PDO-Mapping").to_owned()),
        Some(bits) => features.push(match language {
            Language::English => format!("PDO mapping in steps of {bits} bits"),
            Language::German => format!("PDO-Mapping in Schritten von {bits} Bit"),
        }),
        None => {}
    }
    let supported = flags.iter().filter(|(has, ..)| *has == Some(true));
    features.extend(supported.map(|(_, english, german)| language.pick(english, german).to_owned()));
    features
}

fn node_facts(context: &Context<'_>) -> Vec<CardLine> {
    let texts = context.texts;
    let mut facts = CardLines(Vec::new());
    facts.put_some(texts.node_id, context.node_id.map(|id| format!("{id} (0x{id:02X})")));
    let Some(node) = &context.device.commissioning else { return facts.0 };
    facts.put_some(texts.name, node.node_name.clone());
    facts.put_some(texts.bit_rate, node.baud_rate.map(|rate| format!("{rate} kbit/s")));
    let network = [node.net_number.map(|number| number.to_string()), node.network_name.clone()];
    facts.put(texts.network, network.into_iter().flatten().collect::<Vec<_>>().join(" "));
    facts.put_some(texts.serial_number, node.lss_serial_number.map(|number| format!("0x{number:08X}")));
    if node.manager == Some(true) {
        facts.put(texts.features, context.language.pick("manager of the network", "Manager des Netzwerks"));
    }
    facts.0
}

fn file_facts(subject: &Subject<'_>, context: &Context<'_>) -> Vec<CardLine> {
    let texts = context.texts;
    let mut facts = CardLines(Vec::new());
    facts.put(texts.file, format!("{} ({})", subject.file, subject.format));
    let default = FileInfo::default();
    let info = subject.device.file_info.as_ref().unwrap_or(&default);
    facts.put_some(texts.description, info.description.clone());
    let version = info.file_version.map(|version| version.to_string()).into_iter();
    let version: Vec<String> =
        version.chain(info.file_revision.map(|revision| revision.to_string())).collect();
    facts.put(texts.version, version.join("."));
    facts.put_some(texts.eds_version, info.eds_version.clone());
    facts.put(texts.created, by_whom(info.creation_date, info.creation_time, info.created_by.as_deref()));
    let modified = by_whom(info.modification_date, info.modification_time, info.modified_by.as_deref());
    facts.put(texts.modified, modified);
    facts.put_some(texts.made_from, info.last_eds.clone());
    facts.put_some(texts.made_from, subject.device.is_ethercat().then_some("EtherCAT"));
    facts.0
}

/// Sections without a field in the model.
fn sections(device: &Device) -> Vec<VendorSection> {
    let of_parts = device.extras().into_iter().filter_map(|(part, extra)| match part {
        // shown with their objects
        Part::Object(_) | Part::Entry(..) => None,
        part => Some(section(part.to_string(), extra.iter())),
    });
    let unknown = device.extra.iter().map(|unknown| section(unknown.name().to_owned(), unknown.entries()));
    of_parts.chain(unknown).collect()
}

fn section<'a>(name: String, keys: impl Iterator<Item = (&'a str, &'a str)>) -> VendorSection {
    VendorSection { name, keys: keys.map(|(key, value)| (key.to_owned(), value.to_owned())).collect() }
}

/// `2024-03-04 14:40, A. Smith`.
fn by_whom(date: Option<Date>, time: Option<ClockTime>, person: Option<&str>) -> String {
    let time = time.map(|time| time.to_iso(false));
    let when: Vec<String> = date.map(Date::to_iso).into_iter().chain(time).collect();
    let parts = [when.join(" "), person.unwrap_or_default().trim().to_owned()];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}
