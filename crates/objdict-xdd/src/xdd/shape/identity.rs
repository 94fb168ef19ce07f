//! The vendor and the names of the device: `DeviceIdentity` of the device profile, `identity` of the network
//! profile.

use crate::model::{Date, DeviceIdentity, DeviceVersion, Labels};
use crate::xml::{Name, n};

/// The complete content of the element.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Identity {
    pub(crate) vendor_name: Option<MarkedText>,
    /// As written.
    pub(crate) vendor_id: Option<MarkedText>,
    pub(crate) vendor_text: Option<MarkedLabels>,
    pub(crate) device_family: Option<MarkedLabels>,
    pub(crate) product_family: Option<MarkedText>,
    pub(crate) product_name: Option<MarkedText>,
    /// As written.
    pub(crate) product_id: Option<MarkedText>,
    pub(crate) product_text: Option<MarkedLabels>,
    pub(crate) order_numbers: Vec<MarkedText>,
    pub(crate) versions: Vec<MarkedVersion>,
    pub(crate) build_date: Option<Date>,
    pub(crate) specification_revision: Option<MarkedText>,
    pub(crate) instance_name: Option<MarkedText>,
}

/// An element with an optional `readOnly` attribute.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Marked<T> {
    pub(crate) read_only: Option<bool>,
    pub(crate) value: T,
}

pub(crate) type MarkedText = Marked<Box<str>>;
pub(crate) type MarkedLabels = Marked<Labels>;
pub(crate) type MarkedVersion = Marked<DeviceVersion>;

impl<T> From<T> for Marked<T> {
    fn from(value: T) -> Self {
        Self { read_only: None, value }
    }
}

/// Without the fields that an EDS has.
impl From<DeviceIdentity> for Identity {
    fn from(rest: DeviceIdentity) -> Self {
        let labels = |labels: Labels| Some(labels).filter(|labels| !labels.is_empty()).map(Marked::from);
        Self {
            vendor_text: labels(rest.vendor_text),
            device_family: labels(rest.device_family),
            product_family: rest.product_family.map(Marked::from),
            product_text: labels(rest.product_text),
            versions: rest.versions.into_iter().map(Marked::from).collect(),
            build_date: rest.build_date,
            specification_revision: rest.specification_revision.map(Marked::from),
            instance_name: rest.instance_name.map(Marked::from),
            ..Self::default()
        }
    }
}

impl Identity {
    /// The `readOnly` mark of each element in order, with its name; the second element of a name is
    /// `orderNumber[2]`.
    fn marks(&mut self) -> impl Iterator<Item = (String, &mut Option<bool>)> {
        fn marks<'a, T: 'a>(
            name: Name,
            elements: impl IntoIterator<Item = &'a mut Marked<T>>,
        ) -> Vec<(String, &'a mut Option<bool>)> {
            let name = |number: usize| match number {
                1 => name.text().to_owned(),
                _ => format!("{}[{number}]", name.text()),
            };
            (1..).zip(elements).map(|(number, element)| (name(number), &mut element.read_only)).collect()
        }
        [
            marks(n::vendorName, &mut self.vendor_name),
            marks(n::vendorID, &mut self.vendor_id),
            marks(n::vendorText, &mut self.vendor_text),
            marks(n::deviceFamily, &mut self.device_family),
            marks(n::productFamily, &mut self.product_family),
            marks(n::productName, &mut self.product_name),
            marks(n::productID, &mut self.product_id),
            marks(n::productText, &mut self.product_text),
            marks(n::orderNumber, &mut self.order_numbers),
            marks(n::version, &mut self.versions),
            marks(n::specificationRevision, &mut self.specification_revision),
            marks(n::instanceName, &mut self.instance_name),
        ]
        .into_iter()
        .flatten()
    }

    /// The elements with a `readOnly` attribute, as the model lists them.
    pub(crate) fn read_only(&mut self) -> Vec<(Box<str>, bool)> {
        self.marks().filter_map(|(name, mark)| Some((name.into(), (*mark)?))).collect()
    }

    /// Marks the listed elements. Labels that do not exist are created for their mark.
    pub(crate) fn mark(&mut self, read_only: &[(Box<str>, bool)]) {
        let labels = [&mut self.vendor_text, &mut self.device_family, &mut self.product_text];
        labels.into_iter().for_each(|labels| *labels = Some(labels.take().unwrap_or_default()));
        for (name, mark) in self.marks() {
            *mark = read_only.iter().rev().find(|(listed, _)| **listed == *name).map(|(_, mark)| *mark);
        }
        let labels = [&mut self.vendor_text, &mut self.device_family, &mut self.product_text];
        labels
            .into_iter()
            .for_each(|labels| *labels = labels.take().filter(|labels| *labels != Marked::default()));
    }
}
