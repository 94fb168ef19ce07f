//! The headers of the profiles, the file attributes of their bodies, and the identity of the device: `DeviceIdentity`, and
//! `identity` of the communication network profile.

use super::{XddReader, drop_same};
use crate::diagnostic::Findings;
use crate::model::{DeviceInfo, Field, FileInfo, Label, Labels, NetworkIdentity, ProfileHeader};
use crate::xdd::defaults::{self, Placeholders};
use crate::xdd::fact::PlacedText;
use crate::xdd::layout::DescriptionProfile;
use crate::xdd::leftovers::Leftovers;
use crate::xdd::profile_class::ProfileClass;
use crate::xdd::schema::container::DEVICE_BODY;
use crate::xdd::schema::{DEVICE_IDENTITY, IDENTITY};
use crate::xdd::shape::{self, facts};
use crate::xml::{Element, Name, n};

impl<'a> XddReader<'a> {
    pub(super) fn device_identity(&mut self, element: Element<'a>) {
        let mut identity = shape::read(element, &DEVICE_IDENTITY, &mut self.leftovers);
        let rest = &mut identity.rest;
        let info = self.device.device_info.get_or_insert_default();
        let placeholders = self.placeholders;
        let name = |text: Option<Box<str>>| {
            let text = text.map(|text| text.trim_ascii().to_owned());
            text.filter(|text| text != defaults::NOT_STATED || !placeholders.are_dropped())
        };
        info.vendor_name = name(identity.vendor_name);
        info.product_name = name(identity.product_name);
        numbers(element, info, self.placeholders, &mut self.findings);
        let mut order_numbers = identity.order_numbers.into_iter();
        info.order_code = order_numbers.next().map(|text| text.trim_ascii().to_owned());
        rest.further_order_numbers = order_numbers.collect();
        if placeholders.are_dropped() && rest.product_text == defaults::product_text() {
            rest.product_text = Labels::default();
        }
        let description = rest.product_text.description_in(defaults::LANGUAGE);
        if let Some(description) = description {
            let file_info = self.device.file_info.get_or_insert_default();
            file_info.description = Some(description.trim_ascii().to_owned());
        }
        if is_plain_description(&rest.product_text) {
            rest.product_text = Labels::default();
        }
        self.device.identity = Some(Box::new(identity.rest));
    }

    /// The identity in the communication network profile, without fields that equal the device profile.
    pub(super) fn network_identity(&mut self, element: Element<'a>) {
        let read = shape::read(element, &IDENTITY, &mut self.leftovers);
        let mut identity = read.rest;
        let info = self.device.device_info.get_or_insert_default();
        let Some(device) = &self.device.identity else {
            numbers(element, info, self.placeholders, &mut self.findings);
            self.device.identity = Some(Box::new(identity));
            return;
        };
        drop_same! { identity, device: vendor_text device_family product_family product_text versions build_date
        specification_revision instance_name }
        identity.read_only.retain(|stated| !device.read_only.contains(stated));
        let mut stated = DeviceInfo::default();
        numbers(element, &mut stated, self.placeholders, &mut Findings::new());
        let differs = |stated: Option<u32>, own: Option<u32>, text: Option<Box<str>>| {
            let is_other = stated.is_none() || stated != own;
            text.filter(|text| !text.trim_ascii().is_empty() && is_other)
        };
        let network = NetworkIdentity {
            vendor_id: differs(stated.vendor_number, info.vendor_number, read.vendor_id),
            product_id: differs(stated.product_number, info.product_number, read.product_id),
            identity,
        };
        self.device.network_identity =
            Some(Box::new(network)).filter(|network| **network != NetworkIdentity::default());
    }
}

/// Vendor-ID and product code.
fn numbers(element: Element<'_>, info: &mut DeviceInfo, placeholders: Placeholders, findings: &mut Findings) {
    let mut number = |name: Name, field: Field| {
        let text = PlacedText::in_element(element.child(name)?);
        if text.text == defaults::ID && placeholders.are_dropped() {
            return None;
        }
        let read = text.integer(u64::from(u32::MAX), findings);
        read.unwrap_or_else(|reason| {
            info.invalid_values.push(field, &text.text, reason);
            None
        })
    };
    let vendor = number(n::vendorID, Field::VendorNumber);
    let product = number(n::productID, Field::ProductNumber);
    (info.vendor_number, info.product_number) = (vendor, product);
}

/// Whether the labels are a single English description, which is all that an EDS supports.
fn is_plain_description(labels: &Labels) -> bool {
    matches!(&labels.0[..], [Label::Description { lang, uri: None, .. }] if &**lang == defaults::LANGUAGE)
}

impl<'a> XddReader<'a> {
    /// The headers of both profiles; headers equal to the placeholders are dropped.
    pub(super) fn headers(&mut self) {
        let header = |profile: Option<DescriptionProfile<'a>>| profile.and_then(|profile| profile.header);
        let (device, network) = (header(self.layout.device), header(self.layout.network));
        self.device.headers.device = device.and_then(|element| self.header(element, ProfileClass::Device));
        self.device.headers.network = network.and_then(|element| self.header(element, ProfileClass::Network));
    }

    fn header(&mut self, element: Element<'a>, class: ProfileClass) -> Option<ProfileHeader> {
        let header = shape::read(element, class.header(), &mut self.leftovers);
        let says_nothing = header == class.unstated_header() || header == ProfileHeader::default();
        Some(header).filter(|_| !says_nothing)
    }

    /// The file attributes of the bodies. For the communication network profile, only differences are kept.
    pub(super) fn files(&mut self) {
        let placeholders = self.placeholders;
        let mut info = |profile: Option<DescriptionProfile<'a>>| {
            profile
                .map(|profile| file_info(profile.body, placeholders, &mut self.leftovers, &mut self.findings))
        };
        let (device, network) = (info(self.layout.device), info(self.layout.network));
        match (device, network) {
            (Some(device), Some(mut network)) => {
                drop_same! { network, device: file_name file_version file_revision creation_time creation_date created_by modification_time
                modification_date modified_by languages device_class invalid_values }
                let says_something = network != FileInfo::default();
                self.device.headers.network_file = Some(Box::new(network)).filter(|_| says_something);
                self.device.file_info = Some(device);
            }
            (device, network) => self.device.file_info = device.or(network),
        }
    }
}

/// The file attributes of a body.
fn file_info<'a>(
    body: Element<'a>,
    placeholders: Placeholders,
    leftovers: &mut Leftovers<'a>,
    findings: &mut Findings,
) -> FileInfo {
    let mut info = FileInfo::default();
    for attribute in body.attributes() {
        let text = PlacedText::of(attribute);
        // the network profile has fewer attributes
        let is_taken = match attribute.tag() {
            n::formatName => text.trimmed() == "CANopen",
            n::formatVersion => text.trimmed() == "1.0",
            // the type of the profile
            n::r#type => true,
            name => facts::take(&mut info, &DEVICE_BODY, name, &text, placeholders, findings),
        };
        if !is_taken {
            leftovers.attribute(body, attribute);
        }
    }
    info
}
