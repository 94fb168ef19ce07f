{# RustView<'_>::text #}
// {{ table.head.made_by }}; do not edit.
//
// Object dictionary of {{ table.head.product|code_span }} by {{ table.head.vendor|code_span }}.
//
// `Data` contains the variable values: `get` and `set` take the constants of this file, `read` and
// `write` index and sub-index, as an SDO does. The file {% if options.runtime %}depends on `objdict-device`{% else %}has no dependencies{% endif %} and needs no standard
// library; use it as a module or with `include!`. Products rarely use all of it, so dead code is
// allowed; `unreachable_pub` depends on where it is included.
{%- if let Some(node_id) = table.node_id %}

/// The configured node-ID.
#[allow(dead_code, unreachable_pub)]
pub const NODE_ID: u8 = {{ node_id }};

impl table::Configured for Od {
    const NODE_ID: u8 = NODE_ID;
}
{%- endif %}

/// Size of the longest value in bytes.
#[allow(dead_code, unreachable_pub)]
pub const MAX_SIZE: usize = {{ max_size }};

/// The dictionary of this device, as a type.
#[allow(unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Od;

/// The variable values; constants are in flash.
#[allow(dead_code, unreachable_pub)]
pub type Data = table::Data<Od, {{ places.total }}>;

/// An entry of the dictionary.
#[allow(dead_code, unreachable_pub)]
pub type Entry = table::Entry<Od>;

/// An entry with its type and access.
#[allow(dead_code, unreachable_pub)]
pub type Handle<T, A> = table::Handle<Od, T, A>;

/// The elements of an array.
#[allow(dead_code, unreachable_pub)]
pub type Array<T, A> = table::Array<Od, T, A>;

#[allow(unused_imports, unreachable_pub)]
pub use table::{Abort, {% if hook_room.is_some() %}Change, {% endif %}Const, Elsewhere, {% if hook_room.is_some() %}Hooks, {% endif %}{% if !table.groups.is_empty() %}ImageError, {% endif %}NodeConst, Ro, Rw, Time, Wo};

/// Finds the entry with an index and a sub-index by binary search.
///
/// # Errors
/// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
#[allow(dead_code, unreachable_pub)]
pub const fn find(index: u16, sub: u8) -> Result<&'static Entry, Abort> {
    Entry::find(index, sub)
}

{{ objects.text() }}
{%- if !table.groups.is_empty() %}
/// Storage groups: `data.save(groups::{{ table.groups[0].field|upper }}, &mut image)`.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub mod groups {
    use super::{Od, table::Group};

    /// The number of groups.
    pub const COUNT: usize = {{ table.groups.len() }};
{%- for (group, first) in table.groups.iter().zip(places.groups.iter()) %}
    /// {{ group.name|code_span }}.
    pub const {{ group.field|upper }}: Group<Od, {{ group.image_size }}> = Group::new({{ first }}, {{ self::hex(group.layout.into()) }}, {{ "{:?}"|format(group.sub_index) }});
{%- endfor %}
}
{% endif %}
{% include "_defaults.rs" %}

{% if let Some(meanings) = meanings -%}
{{ meanings.text() }}

{% endif -%}
{%- if options.runtime || !frames.is_empty() -%}
{% include "_pdo.rs" %}

{% endif -%}
/// All entries in ascending order of index and sub-index.
#[allow(dead_code, unreachable_pub, clippy::wildcard_imports)]
#[rustfmt::skip]
pub static ENTRIES: [Entry; {{ rows.len() }}] = {
    use table::*;
    [
{%- for view in rows %}
        Entry::new(0x{{ view.row.index|hex4 }}, 0x{{ view.row.sub|hex2 }}, {{ view.type_ }}, {{ view.flags }}, {{ view.ram }}, {{ view.row.rom }}), // {{ view.row.name|code_span }}
{%- endfor %}
    ]
};

impl table::Table for Od {
    const ENTRIES: &'static [Entry] = &ENTRIES;

    #[rustfmt::skip]
    const ROM: &'static [u8] = {
        static ROM: [u8; {{ table.rom.len() }}] = [
{%- for line in rom %}
            {{ line }},
{%- endfor %}
        ];
        &ROM
    };
{%- if options.entry_names %}

    // not part of the program unless used
{%- if options.feature_gates %}
    #[cfg(feature = "od-names")]
{%- endif %}
    #[rustfmt::skip]
    const NAMES: &'static [&'static str] = {
        static NAMES: [&str; {{ rows.len() }}] = [
{%- for view in rows %}
            {{ view.row.name|rust_text }},
{%- endfor %}
        ];
        &NAMES
    };
{%- endif %}
{%- if options.feature_gates %}

    const CHECKS_LIMITS: bool = cfg!(feature = "od-limits");
{%- endif %}
}
{%- if let Some(room) = hook_room %}

impl table::Hooked for Od {
    type Room = [u8; {{ room }}];
    const ROOM: [u8; {{ room }}] = [0; {{ room }}];
}
{%- endif %}

{%- if options.cell.is_some() %}

/// The values, for interrupts and the main program: `SHARED.with(|data| data.get(…))`.
#[allow(dead_code, unreachable_pub)]
pub static SHARED: objdict_device::Shared<Data> = objdict_device::Shared::new(Data::new(NODE_ID));
{%- endif %}

{%- if options.runtime %}

/// The values with the hooks of the application.
#[allow(dead_code, unreachable_pub)]
pub type Watched<H> = objdict_device::Watched<Data, H, {{ rows.len().div_ceil(8) }}>;

{% if !table.groups.is_empty() -%}
impl objdict_device::Grouped for Od {
    const GROUPS: &'static [table::AnyGroup<Self>] = &[
{%- for group in table.groups %}
        groups::{{ group.field|upper }}.any(),
{%- endfor %}
    ];
}

/// The values with the memory that keeps their groups.
#[allow(dead_code, unreachable_pub)]
pub type Stored<S> = objdict_device::Stored<Data, S, {{ self::largest_image(table) }}>;

/// The values with that memory and the hooks of the application.
#[allow(dead_code, unreachable_pub)]
pub type WatchedStored<S, H> = objdict_device::Watched<Stored<S>, H, {{ rows.len().div_ceil(8) }}>;

{% endif -%}
/// A node with `CHANNELS` SDO servers for values of at most `BUFFER` bytes, and with the PDOs of this device.
#[allow(dead_code, unreachable_pub)]
pub type Node<const BUFFER: usize, const CHANNELS: usize, D = Data> =
    objdict_device::Node<D, BUFFER, CHANNELS, {{ pdos[0].len() }}, {{ pdos[1].len() }}, {{ consumers }}>;

/// The PDOs, for `Node::new`.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub const fn pdos() -> objdict_device::Pdos<{{ pdos[0].len() }}, {{ pdos[1].len() }}> {
    objdict_device::Pdos::new({{ Self::indexes(&pdos[0]) }}, {{ Self::indexes(&pdos[1]) }})
}

/// A node with the defaults, before its boot-up.
#[allow(dead_code, unreachable_pub)]
pub const fn node<const BUFFER: usize, const CHANNELS: usize>(node_id: u8) -> Node<BUFFER, CHANNELS> {
    Node::new(node_id, Data::new(node_id), pdos())
}

#[allow(unreachable_pub)]
pub use objdict_device::table;
{%- else %}

/// The code that serves the table, which is the same for every device.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::arithmetic_side_effects, clippy::nursery, clippy::pedantic)]
#[rustfmt::skip]
pub mod table {
{{ code() }}
}
{%- endif %}
