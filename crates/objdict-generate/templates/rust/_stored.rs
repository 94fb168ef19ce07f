{% for group in groups -%}
/// The storage group {{ group.group.name|code_span }}.
#[allow(dead_code, unreachable_pub, clippy::struct_excessive_bools)]
#[derive(Clone, Debug, PartialEq)]{{ derives("") }}
pub struct {{ group.type_name }} {
{%- for field in group.fields %}
    /// `0x{{ field.first.index|hex4 }}` sub-index `0x{{ field.first.sub|hex2 }}`
    {%- if field.array %} to `0x{{ field.last.sub|hex2 }}`{% endif %}: {{ field.first.name|code_span }}, `{{ field.first.access() }}`.
    {% if let (true, Some(module)) = (serde, field.serde_with) %}#[serde(with = "{{ module }}")]
    {% endif %}pub {{ field.name }}: {{ field.type_ }},
{%- endfor %}
}

#[allow(dead_code, unreachable_pub)]
impl {{ group.type_name }} {
    /// Size of an image in bytes.
    pub const IMAGE_SIZE: usize = {{ group.group.image_size }};
{%- if let Some(sub_index) = group.group.sub_index %}

    /// The sub-index of objects `0x1010` and `0x1011` for the group.
    pub const STORE_SUB_INDEX: u8 = {{ sub_index }};
{%- endif %}

    const KEPT: Kept = Kept {
        first: {{ group.first }},
        last: {{ group.last }},
        layout: {{ group.layout }},
    };

    /// The defaults for `node_id`, 1 to 127; only the lower seven bits are used.
    #[must_use]
    #[rustfmt::skip]
    #[allow(clippy::approx_constant, clippy::cast_lossless, clippy::too_many_lines)]
    pub const fn new({% if !group.depends_on_node_id %}_{% endif %}node_id: u8) -> Self {
{%- if group.depends_on_node_id %}
        let node_id = node_id & 0x7F;
{%- endif %}
        Self {
{%- for field in group.fields %}
            {{ field.name }}: {{ field.value }},
{%- endfor %}
        }
    }

    /// Writes the values to an image for non-volatile memory.
    pub fn save(&self, image: &mut [u8; Self::IMAGE_SIZE]) {
        Self::KEPT.save(|ram| self.field(ram), image);
    }

    /// Reads the values from an image without checking limits.
    ///
    /// # Errors
    /// Why the image is not valid; no value changes.
    pub fn load(&mut self, image: &[u8]) -> Result<(), ImageError> {
        Self::KEPT.check(image, Self::IMAGE_SIZE)?;
        for (entry, value) in Self::KEPT.values(image) {
            if let (Some(field), Some(value)) = (self.field_mut(entry.ram), value) {
                field.store(value);
            }
        }
        Ok(())
    }

    #[rustfmt::skip]
    #[allow(clippy::too_many_lines)]
    fn field(&self, ram: Offset) -> Option<&dyn Field> {
        let field: &dyn Field = match ram {
{%- for field in group.fields %}
{%- if field.array %}
            {{ field.pattern }} => self.{{ field.name }}.get((ram - {{ field.place }}) as usize)?,
{%- else %}
            {{ field.pattern }} => &self.{{ field.name }},
{%- endif %}
{%- endfor %}
            _ => return None,
        };
        Some(field)
    }

    #[rustfmt::skip]
    #[allow(clippy::too_many_lines)]
    fn field_mut(&mut self, ram: Offset) -> Option<&mut dyn Field> {
        let field: &mut dyn Field = match ram {
{%- for field in group.fields %}
{%- if field.array %}
            {{ field.pattern }} => self.{{ field.name }}.get_mut((ram - {{ field.place }}) as usize)?,
{%- else %}
            {{ field.pattern }} => &mut self.{{ field.name }},
{%- endif %}
{%- endfor %}
            _ => return None,
        };
        Some(field)
    }
}

{% endfor -%}
/// Why an image of a storage group is rejected.
#[allow(dead_code, unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]{{ derives("") }}
pub enum ImageError {
    /// The length is not `IMAGE_SIZE`.
    Length,
    /// From a group with other entries, data types or lengths, or never saved.
    Layout,
    /// Wrong CRC.
    Checksum,
    /// A value is not valid for its data type.
    Value,
}

impl core::fmt::Display for ImageError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Length => "the image has another length",
            Self::Layout => "the image has another layout",
            Self::Checksum => "the CRC of the image does not fit",
            Self::Value => "a value of the image is none of its data type",
        })
    }
}

/// The contents of an image of a storage group: its layout, the values of entries with locations
/// `first` to `last`, and the CRC.
#[derive(Clone, Copy)]
struct Kept {
    first: Offset,
    last: Offset,
    layout: u32,
}

#[allow(dead_code)]
impl Kept {
    fn entries(self) -> impl Iterator<Item = &'static Entry> {
        let places = self.first..=self.last;
        ENTRIES
            .iter()
            .filter(move |entry| places.contains(&entry.ram))
    }

    fn save<'a>(self, field: impl Fn(Offset) -> Option<&'a dyn Field>, image: &mut [u8]) {
        let mut at = 0;
        put(image, &mut at, &self.layout.to_le_bytes());
        for entry in self.entries() {
            let end = at + entry.image_size();
            match field(entry.ram).map(Field::load) {
                Some(Value::Number(number)) => put(image, &mut at, &number[..entry.size().min(8)]),
                Some(Value::Bytes(bytes)) => {
                    if entry.data_type != BLOCK {
                        let [low, high, ..] = bytes.len().to_le_bytes();
                        put(image, &mut at, &[low, high]);
                    }
                    put(image, &mut at, bytes);
                }
                None => {}
            }
            if let Some(unused) = image.get_mut(at..end) {
                unused.fill(0);
            }
            at = end;
        }
        let crc = crc16(image.get(..at).unwrap_or(&[])).to_le_bytes();
        put(image, &mut at, &crc);
    }

    fn check(self, image: &[u8], size: usize) -> Result<(), ImageError> {
        if image.len() != size {
            return Err(ImageError::Length);
        }
        let (saved, crc) = image.split_at(size - 2);
        if !saved.starts_with(&self.layout.to_le_bytes()) {
            Err(ImageError::Layout)
        } else if crc != crc16(saved).to_le_bytes() {
            Err(ImageError::Checksum)
        } else if self.values(image).any(|(_, value)| value.is_none()) {
            Err(ImageError::Value)
        } else {
            Ok(())
        }
    }

    /// The entries, each with its value in an image if it is valid for its data type.
    fn values(self, image: &[u8]) -> impl Iterator<Item = (&'static Entry, Option<Value<'_>>)> {
        let mut rest = image.get(4..).unwrap_or(&[]);
        self.entries().map(move |entry| {
            let (bytes, behind) = rest.split_at(entry.image_size().min(rest.len()));
            rest = behind;
            (entry, entry.saved(bytes))
        })
    }
}

#[allow(dead_code)]
impl Entry {
    /// Size of the value in an image, in bytes: a text uses its full capacity, preceded by its length.
    fn image_size(&self) -> usize {
        let has_length = !self.is_number() && self.data_type != BLOCK;
        self.size() + if has_length { 2 } else { 0 }
    }

    fn saved<'a>(&self, bytes: &'a [u8]) -> Option<Value<'a>> {
        if self.is_number() {
            let number = number(self.data_type, bytes);
            let is_value = self.data_type != BOOLEAN || number <= 1;
            return is_value.then(|| Value::Number(number.to_le_bytes()));
        }
        if self.data_type == BLOCK {
            return Some(Value::Bytes(bytes));
        }
        let (length, text) = (bytes.get(..2)?, bytes.get(2..)?);
        let shift = |length: usize, &byte: &u8| (length << 8) | usize::from(byte);
        let length = length.iter().rev().fold(0, shift);
        text.get(..length).map(Value::Bytes)
    }
}

/// Takes bytes at a position of an image and advances the position.
#[allow(dead_code)]
fn put(image: &mut [u8], at: &mut usize, bytes: &[u8]) {
    let end = *at + bytes.len();
    if let Some(room) = image.get_mut(*at..end) {
        room.copy_from_slice(bytes);
    }
    *at = end;
}

/// The CRC of `CiA` 301: x^16 + x^12 + x^5 + 1, initial value 0.
#[allow(dead_code)]
fn crc16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |crc, &byte| {
        (0..8).fold(crc ^ (u16::from(byte) << 8), |crc, _| {
            (crc << 1) ^ if crc & 0x8000 == 0 { 0 } else { 0x1021 }
        })
    })
}
