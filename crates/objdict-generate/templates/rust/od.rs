// {{ table.made_by }}; do not edit.
//
// Object dictionary of {{ table.product|code_span }} by {{ table.vendor|code_span }}.
//
// `Data` contains the variable values, `Data::read` and `Data::write` implement SDO access, and each
// object has a module with the sub-indexes of its entries. The file has no dependencies and needs no
// standard library; use it as a module or with `include!`. Products rarely use all of it, so dead
// code is allowed; `unreachable_pub` depends on where it is included.
{%- if let Some(node_id) = table.node_id %}

/// The configured node-ID.
#[allow(dead_code, unreachable_pub)]
pub const NODE_ID: u8 = {{ node_id }};
{%- endif %}
{%- for view in objects %}

/// `0x{{ view.object.index|hex4 }}`: {{ view.object.name|code_span }}.
#[allow(dead_code, unreachable_pub)]
pub mod {{ view.object.module }} {
    /// Index of the object.
    pub const INDEX: u16 = 0x{{ view.object.index|hex4 }};
{%- for row in view.entries %}
    /// Sub-index `0x{{ row.sub|hex2 }}`: {{ row.name|code_span }}.
    pub const {{ row.constant|upper }}: u8 = 0x{{ row.sub|hex2 }};
{%- endfor %}
}
{%- endfor %}

{{ defaults }}

{% if let Some(meanings) = meanings -%}
{{ meanings }}

{% endif -%}
/// The variable values; constants are in flash.
#[allow(dead_code, unreachable_pub, clippy::struct_excessive_bools)]
#[derive(Clone, Debug, PartialEq)]{{ derives("") }}
pub struct Data {
    node_id: u8,
{%- for field in fields %}
    /// `0x{{ field.first.index|hex4 }}` sub-index `0x{{ field.first.sub|hex2 }}`
    {%- if field.array %} to `0x{{ field.last.sub|hex2 }}`{% endif %}: {{ field.first.name|code_span }}, `{{ field.first.access() }}`.
    {% if let (true, Some(module)) = (serde, field.serde_with) %}#[serde(with = "{{ module }}")]
    {% endif %}pub {{ field.name }}: {{ field.type_ }},
{%- endfor %}
{%- for group in groups %}
    /// The storage group {{ group.group.name|code_span }}.
    pub {{ group.group.field }}: {{ group.type_name }},
{%- endfor %}
}

#[allow(dead_code, unreachable_pub)]
impl Data {
    /// The defaults for `node_id`, 1 to 127; only the lower seven bits are used.
    #[must_use]
    #[rustfmt::skip]
    #[allow(clippy::approx_constant, clippy::cast_lossless, clippy::too_many_lines)]
    pub const fn new(node_id: u8) -> Self {
        let node_id = node_id & 0x7F;
        Self {
            node_id,
{%- for field in fields %}
            {{ field.name }}: {{ field.value }},
{%- endfor %}
{%- for group in groups %}
            {{ group.group.field }}: {{ group.type_name }}::new(node_id),
{%- endfor %}
        }
    }
{%- if table.fields.is_empty() %}

    #[allow(clippy::unused_self)]
    fn field(&self, _: Offset) -> Option<&dyn Field> {
        None
    }

    #[allow(clippy::unused_self)]
    fn field_mut(&mut self, _: Offset) -> Option<&mut dyn Field> {
        None
    }
{%- else %}

    #[rustfmt::skip]
    #[allow(clippy::too_many_lines)]
    fn field(&self, ram: Offset) -> Option<&dyn Field> {
        let field: &dyn Field = match ram {
{%- for field in fields %}
{%- if field.array %}
            {{ field.pattern }} => self.{{ field.name }}.get((ram - {{ field.place }}) as usize)?,
{%- else %}
            {{ field.pattern }} => &self.{{ field.name }},
{%- endif %}
{%- endfor %}
{%- for group in groups %}
            {{ group.first }}..={{ group.last }} => self.{{ group.group.field }}.field(ram)?,
{%- endfor %}
            _ => return None,
        };
        Some(field)
    }

    #[rustfmt::skip]
    #[allow(clippy::too_many_lines)]
    fn field_mut(&mut self, ram: Offset) -> Option<&mut dyn Field> {
        let field: &mut dyn Field = match ram {
{%- for field in fields %}
{%- if field.array %}
            {{ field.pattern }} => self.{{ field.name }}.get_mut((ram - {{ field.place }}) as usize)?,
{%- else %}
            {{ field.pattern }} => &mut self.{{ field.name }},
{%- endif %}
{%- endfor %}
{%- for group in groups %}
            {{ group.first }}..={{ group.last }} => self.{{ group.group.field }}.field_mut(ram)?,
{%- endfor %}
            _ => return None,
        };
        Some(field)
    }
{%- endif %}

    /// The node-ID of the values.
    #[must_use]
    pub const fn node_id(&self) -> u8 {
        self.node_id
    }

    /// Reads a value into `buffer`, as transferred by an SDO upload; returns the number of bytes.
    ///
    /// # Errors
    /// The code to abort the upload with.
    pub fn read(&self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let entry = find(index, sub)?;
        if !entry.is_readable() {
            return Err(Abort::WriteOnly);
        }
        let value = match self.field(entry.ram) {
            Some(field) => field.load(),
            None => entry.in_flash(self.node_id)?,
        };
        let bytes = match &value {
            Value::Number(number) => &number[..entry.size().min(8)],
            Value::Bytes(bytes) => bytes,
        };
        let room = buffer.get_mut(..bytes.len()).ok_or(Abort::OutOfMemory)?;
        room.copy_from_slice(bytes);
        Ok(bytes.len())
    }

    /// Writes a value transferred by an SDO download if the dictionary allows it.
    ///
    /// # Errors
    /// The code to abort the download with; the value is unchanged.
    pub fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let entry = find(index, sub)?;
        if !entry.is_writable() {
            return Err(Abort::ReadOnly);
        }
        let node_id = self.node_id;
        let field = self.field_mut(entry.ram).ok_or(Abort::CannotStore)?;
        entry.check_length(bytes.len())?;
        if entry.is_number() {
            let number = number(entry.data_type, bytes);
            entry.check_value(number, node_id)?;
            field.store(Value::Number(number.to_le_bytes()));
        } else {
            field.store(Value::Bytes(bytes));
        }
        Ok(())
    }
}
{%- if table.node_id.is_some() %}

/// The defaults for the configured node-ID.
#[allow(dead_code)]
impl Default for Data {
    fn default() -> Self {
        Self::new(NODE_ID)
    }
}
{%- endif %}

{%- if !groups.is_empty() %}

{% include "_stored.rs" %}
{%- endif %}
{%- if hooks %}

{% include "_hooks.rs" %}
{%- endif %}

{%- if !frames.is_empty() %}

{% include "_pdo.rs" %}
{%- endif %}

{% include "_values.rs" %}
{%- if defmt || serde %}

{% include "_derives.rs" %}
{%- endif %}

{% include "_entry.rs" %}

/// All entries in ascending order of index and sub-index.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub static ENTRIES: [Entry; {{ rows.len() }}] = [
{%- for view in rows %}
    Entry::row((0x{{ view.row.index|hex4 }}, 0x{{ view.row.sub|hex2 }}), {{ view.type_ }}, {{ view.flags }}, {{ view.ram }}, {{ view.row.rom }}), // {{ view.row.name|code_span }}
{%- endfor %}
];

/// Defaults and limits.
#[rustfmt::skip]
static ROM: [u8; {{ table.rom.len() }}] = [
{%- for line in rom %}
    {{ line }},
{%- endfor %}
];
{%- if names %}

{% include "_names.rs" %}
{%- endif %}
