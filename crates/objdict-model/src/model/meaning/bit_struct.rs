//! Words that consist of bit fields.

use super::{Enumeration, Meanings, Scaling, enumeration::name_in, number};
use crate::model::{DataType, DataTypeRef, SimpleType, TypeDefinition, TypeShape, VarDeclaration};

/// A word that a struct divides into bit fields.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BitStruct<'a> {
    /// The struct.
    pub definition: &'a TypeDefinition,
    /// The data type of the word: INTEGERn or UNSIGNEDn.
    pub data_type: DataType,
    /// The bit fields, in the order of the description; they may overlap.
    pub fields: Vec<BitField<'a>>,
    /// Members that are not bit fields: lower case, offending text in backticks, no full stop.
    pub defects: Vec<String>,
}

/// A bit field of a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BitField<'a> {
    /// The name of the member.
    pub name: &'a str,
    /// The lowest bit.
    pub first: u8,
    /// The number of bits, at least 1.
    pub bits: u8,
    /// Whether the highest bit is a sign.
    pub is_signed: bool,
    /// The names of its values, if the description defines them.
    pub values: Option<Enumeration<'a>>,
    /// How its engineering value is calculated from its bits.
    pub scaling: Scaling<'a>,
}

impl BitField<'_> {
    /// The bits of the field in the word.
    pub const fn mask(&self) -> u64 {
        (u64::MAX >> (64 - self.bits)) << self.first
    }

    /// The smallest type of 8, 16, 32 or 64 bits for its values; BOOLEAN for one bit.
    pub fn data_type(&self) -> DataType {
        holding(self.bits, self.is_signed)
    }
}

/// The first bit and length of a member.
struct MemberForm {
    bits: i128,
    is_signed: bool,
}

impl<'a> BitStruct<'a> {
    /// The bit fields of a word. A member without a first bit follows the previous one.
    pub(super) fn new(
        meanings: &Meanings<'a>,
        definition: &'a TypeDefinition,
        members: &'a [VarDeclaration],
        data_type: DataType,
    ) -> Self {
        let mut found = Self { definition, data_type, fields: Vec::new(), defects: Vec::new() };
        let length = i128::from(data_type.bit_length().unwrap_or(0));
        let mut next = Some(0);
        for member in members {
            let own = name_in(&member.labels, meanings.language);
            let name = if member.name.is_empty() { own } else { &*member.name };
            let first = match member.start.as_deref() {
                Some(start) => number(start).filter(|start| (0..64).contains(start)),
                None => next,
            };
            let form = meanings.form(member);
            next = first.zip(form.as_ref().ok()).map(|(first, form)| first + form.bits);
            match (first, form) {
                (Some(first), Ok(form)) if first + form.bits <= length => {
                    found.fields.push(meanings.field(member, name, first as u8, &form)); // both are less than 64
                }
                (Some(first), Ok(MemberForm { bits, .. })) => found.defects.push(format!(
                    "the member `{name}` ends at bit {}, but a value of {data_type} at bit {}",
                    first + bits - 1,
                    length - 1
                )),
                (None, _) => {
                    found.defects.push(format!("the member `{name}` has no start bit"));
                }
                (_, Err(why)) => {
                    found.defects.push(format!("the member `{name}` is not part of a word: {why}"));
                }
            }
        }
        found
    }
}

impl<'a> Meanings<'a> {
    fn field(&self, member: &'a VarDeclaration, name: &'a str, first: u8, form: &MemberForm) -> BitField<'a> {
        let bits = form.bits as u8; // at most 64, because the field ends within the word
        let definition = member.data_type.as_ref().and_then(|reference| self.definition(reference));
        let data_type = holding(bits, form.is_signed);
        let values = match definition.map(|definition| (definition, &definition.shape)) {
            Some((definition, TypeShape::Enum { values, .. })) if !values.is_empty() => {
                Some(Enumeration::of_type(definition, values, data_type, self.language))
            }
            _ => member.allowed_values.as_ref().and_then(|allowed| {
                Enumeration::of_allowed(self.definitions.allowed(allowed), data_type, self.language)
            }),
        };
        BitField {
            name,
            first,
            bits,
            is_signed: form.is_signed,
            values: values.map(|values| values.within(bits)),
            scaling: Scaling::of_variable(member),
        }
    }

    /// The number of bits of a member.
    fn form(&self, member: &VarDeclaration) -> Result<MemberForm, String> {
        let simple = match member.data_type.as_ref() {
            Some(DataTypeRef::Simple(simple)) => Some(*simple),
            // the member defines the number of bits of an enumeration without a type
            Some(reference) => match self.definitions.simple(reference, Some(SimpleType::Bitstring)) {
                Some(simple) => Some(simple),
                None => return Err("its type is not a simple type".to_owned()),
            },
            None => None,
        };
        let size = match member.size.as_deref() {
            None => 1,
            Some(text) => number(text)
                .filter(|size| (1..=64).contains(size))
                .ok_or_else(|| format!("`{text}` is not a number of bits"))?,
        };
        let is_signed = member.signed == Some(true);
        let (bits, of_type) = match simple {
            None => return Err("it has no type".to_owned()),
            Some(SimpleType::Bool | SimpleType::Bitstring) => (1, is_signed && size > 1),
            Some(SimpleType::Sint) => (8, true),
            Some(SimpleType::Byte | SimpleType::Char | SimpleType::Usint) => (8, is_signed),
            Some(SimpleType::Int) => (16, true),
            Some(SimpleType::Word | SimpleType::Uint) => (16, is_signed),
            Some(SimpleType::Dint) => (32, true),
            Some(SimpleType::Dword | SimpleType::Udint) => (32, is_signed),
            Some(SimpleType::Lint) => (64, true),
            Some(SimpleType::Lword | SimpleType::Ulint) => (64, is_signed),
            Some(simple) => return Err(format!("values of {} are not bits", simple.name())),
        };
        if bits > 1 && size > 1 {
            return Err("it is an array".to_owned());
        }
        Ok(MemberForm { bits: bits * size, is_signed: of_type })
    }
}

impl Enumeration<'_> {
    /// Removes the values that do not fit into this number of bits.
    fn within(mut self, bits: u8) -> Self {
        let is_signed = matches!(self.data_type.kind(), crate::model::TypeKind::Signed(_));
        let (low, high) =
            if is_signed { (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) } else { (0, (1_i128 << bits) - 1) };
        let defects = &mut self.defects;
        self.values.retain(|value| {
            let fits = (low..=high).contains(&value.number);
            if !fits {
                defects.push(format!("`{}` of `{}` does not fit into {bits} bits", value.number, value.name));
            }
            fits
        });
        self
    }
}

/// The smallest type of 8, 16, 32 or 64 bits for a bit field; BOOLEAN for one bit.
fn holding(bits: u8, is_signed: bool) -> DataType {
    match (bits, is_signed) {
        (..=1, _) => DataType::BOOLEAN,
        (..=8, false) => DataType::UNSIGNED8,
        (..=16, false) => DataType::UNSIGNED16,
        (..=32, false) => DataType::UNSIGNED32,
        (_, false) => DataType::UNSIGNED64,
        (..=8, true) => DataType::INTEGER8,
        (..=16, true) => DataType::INTEGER16,
        (..=32, true) => DataType::INTEGER32,
        (_, true) => DataType::INTEGER64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Device;

    fn member(name: &str, simple: SimpleType) -> VarDeclaration {
        VarDeclaration {
            name: name.into(),
            data_type: Some(DataTypeRef::Simple(simple)),
            ..VarDeclaration::default()
        }
    }

    #[test]
    fn members_follow_each_other_or_say_where_they_begin() {
        let at = |member: VarDeclaration, start: &str, size: &str| VarDeclaration {
            start: Some(start.into()),
            size: Some(size.into()),
            ..member
        };
        let members = [
            member("ready", SimpleType::Bool),
            VarDeclaration { size: Some("3".into()), ..member("mode", SimpleType::Bitstring) },
            at(member("level", SimpleType::Bitstring), "8", "4"),
            member("last", SimpleType::Bitstring),
            member("text", SimpleType::String),
            member("lost", SimpleType::Bool),
            at(member("long", SimpleType::Byte), "12", "1"),
        ];
        let device = Device::default();
        let definition = TypeDefinition::default();
        let found = BitStruct::new(&device.meanings(), &definition, &members, DataType::UNSIGNED16);
        let places: Vec<_> = found.fields.iter().map(|field| (field.name, field.first, field.bits)).collect();
        assert_eq!(places, [("ready", 0, 1), ("mode", 1, 3), ("level", 8, 4), ("last", 12, 1)]);
        assert_eq!(found.fields[2].mask(), 0x0F00);
        assert_eq!(
            found.defects,
            [
                "the member `text` is not part of a word: values of STRING are not bits",
                "the member `lost` has no start bit",
                "the member `long` ends at bit 19, but a value of UNSIGNED16 at bit 15",
            ]
        );
    }
}
