//! The object list.

use super::Writer;
use super::parameters::{REFERENCE, print_value};
use crate::model::{Access, Entry, Field, Object, ObjectList, ObjectType};
use crate::xdd::defaults::{self, count, count_attribute};
use crate::xdd::schema::network::{OBJECT, OBJECT_LIST, SUB_OBJECT};
use crate::xdd::schema::{AttributePlace, SchemaAttribute, Shape};
use crate::xdd::shape::facts;
use crate::xdd::xdd_writer::XddWriter;
use crate::xml::n;

impl Writer<'_> {
    /// `CANopenObjectList`, with the number of objects of each kind.
    pub(super) fn object_list(&self, out: &mut XddWriter) {
        let objects = &self.device.objects;
        out.open(&OBJECT_LIST);
        for list in ObjectList::ALL {
            out.attribute(count_attribute(list), &count(objects.keys(), list).to_string());
        }
        if objects.is_empty() {
            out.empty(&OBJECT, &[(n::index, defaults::INDEX), (n::name, defaults::NOT_STATED)]);
        }
        for (&index, object) in objects {
            let object = &*object.expanded();
            out.open(&OBJECT);
            self.entry(&OBJECT, (index, None), &object.main, Some(object), out);
            for (sub, entry) in object.subs.iter() {
                out.open(&SUB_OBJECT);
                self.entry(&SUB_OBJECT, (index, Some(sub)), entry, None, out);
                out.close();
            }
            out.close();
        }
        out.close();
    }

    /// The attributes of an object or a sub-object.
    fn entry(
        &self,
        shape: &'static Shape<Entry>,
        (index, sub): (u16, Option<u8>),
        entry: &Entry,
        object: Option<&Object>,
        out: &mut XddWriter,
    ) {
        let invalid = |field: &Field| entry.invalid_values.get(field).map(|invalid| invalid.text.to_string());
        let text = |attribute: &SchemaAttribute, at: &AttributePlace<Entry>| match attribute.name {
            n::index => Some(format!("{index:04X}")),
            n::subIndex => Some(format!("{:02X}", sub.unwrap_or_default())),
            n::name => Some(entry.name.to_string()),
            n::objectType => facts::text(entry, attribute, at)
                .or_else(|| object?.orphan.then(|| defaults::ORPHAN.to_owned())),
            n::denotation => entry.configured.as_ref()?.denotation.as_deref().map(str::to_owned),
            n::uniqueIDRef => {
                let reference = entry.extra.get(REFERENCE).or_else(|| self.parameters.id(index, sub));
                reference.map(str::to_owned)
            }
            n::rangeSelector => entry.extra.get(attribute.name.text()).map(str::to_owned),
            n::subNumber => {
                let number = object?.sub_number.map(|number| number.to_string());
                number.or_else(|| invalid(&Field::SubNumber))
            }
            n::dataType => facts::text(entry, attribute, at).or_else(|| unstated(entry, DOMAIN_TYPE)),
            n::accessType => {
                let stated = facts::text(entry, attribute, at).filter(|text| attribute.kind.accepts(text));
                stated.or_else(|| unstated(entry, Access::Rw.name()))
            }
            _ => match at {
                AttributePlace::Value(place) => print_value(index, entry, place.get(entry), &place.field()),
                _ => facts::text(entry, attribute, at),
            },
        };
        for (attribute, at) in shape.attributes.iter().zip(shape.values) {
            if let Some(text) = text(attribute, at) {
                out.attribute(attribute.name, &text);
            }
        }
    }
}

/// DOMAIN as `dataType`.
const DOMAIN_TYPE: &str = "000F";

/// The implied property of an object of type DOMAIN (CiA 306-1 §4.6.3.2).
fn unstated(entry: &Entry, text: &str) -> Option<String> {
    (entry.object_type == Some(ObjectType::Domain)).then(|| text.to_owned())
}
