{% if defmt -%}
impl<const N: usize> defmt::Format for Octets<N> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=[u8]}", self.as_slice());
    }
}
{%- endif %}
{%- if defmt && serde %}

{% endif %}
{%- if serde -%}
impl<const N: usize> serde::Serialize for Octets<N> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_bytes(self.as_slice())
    }
}

impl<'de, const N: usize> serde::Deserialize<'de> for Octets<N> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_bytes(OctetsVisitor)
    }
}

/// Accepts at most `N` bytes.
struct OctetsVisitor<const N: usize>;

impl<'de, const N: usize> serde::de::Visitor<'de> for OctetsVisitor<N> {
    type Value = Octets<N>;

    fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "at most {N} bytes")
    }

    fn visit_bytes<E: serde::de::Error>(self, bytes: &[u8]) -> Result<Octets<N>, E> {
        if bytes.len() > N {
            return Err(E::invalid_length(bytes.len(), &self));
        }
        Ok(Octets::new(bytes))
    }

    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut items: A) -> Result<Octets<N>, A::Error> {
        let mut octets = Octets::new(&[]);
        while let Some(byte) = items.next_element()? {
            let length = usize::from(octets.length);
            match octets.bytes.get_mut(length) {
                Some(place) => *place = byte,
                None => return Err(serde::de::Error::invalid_length(length + 1, &self)),
            }
            octets.length += 1;
        }
        Ok(octets)
    }
}

/// Arrays of any length: serde supports up to 32 elements.
#[allow(dead_code)]
mod serde_array {
    use serde::de::Error;
    use serde::ser::SerializeTuple;

    pub(super) fn serialize<S: serde::Serializer, T: serde::Serialize, const N: usize>(
        values: &[T; N],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(N)?;
        for value in values {
            tuple.serialize_element(value)?;
        }
        tuple.end()
    }

    pub(super) fn deserialize<'de, D, T, const N: usize>(
        deserializer: D,
    ) -> Result<[T; N], D::Error>
    where
        D: serde::Deserializer<'de>,
        T: serde::Deserialize<'de> + Copy,
    {
        deserializer.deserialize_tuple(N, Elements(core::marker::PhantomData))
    }

    struct Elements<T, const N: usize>(core::marker::PhantomData<T>);

    impl<'de, T, const N: usize> serde::de::Visitor<'de> for Elements<T, N>
    where
        T: serde::Deserialize<'de> + Copy,
    {
        type Value = [T; N];

        fn expecting(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
            write!(f, "{N} values")
        }

        fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut items: A) -> Result<[T; N], A::Error> {
            let first = items.next_element()?;
            let mut values = [first.ok_or_else(|| A::Error::invalid_length(0, &self))?; N];
            for (at, place) in values.iter_mut().enumerate().skip(1) {
                let value = items.next_element()?;
                *place = value.ok_or_else(|| A::Error::invalid_length(at, &self))?;
            }
            Ok(values)
        }
    }
}

/// Arrays of blocks of any length.
#[allow(dead_code)]
mod serde_blocks {
    #[derive(Clone, Copy, serde::Serialize, serde::Deserialize)]
    #[serde(transparent)]
    struct Block<const L: usize>(#[serde(with = "super::serde_array")] [u8; L]);

    pub(super) fn serialize<S: serde::Serializer, const L: usize, const N: usize>(
        values: &[[u8; L]; N],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        super::serde_array::serialize(&values.map(Block), serializer)
    }

    pub(super) fn deserialize<'de, D, const L: usize, const N: usize>(
        deserializer: D,
    ) -> Result<[[u8; L]; N], D::Error>
    where
        D: serde::Deserializer<'de>,
    {
        let values: [Block<L>; N] = super::serde_array::deserialize(deserializer)?;
        Ok(values.map(|block| block.0))
    }
}
{%- endif %}
