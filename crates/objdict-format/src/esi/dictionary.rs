//! `Dictionary`: units, data types, and the objects that refer to them.

use std::collections::HashMap;
use std::iter;

use super::{EsiDevice, line, number, text};
use objdict_model::diagnostic::{Text, say};
use objdict_model::literal::{self, Quirks};
use objdict_model::model::{
    Access, AllowedValues, DataType, Entry, Field, LANGUAGE, Object, ObjectType, Part, PdoMapping, Reason,
    Support, TypeKind, Unit, Value,
};
use objdict_xdd::xml::Element;

/// The types that CiA 301 calls differently, each with its name there.
const TYPES: &str = "BOOL=BOOLEAN BIT=BOOLEAN SINT=INTEGER8 INT=INTEGER16 INT24=INTEGER24 DINT=INTEGER32 INT40=INTEGER40 INT48=INTEGER48 \
    INT56=INTEGER56 LINT=INTEGER64 USINT=UNSIGNED8 BYTE=UNSIGNED8 UINT=UNSIGNED16 WORD=UNSIGNED16 UINT24=UNSIGNED24 UDINT=UNSIGNED32 \
    DWORD=UNSIGNED32 UINT40=UNSIGNED40 UINT48=UNSIGNED48 UINT56=UNSIGNED56 ULINT=UNSIGNED64 LWORD=UNSIGNED64 REAL=REAL32 LREAL=REAL64 \
    STRING=VISIBLE_STRING WSTRING=UNICODE_STRING";

/// The fields of values, and their elements.
const VALUES: [(Field, &[&str]); 3] = [
    (Field::DefaultValue, &["DefaultData", "DefaultValue", "DefaultString"]),
    (Field::LowLimit, &["MinData", "MinValue"]),
    (Field::HighLimit, &["MaxData", "MaxValue"]),
];

/// A dictionary during reading.
pub(super) struct EsiDictionary<'a, 'd> {
    types: HashMap<String, Element<'a>>,
    /// The symbols of units by their indexes.
    units: HashMap<String, String>,
    /// The reference to the dictionary, if it is in another file.
    named: Option<Element<'d>>,
    /// The remaining bytes for entries, because many objects can have the same type.
    room: u32,
    read: &'d mut EsiDevice,
}

/// An entry before its values are known.
struct TypedItem<'a> {
    sub: u8,
    /// Its name; `None` for an array, which has none.
    name: Option<String>,
    type_name: String,
    /// The item of the type, or the object itself.
    item: Element<'a>,
}

/// The items of a list.
fn list<'a>(of: Element<'a>, name: &str, item: &'static str) -> impl Iterator<Item = Element<'a>> {
    of.child(name).into_iter().flat_map(move |list| list.children_named(item))
}

impl<'a, 'd> EsiDictionary<'a, 'd> {
    /// Reads the objects of a dictionary.
    pub(super) fn read(dictionary: Element<'a>, named: Option<Element<'d>>, read: &'d mut EsiDevice) {
        let types = list(dictionary, "DataTypes", "DataType").map(|of| (text(of, "Name"), of)).collect();
        let units =
            list(dictionary, "UnitTypes", "UnitType").map(|of| (text(of, "Index"), text(of, "Symbol")));
        let room = dictionary.span().len().saturating_mul(64).saturating_add(1 << 23);
        let mut reader = Self { types, units: units.collect(), named, room, read };
        for object in list(dictionary, "Objects", "Object") {
            if reader.object(object).is_none() {
                reader.not_read(object, say!("this object and the following ones have too many entries"));
                break;
            }
        }
    }

    fn not_read(&mut self, element: Element<'_>, message: Text) {
        self.read.not_read(self.named.unwrap_or(element), message);
    }

    /// The definition of a type that has no name of ETG.2000.
    fn defined(&self, name: &str) -> Option<Element<'a>> {
        if type_of(name).is_none() { self.types.get(name).copied() } else { None }
    }

    /// The types from a name in the file to the base type of ETG.2000.
    fn bases(&self, name: &str) -> impl Iterator<Item = Element<'a>> {
        let next = |of: &Element<'a>| self.defined(&text(*of, "BaseType"));
        // maximum depth of type references
        iter::successors(self.defined(name), next).take(16)
    }

    /// A type without sub-indexes.
    fn single(&self, name: &str) -> Option<DataType> {
        let Some(last) = self.bases(name).last() else { return type_of(name) };
        let base = text(last, "BaseType");
        if !base.is_empty() {
            return type_of(&base);
        }
        let bits: usize = number(&text(last, "BitSize"))?;
        let unsigned = DataType::unsigned(bits.div_ceil(8)).unwrap_or(DataType::OCTET_STRING);
        Some(if bits == 1 { DataType::BOOLEAN } else { unsigned })
    }

    /// The names of values that the types define, the nearest one first.
    fn named_values(&self, type_name: &str) -> Option<AllowedValues> {
        let of = self.bases(type_name).find(|of| of.child("EnumInfo").is_some())?;
        let number = |of| text(of, "Enum").replacen("#x", "0x", 1);
        Some(AllowedValues::named(of.children_named("EnumInfo").map(|of| (number(of), text(of, "Text")))))
    }

    /// Reads an object; `None` if there is no memory left for its entries.
    fn object(&mut self, element: Element<'a>) -> Option<()> {
        let index: Option<u16> = number(&text(element, "Index")).filter(|index| *index > 0);
        let Some(index) = index.filter(|index| !self.read.device.objects.contains_key(index)) else {
            self.not_read(element, say!("an object has no index, or one that is already used"));
            return Some(());
        };
        let (name, type_name) = (text(element, "Name"), text(element, "Type"));
        let mut object = Object::default();
        let members = self.members(element, &type_name, &mut object);
        if members.is_empty() {
            let member = TypedItem { sub: 0, name: Some(name), type_name, item: element };
            object.main = self.entry(&member, element, element.child("Info"))?;
        } else {
            object.main.name = name.into();
            object.sub_number = members.iter().filter(|member| member.sub < 0xFF).count().try_into().ok();
        }
        // the object's information about each entry: by position if it covers all, otherwise by name
        let mut infos: Vec<_> =
            list(element, "Info", "SubItem").map(|info| (text(info, "Name"), info)).collect();
        let are_all = infos.len() == members.len();
        for member in &members {
            let is_of = |name: &str| member.name.as_ref().is_some_and(|own| own.eq_ignore_ascii_case(name));
            let at = infos.iter().position(|(name, _)| are_all || is_of(name));
            let info = at.map(|at| infos.remove(at));
            let mut entry =
                self.entry(member, element, info.as_ref().and_then(|(_, info)| info.child("Info")))?;
            match &info {
                Some((name, _)) if member.name.is_none() => entry.name = name.as_str().into(),
                Some((name, _)) if !is_of(name) => entry.extra.push("EtherCATName", name),
                _ => {}
            }
            object.subs.insert(member.sub, entry);
            let of = self.named.or(info.map(|(_, info)| info)).unwrap_or(member.item);
            self.read.places.insert(Part::Entry(index, member.sub), of.id());
        }
        for (name, info) in infos {
            self.not_read(info, say!("the object's type has no item `{}`", name));
        }
        self.read.places.insert(Part::Object(index), self.named.unwrap_or(element).id());
        self.read.device.objects.insert(index, object);
        Some(())
    }

    /// The entries of an object according to its type, as for an ARRAY or RECORD of CiA 301; empty for a
    /// single one.
    fn members(&mut self, of: Element<'a>, type_name: &str, object: &mut Object) -> Vec<TypedItem<'a>> {
        let items: Vec<Element<'a>> = match self.defined(type_name) {
            Some(record) if record.child("SubItem").is_some() => record.children_named("SubItem").collect(),
            Some(array) if array.child("ArrayInfo").is_some() => vec![of],
            _ => return Vec::new(),
        };
        let (mut members, mut next) = (Vec::new(), 0);
        for &item in &items {
            let of = self.defined(&text(item, "Type")).and_then(|of| Some((of, of.child("ArrayInfo")?)));
            let (type_name, first, count) = match of {
                Some((of, bounds)) => {
                    let bound = |name: &str| number::<u64>(&text(bounds, name)).unwrap_or(0);
                    (text(of, "BaseType"), bound("LBound").max(next).max(1), bound("Elements"))
                }
                None => (text(item, "Type"), next, 1),
            };
            let first = number(&text(item, "SubIdx")).unwrap_or(first);
            let end = first.saturating_add(count);
            if first < next || end > 256 {
                self.not_read(item, say!("sub-index {} is above 255, or out of order", first));
                continue;
            }
            next = end;
            let name = if of.is_some() { None } else { Some(text(item, "Name")) };
            let member =
                |sub| TypedItem { sub: sub as u8, name: name.clone(), type_name: type_name.clone(), item };
            members.extend((first..end).map(member));
        }
        let is_array = items.len() <= 2 && members.last().is_some_and(|last| last.name.is_none());
        object.main.object_type = Some(if is_array { ObjectType::Array } else { ObjectType::Record });
        members
    }

    /// An entry; `None` if there is no memory left for it.
    fn entry(&mut self, of: &TypedItem<'a>, object: Element<'a>, info: Option<Element<'a>>) -> Option<Entry> {
        let TypedItem { sub, item, type_name, name } = of;
        let data_type = self.single(type_name);
        let size = if item.id() == object.id() { 0 } else { item.span().len() };
        let named = self.named_values(type_name);
        let names = named.as_ref().map_or(0, |named| named.values.len() as u32);
        // the memory for an entry in addition to its strings, and the name of a value
        self.room =
            self.room.checked_sub(size.saturating_add(256).saturating_add(names.saturating_mul(128)))?;
        let name = name.clone().unwrap_or_else(|| format!("SubIndex {sub:03}")).into();
        let mut entry = Entry { name, object_type: Some(ObjectType::Var), data_type, ..Entry::default() };
        if data_type.is_none() {
            self.not_read(*item, say!("unknown data type `{}`", type_name.as_str()));
        }
        if type_of(type_name).is_none() || type_name.contains(['(', '[']) {
            entry.extra.push("EtherCATType", type_name);
        }
        flags(&mut entry, [item.child("Flags"), object.child("Flags")]);
        if named.is_some() {
            entry.parameter_mut().allowed_values = named;
        }
        let parts = || [info, Some(*item)].into_iter().flatten();
        for unit in parts().filter_map(|of| of.child("Unit")).map(line) {
            entry.parameter_mut().unit = Some(Unit::named(LANGUAGE, self.units.get(&unit).unwrap_or(&unit)));
        }
        for (field, names) in VALUES {
            let stated = parts().find_map(|of| names.iter().find_map(|name| of.child(*name)));
            let Some(stated) = stated else { continue };
            match (value(stated, data_type), &field) {
                (Err(reason), _) => entry.invalid_values.push(field, &line(stated), reason),
                (Ok(value), Field::DefaultValue) => entry.default = Some(value),
                (Ok(value), Field::LowLimit) => entry.low_limit = Some(value),
                (Ok(value), _) => entry.high_limit = Some(value),
            }
        }
        Some(entry)
    }
}

/// Access, mapping, necessity and storage from the flags of the item, otherwise of the object.
fn flags(entry: &mut Entry, flags: [Option<Element<'_>>; 2]) {
    let stated = |name: &str| {
        let of = flags.into_iter().flatten().find_map(|flags| flags.child(name));
        of.map(|of| line(of).to_ascii_lowercase()).unwrap_or_default()
    };
    let (access, mapping) = (stated("Access"), stated("PdoMapping"));
    match &*mapping {
        "" => entry.pdo_mapping = Some(PdoMapping::No),
        "r" => entry.pdo_mapping = Some(PdoMapping::Rpdo),
        "t" => entry.pdo_mapping = Some(PdoMapping::Tpdo),
        "rt" | "tr" => entry.pdo_mapping = Some(PdoMapping::Optional),
        word => entry.invalid_values.push(Field::PdoMapping, word, Reason::UnknownWord),
    }
    // the default is read-only; CiA 306 has keywords for both
    entry.access = match (&*access, entry.pdo_mapping) {
        ("", _) => Some(Access::Ro),
        ("rw", Some(PdoMapping::Tpdo)) => Some(Access::Rwr),
        ("rw", Some(PdoMapping::Rpdo)) => Some(Access::Rww),
        (word, _) => Access::from_name(word),
    };
    // most are optional and not stored, as without a word
    match &*stated("Category") {
        "m" => entry.parameter_mut().support = Some(Support::Mandatory),
        "c" => entry.parameter_mut().support = Some(Support::Conditional),
        _ => {}
    }
    if matches!(&*stated("Backup"), "1" | "true") {
        entry.parameter_mut().persistent = Some(true);
    }
    if entry.access.is_none() {
        entry.invalid_values.push(Field::AccessType, &access, Reason::UnknownWord);
    }
}

/// The type with a name of ETG.2000: `UDINT`, `STRING(16)`, `ARRAY [0..7] OF BYTE`.
fn type_of(name: &str) -> Option<DataType> {
    if name.starts_with("ARRAY") {
        let is_text = name.ends_with(" UINT");
        return Some(if is_text { DataType::UNICODE_STRING } else { DataType::OCTET_STRING });
    }
    let word = name.split('(').next().unwrap_or(name);
    let mut pairs = TYPES.split_ascii_whitespace().filter_map(|pair| pair.split_once('='));
    let known = pairs.find(|(known, _)| *known == word).map_or(word, |(_, name)| name);
    DataType::from_name(known).filter(|of| of.kind() != TypeKind::Structure)
}

/// The value of an element for a type: little-endian bytes, a number or a string.
fn value(element: Element<'_>, data_type: Option<DataType>) -> Result<Value, Reason> {
    let text = line(element);
    let read = |text: &str, data_type| literal::value(text, Some(data_type), &mut Quirks::default());
    let Some(data_type) = data_type else { return Ok(Value::Raw(text.into())) };
    if element.name().ends_with("Data") {
        let bytes = read(&text.replace(' ', ""), DataType::OCTET_STRING)?;
        let Value::Bytes(bytes) = bytes else { return Err(Reason::NotHexBytes) };
        return Ok(match Value::from_bytes(&bytes, data_type).ok_or(Reason::Malformed)? {
            // texts are filled up
            Value::Text(text) => Value::Text(text.trim_end_matches('\0').into()),
            value => value,
        });
    }
    if matches!(data_type, DataType::VISIBLE_STRING | DataType::UNICODE_STRING) {
        return Ok(Value::Text(element.text().into()));
    }
    // leading zeros do not make a number octal
    let decimal = text.parse::<i128>().map(|number| number.to_string());
    read(&decimal.unwrap_or_else(|_| text.replacen("#x", "0x", 1)), data_type)
}
