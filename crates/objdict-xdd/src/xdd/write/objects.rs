//! The object list.

use super::Writer;
use crate::literal::{self, Spelling};
use crate::model::{Access, DataType, Entry, Field, Object, ObjectList, ObjectType, Value};
use crate::xdd::read::{count, count_attribute};
use crate::xdd::schema::network::{OBJECT, OBJECT_LIST, SUB_OBJECT};
use crate::xdd::schema::{At, Attribute, Shape};
use crate::xdd::xdd_writer::XddWriter;
use crate::xdd::{defaults, fact};
use crate::xml::n;

/// The attribute that refers to the parameter of an entry. Among the unknown keys of an entry, it refers to
/// a parameter of others.
pub(super) const REFERENCE: &str = n::uniqueIDRef.text();

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
        let text = |attribute: &Attribute, at: &At<Entry>| match attribute.name {
            n::index => Some(format!("{index:04X}")),
            n::subIndex => Some(format!("{:02X}", sub.unwrap_or_default())),
            n::name => Some(entry.name.to_string()),
            n::objectType => fact::text(entry, attribute, at)
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
            n::dataType => fact::text(entry, attribute, at).or_else(|| unstated(entry, DOMAIN_TYPE)),
            n::accessType => {
                let stated = fact::text(entry, attribute, at).filter(|text| attribute.kind.accepts(text));
                stated.or_else(|| unstated(entry, Access::Rw.name()))
            }
            _ => match at {
                At::Value(place) => value_text(index, entry, place.get(entry), &place.field()),
                _ => fact::text(entry, attribute, at),
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

/// What an object of type DOMAIN has if it does not state it (CiA 306-1 §4.6.3.2).
fn unstated(entry: &Entry, text: &str) -> Option<String> {
    (entry.object_type == Some(ObjectType::Domain)).then(|| text.to_owned())
}

/// The text of a value, or the invalid text. CiA 311 knows no default of a DOMAIN.
pub(super) fn value_text(index: u16, entry: &Entry, value: Option<&Value>, field: &Field) -> Option<String> {
    let is_domain = entry.implied_type() == Some(DataType::DOMAIN);
    match value {
        _ if is_domain && *field == Field::DefaultValue => None,
        Some(value) => Some(print(index, entry.data_type, value)),
        None => entry.invalid_values.get(field).map(|invalid| invalid.text.to_string()),
    }
}

/// COB-IDs, mappings and other communication parameters are printed in hex, as in an EDS, and the bytes of an
/// OCTET_STRING with blanks between them, without which CANopenEditor reads only the first. XML preserves blanks, so a string needs quotes only if it is empty or contains quotes.
fn print(index: u16, data_type: Option<DataType>, value: &Value) -> String {
    match value {
        Value::Text(text) if !text.is_empty() && !is_quoted(text) => text.to_string(),
        Value::Bytes(bytes) if data_type == Some(DataType::OCTET_STRING) && !bytes.is_empty() => {
            let bytes: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
            bytes.join(" ")
        }
        _ => {
            let hex = (0x1000..=0x1FFF).contains(&index) && data_type == Some(DataType::UNSIGNED32);
            literal::print(value, Spelling { hex, ..Spelling::default() })
        }
    }
}

fn is_quoted(text: &str) -> bool {
    text.len() > 1 && text.starts_with('"') && text.ends_with('"')
}
