//! Sizes of types and variables in C on the reference processor, and their total per object.
//!
//! The processor is a 32-bit one such as a Cortex-M with the compiler arm-none-eabi-gcc: pointers have 4
//! bytes, numbers are aligned to their size (at most 8 bytes), and an enumeration has the smallest type for
//! its values. A variable with a non-zero initial value needs the same size in flash, from which the start-up
//! code copies it.

use super::dictionary::TableDictionary;
use super::resolve::{ValueShape, is_time};
use super::size::{ObjectSize, Size, SizeReport, Sizes};

/// Size and alignment of a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TypeExtent {
    /// Bytes.
    pub(crate) size: usize,
    /// Alignment in bytes.
    pub(crate) alignment: usize,
}

impl TypeExtent {
    pub(crate) const BYTE: Self = Self::number(1);
    pub(crate) const HALF: Self = Self::number(2);
    pub(crate) const WORD: Self = Self::number(4);
    pub(crate) const POINTER: Self = Self::number(4);
    /// The structure for TIME_OF_DAY and TIME_DIFFERENCE.
    pub(crate) const TIME: Self = Self { size: 8, alignment: 4 };

    /// A value of the tables for Rust and C.
    pub(crate) fn of(shape: ValueShape) -> Self {
        match shape {
            ValueShape::Block(length) => Self::BYTE.times(length.into()),
            ValueShape::Bytes(_, room) => Self::behind_length(room.into()),
            ValueShape::Word(data_type) if is_time(data_type) => Self::TIME,
            ValueShape::Word(_) => Self::number(shape.size().next_power_of_two()),
        }
    }

    /// A number of 1, 2, 4 or 8 bytes.
    pub(crate) const fn number(size: usize) -> Self {
        Self { size, alignment: size }
    }

    /// A number type of C: `uint16_t`, `float`, `char`.
    pub(crate) fn of_c(c_type: &str) -> Self {
        let size = match c_type.trim_start_matches("const ") {
            "float" => 4,
            "double" => 8,
            "bool_t" => 4, // a CANopenNode type based on `uint_fast8_t`, which is a word in arm-none-eabi-gcc
            _ => c_type.chars().filter(char::is_ascii_digit).collect::<String>().parse().unwrap_or(8) / 8,
        };
        Self::number(size)
    }

    /// An array with this number of elements.
    pub(crate) fn times(self, count: usize) -> Self {
        Self { size: self.size * count, ..self }
    }

    /// A structure with these members.
    pub(crate) fn structure(members: impl IntoIterator<Item = Self>) -> Self {
        let begin = Self { size: 0, alignment: 1 };
        let all = members.into_iter().fold(begin, |so_far, member| Self {
            size: so_far.size.next_multiple_of(member.alignment) + member.size,
            alignment: so_far.alignment.max(member.alignment),
        });
        Self { size: all.size.next_multiple_of(all.alignment), ..all }
    }

    /// A string, octet string or DOMAIN preceded by a 16-bit length.
    pub(crate) fn behind_length(room: usize) -> Self {
        Self::structure([Self::HALF, Self::BYTE.times(room)])
    }
}

/// The memory of a variable.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Memory {
    Flash,
    /// Zero-initialised RAM.
    Zeroed,
    /// RAM, and flash for its initial values.
    Initialised,
}

impl Memory {
    /// The RAM section for initial values, which may all be zero.
    pub(crate) fn of_values(are_zero: bool) -> Self {
        if are_zero { Self::Zeroed } else { Self::Initialised }
    }
}

/// Totals of the sizes per object.
pub(crate) struct SizeTally {
    objects: Vec<ObjectSize>,
    rest: Size,
}

impl SizeTally {
    /// Starts with objects in ascending order: index, name and number of entries.
    pub(crate) fn new<'a>(objects: impl IntoIterator<Item = (u16, &'a str, usize)>) -> Self {
        let objects = objects.into_iter().map(|(index, name, entries)| ObjectSize {
            index,
            name: name.to_owned(),
            entries,
            size: Size::default(),
        });
        Self { objects: objects.collect(), rest: Size::default() }
    }

    /// Starts with the objects of a dictionary.
    pub(crate) fn of_dictionary(dictionary: &TableDictionary<'_>) -> Self {
        let objects = dictionary.objects.iter();
        Self::new(objects.map(|object| (object.index, object.object.name(), object.entries.len())))
    }

    /// Adds bytes of an object.
    pub(crate) fn of(&mut self, index: u16, memory: Memory, bytes: usize) {
        let at = self.objects.binary_search_by_key(&index, |object| object.index).ok();
        let size =
            at.and_then(|at| self.objects.get_mut(at)).map_or(&mut self.rest, |object| &mut object.size);
        add(size, memory, bytes);
    }

    /// Adds bytes without an object.
    pub(crate) fn rest(&mut self, memory: Memory, bytes: usize) {
        add(&mut self.rest, memory, bytes);
    }

    /// Adds a structure: its members belong to their objects; padding and members without an object belong to
    /// the rest.
    pub(crate) fn structure(&mut self, memory: Memory, members: &[(Option<u16>, TypeExtent)]) {
        let whole = TypeExtent::structure(members.iter().map(|&(_, extent)| extent)).size;
        let mut gaps = whole;
        for &(index, extent) in members {
            if let Some(index) = index {
                gaps -= extent.size;
                self.of(index, memory, extent.size);
            }
        }
        self.rest(memory, gaps);
    }

    /// The totals. For `counted` see [`SizeReport::counted`].
    pub(crate) fn report(self, counted: &'static str) -> Sizes {
        Sizes::Known(self.sums(counted))
    }

    /// Like `report`, for adding content that belongs to no object.
    pub(crate) fn sums(self, counted: &'static str) -> SizeReport {
        SizeReport::new(counted, self.objects, self.rest)
    }
}

fn add(size: &mut Size, memory: Memory, bytes: usize) {
    size.flash += if memory == Memory::Zeroed { 0 } else { bytes };
    size.ram += if memory == Memory::Flash { 0 } else { bytes };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_of_c() {
        let sizes =
            ["uint8_t", "int16_t", "float32_t", "double", "int64_t"].map(|name| TypeExtent::of_c(name).size);
        assert_eq!(sizes, [1, 2, 4, 8, 8]);
        let row = TypeExtent::structure([
            TypeExtent::HALF,
            TypeExtent::BYTE,
            TypeExtent::POINTER,
            TypeExtent::BYTE,
        ]);
        assert_eq!(row, TypeExtent { size: 12, alignment: 4 });
        assert_eq!(TypeExtent::behind_length(3).size, 6);
    }

    #[test]
    fn gaps_belong_to_no_object() {
        let mut tally = SizeTally { objects: Vec::new(), rest: Size::default() };
        tally.structure(Memory::Initialised, &[(Some(0x2000), TypeExtent::BYTE), (None, TypeExtent::WORD)]);
        tally.rest(Memory::Zeroed, 2);
        let Sizes::Known(report) = tally.report("") else { panic!() };
        assert_eq!(report.total, Size { flash: 8, ram: 10 });
    }
}
