use super::{BOOLEAN, Data, Entry, Table};

/// A list of numbers: the node-ID, then of each value that can change the index, the sub-index, the number of bytes and
/// the bytes.
impl<D: Table, const RAM: usize> serde::Serialize for Data<D, RAM> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let values = D::ENTRIES.iter().filter_map(|entry| Some((entry, self.value(entry)?)));
        let numbers = values.flat_map(|(entry, bytes)| {
            let head = [entry.index(), u16::from(entry.sub()), bytes.len() as u16];
            head.into_iter().chain(bytes.iter().copied().map(u16::from))
        });
        let numbers = core::iter::once(u16::from(self.node_id())).chain(numbers);
        let mut list = serializer.serialize_seq(Some(numbers.clone().count()))?;
        for number in numbers {
            serde::ser::SerializeSeq::serialize_element(&mut list, &number)?;
        }
        serde::ser::SerializeSeq::end(list)
    }
}

/// Missing values have their defaults; values that the table cannot store are errors.
impl<'de, D: Table, const RAM: usize> serde::Deserialize<'de> for Data<D, RAM> {
    fn deserialize<S: serde::Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        deserializer.deserialize_seq(DataVisitor(core::marker::PhantomData))
    }
}

struct DataVisitor<D, const RAM: usize>(core::marker::PhantomData<fn() -> D>);

impl<'de, D: Table, const RAM: usize> serde::de::Visitor<'de> for DataVisitor<D, RAM> {
    type Value = Data<D, RAM>;

    fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the node-ID, then index, sub-index, number of bytes and bytes of each value")
    }

    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut numbers: A) -> Result<Self::Value, A::Error> {
        let missing = || serde::de::Error::invalid_length(0, &self);
        // in a compact format, a byte is written differently from other numbers
        let byte =
            |number: Option<u16>| number.and_then(|number| u8::try_from(number).ok()).ok_or_else(missing);
        let mut data = Data::new(byte(numbers.next_element()?)?);
        while let Some(index) = numbers.next_element()? {
            let sub = byte(numbers.next_element()?)?;
            let length = numbers.next_element()?.ok_or_else(missing)?;
            let entry = Entry::<D>::find(index, sub).map_err(serde::de::Error::custom)?;
            let place = data.place(entry, length).ok_or_else(missing)?;
            for place in place.iter_mut() {
                *place = byte(numbers.next_element()?)?;
            }
            if entry.data_type() == BOOLEAN && !matches!(place, [0 | 1]) {
                return Err(serde::de::Error::custom("a BOOLEAN is neither 0 nor 1"));
            }
            data.clear_void_bits(entry);
        }
        Ok(data)
    }
}

impl<D: Table, const RAM: usize> Data<D, RAM> {
    /// The place of a value of this many bytes; `None` if there is none of this length.
    fn place(&mut self, entry: &Entry<D>, length: u16) -> Option<&mut [u8]> {
        let place = self.bytes.get_mut(entry.ram()..)?.get_mut(..entry.ram_size())?;
        if entry.ram() == 0 {
            None
        } else if entry.has_length() {
            place.fill(0);
            let (head, text) = place.split_first_chunk_mut()?;
            *head = length.to_le_bytes();
            text.get_mut(..usize::from(length))
        } else {
            Some(place).filter(|place| place.len() == usize::from(length))
        }
    }
}
