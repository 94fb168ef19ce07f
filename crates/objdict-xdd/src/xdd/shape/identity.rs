//! Who made the device and what it is called: `DeviceIdentity` of the device profile, `identity` of the network profile.

use std::collections::HashMap;

use super::{Leftovers, Markup, Shape};
use crate::model::{Date, DeviceIdentity, DeviceVersion, Labels};
use crate::xml::Element;

/// All that the element says. The texts beside `rest` are those that an EDS has keys for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Identity {
    /// `vendorName`.
    pub(crate) vendor_name: Option<Box<str>>,
    /// `vendorID`, as it is written.
    pub(crate) vendor_id: Option<Box<str>>,
    /// `productName`.
    pub(crate) product_name: Option<Box<str>>,
    /// `productID`, as it is written.
    pub(crate) product_id: Option<Box<str>>,
    /// Every `orderNumber`; those of `rest` are none of them.
    pub(crate) order_numbers: Vec<Box<str>>,
    /// Everything else; `read_only` speaks of all elements, the second of a name being `orderNumber[2]`.
    pub(crate) rest: DeviceIdentity,
}

/// The elements as they stand, each with its `readOnly`.
#[derive(Default, PartialEq)]
struct Elements {
    vendor_name: Option<TextElement>,
    vendor_id: Option<TextElement>,
    vendor_text: Option<LabelsElement>,
    device_family: Option<LabelsElement>,
    product_family: Option<TextElement>,
    product_name: Option<TextElement>,
    product_id: Option<TextElement>,
    product_text: Option<LabelsElement>,
    order_numbers: Vec<TextElement>,
    versions: Vec<VersionElement>,
    build_date: Option<Date>,
    specification_revision: Option<TextElement>,
    instance_name: Option<TextElement>,
}

#[derive(Default, PartialEq)]
struct TextElement {
    read_only: Option<bool>,
    text: Box<str>,
}

#[derive(Default, PartialEq)]
struct LabelsElement {
    read_only: Option<bool>,
    labels: Labels,
}

#[derive(Default, PartialEq)]
struct VersionElement {
    kind: Box<str>,
    read_only: Option<bool>,
    version: Box<str>,
}

shape! {
    Elements [] {
        "vendorName" => vendor_name,
        "vendorID" => vendor_id,
        "vendorText" => vendor_text,
        "deviceFamily" => device_family,
        "productFamily" => product_family,
        "productName" => product_name,
        "productID" => product_id,
        "productText" => product_text,
        "orderNumber" => order_numbers,
        "version" => versions,
        "buildDate" @ "#text" => build_date,
        "specificationRevision" => specification_revision,
        "instanceName" => instance_name,
    }

    TextElement ["readOnly" = read_only, "#text" = text] {}

    LabelsElement ["readOnly" = read_only] { _ => labels }

    VersionElement ["versionType" = kind, "readOnly" = read_only, "#text" = version] {}
}

impl Shape for Identity {
    fn read<'a>(element: Element<'a>, leftovers: &mut Leftovers<'a>) -> Self {
        Elements::read(element, leftovers).into()
    }

    fn write(&self, name: &str, out: &mut Markup) {
        Shape::write(&Elements::from(self), name, out);
    }
}

impl From<Elements> for Identity {
    fn from(elements: Elements) -> Self {
        let mut marks = Marks::default();
        let order_numbers = elements.order_numbers.into_iter().enumerate();
        let versions = elements.versions.into_iter().enumerate();
        // in the order of the elements, as the list of marks has it
        let vendor_name = marks.text("vendorName", elements.vendor_name);
        let vendor_id = marks.text("vendorID", elements.vendor_id);
        let vendor_text = marks.labels("vendorText", elements.vendor_text);
        let device_family = marks.labels("deviceFamily", elements.device_family);
        let product_family = marks.text("productFamily", elements.product_family);
        let product_name = marks.text("productName", elements.product_name);
        let product_id = marks.text("productID", elements.product_id);
        let product_text = marks.labels("productText", elements.product_text);
        let order_numbers = order_numbers.map(|(at, TextElement { read_only, text })| {
            marks.add(&numbered("orderNumber", at), read_only);
            text
        });
        let order_numbers = order_numbers.collect();
        let versions = versions.map(|(at, VersionElement { kind, read_only, version })| {
            marks.add(&numbered("version", at), read_only);
            DeviceVersion { kind, version }
        });
        let versions = versions.collect();
        let specification_revision = marks.text("specificationRevision", elements.specification_revision);
        let instance_name = marks.text("instanceName", elements.instance_name);
        let rest = DeviceIdentity {
            vendor_text,
            device_family,
            product_family,
            product_text,
            further_order_numbers: Vec::new(),
            versions,
            build_date: elements.build_date,
            specification_revision,
            instance_name,
            read_only: marks.0,
        };
        Self { vendor_name, vendor_id, product_name, product_id, order_numbers, rest }
    }
}

/// The elements whose `readOnly` stands there, while they are collected.
#[derive(Default)]
struct Marks(Vec<(Box<str>, bool)>);

impl Marks {
    fn add(&mut self, name: &str, read_only: Option<bool>) {
        self.0.extend(read_only.map(|read_only| (name.into(), read_only)));
    }

    fn text(&mut self, name: &str, element: Option<TextElement>) -> Option<Box<str>> {
        let TextElement { read_only, text } = element?;
        self.add(name, read_only);
        Some(text)
    }

    fn labels(&mut self, name: &str, element: Option<LabelsElement>) -> Labels {
        let LabelsElement { read_only, labels } = element.unwrap_or_default();
        self.add(name, read_only);
        labels
    }
}

impl From<&Identity> for Elements {
    fn from(identity: &Identity) -> Self {
        let rest = &identity.rest;
        let marks: HashMap<&str, bool> =
            rest.read_only.iter().map(|(name, value)| (&**name, *value)).collect();
        let mark = |name: &str| marks.get(name).copied();
        let text = |name: &str, text: &Option<Box<str>>| {
            text.clone().map(|text| TextElement { read_only: mark(name), text })
        };
        let labels = |name: &str, labels: &Labels| {
            let element = LabelsElement { read_only: mark(name), labels: labels.clone() };
            Some(element).filter(|element| *element != LabelsElement::default())
        };
        let order_numbers = identity.order_numbers.iter().enumerate().map(|(at, text)| TextElement {
            read_only: mark(&numbered("orderNumber", at)),
            text: text.clone(),
        });
        let versions = rest.versions.iter().enumerate().map(|(at, DeviceVersion { kind, version })| {
            let read_only = mark(&numbered("version", at));
            VersionElement { kind: kind.clone(), read_only, version: version.clone() }
        });
        Self {
            vendor_name: text("vendorName", &identity.vendor_name),
            vendor_id: text("vendorID", &identity.vendor_id),
            vendor_text: labels("vendorText", &rest.vendor_text),
            device_family: labels("deviceFamily", &rest.device_family),
            product_family: text("productFamily", &rest.product_family),
            product_name: text("productName", &identity.product_name),
            product_id: text("productID", &identity.product_id),
            product_text: labels("productText", &rest.product_text),
            order_numbers: order_numbers.collect(),
            versions: versions.collect(),
            build_date: rest.build_date,
            specification_revision: text("specificationRevision", &rest.specification_revision),
            instance_name: text("instanceName", &rest.instance_name),
        }
    }
}

/// What the list of marks calls an element of several.
fn numbered(name: &str, at: usize) -> String {
    if at == 0 { name.to_owned() } else { format!("{name}[{}]", at + 1) }
}
