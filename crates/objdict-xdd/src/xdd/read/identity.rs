//! Who made the device: `DeviceIdentity`, and `identity` of the communication network profile.

use super::{Reader, Text};
use crate::diagnostic::Findings;
use crate::model::{DeviceIdentity, DeviceInfo, Field, Label, Labels, Misfits, NetworkIdentity};
use crate::xdd::defaults;
use crate::xdd::shape::{Identity, Shape};
use crate::xml::Element;

const U32: (i64, u64) = (0, u32::MAX as u64);

impl<'a> Reader<'a> {
    pub(super) fn device_identity(&mut self, element: Element<'a>) {
        let Identity { vendor_name, product_name, order_numbers, mut rest, .. } =
            Identity::read(element, &mut self.leftovers);
        let info = self.device.device_info.get_or_insert_default();
        let name = |text: Option<Box<str>>| {
            let text = text.map(|text| text.trim_ascii().to_owned());
            text.filter(|text| text != defaults::NOT_STATED)
        };
        info.vendor_name = name(vendor_name);
        info.product_name = name(product_name);
        numbers(element, info, &mut self.findings);
        let mut order_numbers = order_numbers.into_iter();
        info.order_code = order_numbers.next().map(|text| text.trim_ascii().to_owned());
        rest.further_order_numbers = order_numbers.collect();
        let description = rest.product_text.description_in(defaults::LANGUAGE);
        if let Some(description) = description {
            let file_info = self.device.file_info.get_or_insert_default();
            file_info.description = Some(description.trim_ascii().to_owned());
        }
        if is_plain_description(&rest.product_text) {
            rest.product_text = Labels::default();
        }
        self.device.identity = Some(Box::new(rest));
    }

    /// What the communication network profile says of the device; where it says the same as the device profile, nothing.
    pub(super) fn network_identity(&mut self, element: Element<'a>) {
        let Identity { vendor_id, product_id, rest: mut identity, .. } =
            Identity::read(element, &mut self.leftovers);
        // the network profile has none of them
        let strange = ["vendorName", "productName", "orderNumber"];
        for child in element.children().filter(|child| strange.contains(&child.name())) {
            self.leftovers.element(child);
        }
        let info = self.device.device_info.get_or_insert_default();
        let Some(device) = &self.device.identity else {
            numbers(element, info, &mut self.findings);
            self.device.identity = Some(Box::new(identity));
            return;
        };
        drop_same(&mut identity, device);
        let mut stated = DeviceInfo::default();
        numbers(element, &mut stated, &mut Findings::new());
        let differs = |stated: Option<u32>, own: Option<u32>, text: &str| {
            !text.trim_ascii().is_empty() && (stated.is_none() || stated != own)
        };
        let network = NetworkIdentity {
            vendor_id: vendor_id.filter(|text| differs(stated.vendor_number, info.vendor_number, text)),
            product_id: product_id.filter(|text| differs(stated.product_number, info.product_number, text)),
            identity,
        };
        self.device.network_identity =
            Some(Box::new(network)).filter(|network| **network != NetworkIdentity::default());
    }
}

/// Vendor-ID and product code.
fn numbers(element: Element<'_>, info: &mut DeviceInfo, findings: &mut Findings) {
    let mut number = |name: &str, field: Field, misfits: &mut Misfits| {
        Text::in_element(element.child(name)?).integer(field, U32, misfits, findings)
    };
    info.vendor_number = number("vendorID", Field::VendorNumber, &mut info.misfits);
    info.product_number = number("productID", Field::ProductNumber, &mut info.misfits);
}

/// Whether labels are but one description, in English: what an EDS has.
fn is_plain_description(labels: &Labels) -> bool {
    matches!(&labels.0[..], [Label::Description { lang, uri: None, .. }] if &**lang == defaults::LANGUAGE)
}

/// Drops what the device profile says too.
fn drop_same(identity: &mut DeviceIdentity, device: &DeviceIdentity) {
    fn drop<T: Default + PartialEq>(own: &mut T, device: &T) {
        if own == device {
            *own = T::default();
        }
    }
    drop(&mut identity.vendor_text, &device.vendor_text);
    drop(&mut identity.device_family, &device.device_family);
    drop(&mut identity.product_family, &device.product_family);
    drop(&mut identity.product_text, &device.product_text);
    drop(&mut identity.versions, &device.versions);
    drop(&mut identity.build_date, &device.build_date);
    drop(&mut identity.specification_revision, &device.specification_revision);
    drop(&mut identity.instance_name, &device.instance_name);
    identity.read_only.retain(|stated| !device.read_only.contains(stated));
}
