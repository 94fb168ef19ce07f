//! The object list.

use super::Writer;
use crate::literal::{self, Spelling};
use crate::model::{Access, DataType, Entry, Field, Object, ObjectList, PdoMapping, Value};
use crate::xdd::defaults;
use crate::xdd::markup::Markup;
use crate::xdd::read::{count, count_attribute};
use crate::xdd::version::XddVersion;

/// The attribute that names the parameter of an entry. Among the unknown keys of an entry it names one of others.
pub(super) const REFERENCE: &str = "uniqueIDRef";

/// An attribute that version 1.0 does not have.
const RANGE_SELECTOR: &str = "rangeSelector";

impl Writer<'_> {
    /// `CANopenObjectList`, with the number of objects of each kind.
    pub(super) fn object_list(&self, out: &mut Markup) {
        let objects = &self.device.objects;
        out.open("CANopenObjectList");
        for list in ObjectList::ALL {
            out.attribute(count_attribute(list), &count(objects.keys(), list).to_string());
        }
        for (&index, object) in objects {
            self.object(index, object, out);
        }
        out.close();
    }

    fn object(&self, index: u16, object: &Object, out: &mut Markup) {
        out.open("CANopenObject");
        out.attribute("index", &format!("{index:04X}"));
        let code = if object.orphan { defaults::ORPHAN } else { defaults::OBJECT_TYPE };
        self.entry(index, None, &object.main, code, out);
        let misfit = object.main.misfits.get(&Field::SubNumber).map(|misfit| misfit.text.to_string());
        if let Some(number) = object.sub_number.map(|number| number.to_string()).or(misfit) {
            out.attribute("subNumber", &number);
        }
        for (sub, entry) in object.subs.iter() {
            out.open("CANopenSubObject");
            out.attribute("subIndex", &format!("{sub:02X}"));
            self.entry(index, Some(sub), entry, defaults::OBJECT_TYPE, out);
            out.close();
        }
        out.close();
    }

    /// The attributes of an object or sub-object; `code` is the object type where none is stated.
    fn entry(&self, index: u16, sub: Option<u8>, entry: &Entry, code: &str, out: &mut Markup) {
        let misfit = |field: &Field| entry.misfits.get(field).map(|misfit| misfit.text.to_string());
        let value = |value: Option<&Value>, field: Field| value_text(index, entry, value, &field);
        let mut put = |name: &str, text: Option<String>| {
            if let Some(text) = text {
                out.attribute(name, &text);
            }
        };
        put("name", Some(entry.name.to_string()));
        let object_type = entry.object_type.map(|object_type| object_type.code().to_string());
        let object_type = object_type.or_else(|| misfit(&Field::ObjectType));
        put("objectType", Some(object_type.unwrap_or_else(|| code.to_owned())));
        let data_type = entry.data_type.map(|data_type| format!("{:04X}", data_type.0));
        // what is no data type stands there, though the parameter may tell the type
        put("dataType", misfit(&Field::DataType).or(data_type));
        put("lowLimit", value(entry.low_limit.as_ref(), Field::LowLimit));
        put("highLimit", value(entry.high_limit.as_ref(), Field::HighLimit));
        let access = entry.access.map(|access| attribute_access(access).to_owned());
        put("accessType", access.or_else(|| misfit(&Field::AccessType)));
        put("defaultValue", value(entry.default.as_ref(), Field::DefaultValue));
        put("actualValue", value(entry.configured_value(), Field::ParameterValue));
        let denotation = entry.configured.as_ref().and_then(|configured| configured.denotation.as_deref());
        put("denotation", denotation.map(str::to_owned));
        let mapping = entry.pdo_mapping.map(|mapping| mapping_word(mapping).to_owned());
        put("PDOmapping", mapping.or_else(|| misfit(&Field::PdoMapping)));
        let flags = entry.flags.map(|flags| match flags.0 {
            flags @ 0..=0xFFFF => format!("{flags:04X}"),
            flags => format!("{flags:08X}"),
        });
        put("objFlags", flags.or_else(|| misfit(&Field::ObjFlags)));
        let reference = entry.extra.get(REFERENCE).or_else(|| self.parameters.id(index, sub));
        put(REFERENCE, reference.map(str::to_owned));
        if out.version() == XddVersion::V1_1
            && let Some(selector) = entry.extra.get(RANGE_SELECTOR)
        {
            out.attribute(RANGE_SELECTOR, selector);
        }
    }
}

/// The text of a value, or the one that is none.
pub(super) fn value_text(index: u16, entry: &Entry, value: Option<&Value>, field: &Field) -> Option<String> {
    match value {
        Some(value) => Some(print(index, entry.data_type, value)),
        None => entry.misfits.get(field).map(|misfit| misfit.text.to_string()),
    }
}

/// Identifiers, mappings and other communication parameters are read in hex, as in an EDS. Strings need quotes only where
/// there would be nothing without, or where they have some of their own: XML keeps blanks.
fn print(index: u16, data_type: Option<DataType>, value: &Value) -> String {
    match value {
        Value::Text(text) if !text.is_empty() && !is_quoted(text) => text.to_string(),
        _ => {
            let hex = (0x1000..=0x1FFF).contains(&index) && data_type == Some(DataType::UNSIGNED32);
            literal::print(value, Spelling { hex, ..Spelling::default() })
        }
    }
}

fn is_quoted(text: &str) -> bool {
    text.len() > 1 && text.starts_with('"') && text.ends_with('"')
}

/// The access type of an attribute, which knows nothing of process inputs and outputs; the parameter does.
const fn attribute_access(access: Access) -> &'static str {
    match access {
        Access::Rwr | Access::Rww => Access::Rw.name(),
        access => access.name(),
    }
}

const fn mapping_word(mapping: PdoMapping) -> &'static str {
    match mapping {
        PdoMapping::No => "no",
        PdoMapping::Default => "default",
        PdoMapping::Optional => "optional",
        PdoMapping::Tpdo => "TPDO",
        PdoMapping::Rpdo => "RPDO",
    }
}
