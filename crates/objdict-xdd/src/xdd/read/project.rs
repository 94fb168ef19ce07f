//! Projects of CANopenNode editors from before XDD: an element `device`, whose objects have the attributes
//! of CiA 311 and some for the stack. The object reader supports both.

use std::borrow::Cow;

use super::XddReader;
use crate::model::{Commissioning, DataType, DummyUsage, Field, Label, Labels};
use crate::xdd::defaults::{self, Placeholders};
use crate::xdd::fact::{PlacedText, boolean};
use crate::xdd::layout::below;
use crate::xdd::schema::container::DEVICE_BODY;
use crate::xdd::shape::facts;
use crate::xml::{Attribute, Element, n};

impl<'a> XddReader<'a> {
    /// Everything except the objects.
    pub(super) fn project(&mut self, device: Element<'a>) {
        for object in self.device.objects.values_mut() {
            // one of the editors also counts the sub-indexes of a variable
            object.sub_number = object.sub_number.filter(|&number| number > 0 || !object.subs.is_empty());
            // the editors state the properties of elements at their ARRAY or RECORD
            if object.object_type().has_subs() {
                let main = &mut object.main;
                (main.data_type, main.access, main.pdo_mapping) = (None, None, None);
            }
        }
        for element in device.children() {
            match element.name() {
                "other" => element.children().for_each(|child| self.project_part(child)),
                "CANopenObjectList" => {}
                _ => self.leftovers.element(element),
            }
        }
    }

    fn project_part(&mut self, element: Element<'a>) {
        match element.name() {
            "file" => element.attributes().for_each(|attribute| self.project_file(element, attribute)),
            "DeviceIdentity" => element.children().for_each(|child| self.project_identity(child)),
            "baudRate" => self.bit_rates(vec![element]),
            "dummyUsage" => self.project_dummies(element),
            "capabilities" => {
                let lists = element.children().flat_map(Element::children);
                lists.for_each(|characteristic| self.project_capability(characteristic));
            }
            _ => self.leftovers.element(element),
        }
    }

    fn project_file(&mut self, element: Element<'a>, attribute: Attribute<'a>) {
        let text = PlacedText::of(attribute);
        if text.trimmed().is_empty() {
            return;
        }
        let info = self.device.file_info.get_or_insert_default();
        let name = match attribute.name() {
            // the editor misspells these
            "fileModifedBy" => n::fileModifiedBy,
            "fileMotifcationDate" => n::fileModificationDate,
            "fileRevision" => {
                match text.integer(255, &mut self.findings) {
                    Ok(number) => info.file_revision = number.or(info.file_revision),
                    Err(reason) => info.invalid_values.push(Field::FileRevision, &text.text, reason),
                }
                return;
            }
            _ => attribute.tag(),
        };
        if !facts::take(info, &DEVICE_BODY, name, &text, Placeholders::Dropped, &mut self.findings) {
            self.leftovers.attribute(element, attribute);
        }
    }

    fn project_identity(&mut self, element: Element<'a>) {
        let text = PlacedText::in_element(element);
        let word = text.trimmed();
        if word.is_empty() && element.children().next().is_none() {
            return;
        }
        let mut number = |field: Field, most: u64| {
            let read = text.integer::<u32>(most, &mut self.findings);
            let info = self.device.device_info.get_or_insert_default();
            read.unwrap_or_else(|reason| {
                info.invalid_values.push(field, word, reason);
                None
            })
        };
        match element.name() {
            "vendorName" => self.info().vendor_name = Some(word.to_owned()),
            "productName" => self.info().product_name = Some(word.to_owned()),
            "vendorNumber" => {
                let vendor = number(Field::VendorNumber, u32::MAX.into());
                self.info().vendor_number = vendor;
            }
            "productNumber" => {
                let product = number(Field::ProductNumber, u32::MAX.into());
                self.info().product_number = product;
            }
            "concreteNoideId" => {
                let node_id = number(Field::NodeId, 127).and_then(|id| u8::try_from(id).ok());
                self.device.commissioning = Some(Commissioning { node_id, ..Commissioning::default() });
            }
            "productText" => self.project_description(element),
            _ => self.leftovers.element(element),
        }
    }

    fn project_description(&mut self, element: Element<'a>) {
        for child in element.children() {
            let text = PlacedText::in_element(child);
            match child.tag() {
                _ if text.text.is_empty() => {}
                n::description => {
                    let info = self.device.file_info.get_or_insert_default();
                    info.description = Some(text.text.into_owned());
                }
                _ => self.leftovers.element(child),
            }
        }
    }

    /// `Dummy0005=1`, or only `True` at the position of the data type.
    fn project_dummies(&mut self, element: Element<'a>) {
        let entries = element.children_named(n::dummy).filter_map(|dummy| dummy.attribute(n::entry));
        let flags: Option<Vec<bool>> = entries.map(|entry| boolean(entry.value().trim_ascii())).collect();
        match flags {
            Some(flags) => {
                let types = (1..).map(DataType).zip(flags).collect();
                self.device.dummy_usage = Some(DummyUsage { types, ..DummyUsage::default() });
            }
            None => self.dummy_usage(element),
        }
    }

    /// A key of `[DeviceInfo]` with its value, as two labels.
    fn project_capability(&mut self, characteristic: Element<'a>) {
        let label = |name| below(characteristic, &[name, n::label]).map(PlacedText::in_element);
        let Some(name) = label(n::characteristicName).filter(|name| !name.text.is_empty()) else { return };
        let content = label(n::characteristicContent);
        let word = content.as_ref().map_or("", |content| content.trimmed());
        let info = self.device.device_info.get_or_insert_default();
        let (flag, number) = (boolean(word), word.parse().ok());
        let is_read = match name.trimmed() {
            "SimpleBootUpSlave" => set(&mut info.simple_boot_up_slave, flag),
            "SimpleBootUpMaster" => set(&mut info.simple_boot_up_master, flag),
            "GroupMessaging" => set(&mut info.group_messaging, flag),
            "LSS_Supported" => set(&mut info.lss_supported, flag),
            "LSS_Master" => set(&mut info.lss_master, flag),
            "DynamicChannelsSupported" => {
                set(&mut info.dynamic_channels_supported, number.or(flag.map(u8::from)))
            }
            "CompactPDO" => set(&mut info.compact_pdo, number),
            "Granularity" => set(&mut info.granularity, number),
            _ => false,
        };
        if !is_read {
            self.leftovers.element(characteristic);
        }
    }
}

/// Sets a field; `false` if the value is missing.
fn set<T>(field: &mut Option<T>, value: Option<T>) -> bool {
    let is_set = value.is_some();
    *field = value.or(field.take());
    is_set
}

/// A text of a project object; `None` for any other element.
pub(super) fn label(element: Element<'_>) -> Option<Label> {
    let lang = element.attribute(n::lang).map_or(Cow::Borrowed(defaults::LANGUAGE), Attribute::value);
    let (lang, text) = (lang.as_ref().into(), PlacedText::in_element(element).text.as_ref().into());
    match element.tag() {
        n::label => Some(Label::Name { lang, text }),
        n::description => {
            let uri = element.attribute(n::URI).map(|uri| uri.value().as_ref().into());
            Some(Label::Description { lang, text, uri })
        }
        _ => None,
    }
}

/// The labels that are not empty.
pub(super) fn labels(labels: Vec<Label>) -> Labels {
    let says = |label: &Label| match label {
        Label::Name { text, .. } | Label::Description { text, .. } => !text.is_empty(),
        Label::NameRef(_) | Label::DescriptionRef(_) => true,
    };
    Labels(labels.into_iter().filter(says).collect())
}
