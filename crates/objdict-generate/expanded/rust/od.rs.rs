// Generated from templates/rust/od.rs by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl RustView<'_> {
    pub(super) fn text(&self) -> String {
        let mut out = String::new();
        put!(out, "// {}; do not edit.
//
// Object dictionary of {} by {}.
//
// `Data` contains the variable values: `get` and `set` take the constants of this file, `read` and
// `write` index and sub-index, as an SDO does. The file ", self.table.head.made_by, crate::escape::code_span(&self.table.head.product), crate::escape::code_span(&self.table.head.vendor));
        if self.options.runtime {
            out.push_str("depends on `objdict-device`");
        }
        else {
            out.push_str("has no dependencies");
        }
        out.push_str(" and needs no standard
// library; use it as a module or with `include!`. Products rarely use all of it, so dead code is
// allowed; `unreachable_pub` depends on where it is included.");
        if let Some(node_id) = &self.table.node_id {
            put!(out, "

/// The configured node-ID.
#[allow(dead_code, unreachable_pub)]
pub const NODE_ID: u8 = {};

impl table::Configured for Od {{
    const NODE_ID: u8 = NODE_ID;
}}", node_id);
        }
        put!(out, "

/// Size of the longest value in bytes.
#[allow(dead_code, unreachable_pub)]
pub const MAX_SIZE: usize = {};

/// The dictionary of this device, as a type.
#[allow(unreachable_pub)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Od;

/// The variable values; constants are in flash.
#[allow(dead_code, unreachable_pub)]
pub type Data = table::Data<Od, {}>;

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
pub use table::{{Abort, ", self.max_size, self.places.total);
        if self.hook_room.is_some() {
            out.push_str("Change, ");
        }
        out.push_str("Const, Elsewhere, ");
        if self.hook_room.is_some() {
            out.push_str("Hooks, ");
        }
        if !self.table.groups.is_empty() {
            out.push_str("ImageError, ");
        }
        put!(out, "NodeConst, Ro, Rw, Time, Wo}};

/// Finds the entry with an index and a sub-index by binary search.
///
/// # Errors
/// [`Abort::NoObject`] or [`Abort::NoSubIndex`].
#[allow(dead_code, unreachable_pub)]
pub const fn find(index: u16, sub: u8) -> Result<&'static Entry, Abort> {{
    Entry::find(index, sub)
}}

{}", self.objects.text());
        if !self.table.groups.is_empty() {
            put!(out, "
/// Storage groups: `data.save(groups::{}, &mut image)`.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub mod groups {{
    use super::{{Od, table::Group}};

    /// The number of groups.
    pub const COUNT: usize = {};", self.table.groups[0].field.to_string().to_uppercase(), self.table.groups.len());
            for (group, first) in self.table.groups.iter().zip(self.places.groups.iter()) {
                put!(out, "
    /// {}.
    pub const {}: Group<Od, {}> = Group::new({}, {}, {:?});", crate::escape::code_span(&group.name), group.field.to_string().to_uppercase(), group.image_size, first, self::hex(group.layout.into()), group.sub_index);
            }
            out.push_str("
}
");
        }
        out.push_str("
/// Default values of identity and services, decoded. COB-IDs are functions of the node-ID. `Data`
/// contains the present values.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::arithmetic_side_effects, clippy::cast_lossless)]
#[rustfmt::skip]
pub mod defaults {");
        for (index0, item) in (&self.defaults).into_iter().enumerate() {
            if !(index0 == 0) {
                out.push_str("
");
            }
            put!(out, "
    /// {}.", item.meaning);
            if let Some(uses_node_id) = &item.function {
                put!(out, "
    #[must_use]
    pub const fn {}(", item.name);
                if !uses_node_id {
                    out.push_str("_");
                }
                put!(out, "node_id: u8) -> {} {{
        {}
    }}", item.type_, item.value);
            }
            else {
                put!(out, "
    pub const {}: {} = {};", item.name, item.type_, item.value);
            }
        }
        out.push_str("
}

");
        if let Some(meanings) = &self.meanings {
            put!(out, "{}

", meanings.text());
        }
        if self.options.runtime || !self.frames.is_empty() {
            out.push_str("/// The default mapping of PDOs: one struct per PDO with its fields in frame order.
");
            if self.options.feature_gates {
                out.push_str("#[cfg(feature = \"od-pdo\")]
");
            }
            out.push_str("#[allow(dead_code, unreachable_pub, unused_imports)]
#[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)]
#[allow(clippy::derive_partial_eq_without_eq)]
pub mod pdo {
    use super::table::{first, pack, unpack};
    use super::Data;
");
            for frame in &self.frames {
                put!(out, "
    /// {} (`0x{}`, `0x{}`).
    #[allow(clippy::struct_excessive_bools)]
    #[derive(Clone, Copy, Debug, PartialEq)]{}
    pub struct {} {{", frame.frame.title, crate::escape::hex4(&frame.frame.communication_index), crate::escape::hex4(&frame.frame.mapping_index), self.derives("    "), crate::escape::capitalize(&frame.frame.name));
                for field in &frame.fields {
                    put!(out, "
        /// `0x{}` sub-index `0x{}`: {}.
        pub {}: {},", crate::escape::hex4(&field.row.index), crate::escape::hex2(&field.row.sub), crate::escape::code_span(&field.row.name), field.field.name, field.type_);
                }
                put!(out, "
    }}

    #[rustfmt::skip]
    #[allow(clippy::cast_lossless)]
    impl {} {{
        /// Length of a frame in bytes.
        pub const LENGTH: usize = {};", crate::escape::capitalize(&frame.frame.name), frame.frame.length);
                if let Some(transmission_type) = &frame.frame.transmission_type {
                    put!(out, "

        /// The default transmission type.
        pub const TRANSMISSION_TYPE: u8 = {};", transmission_type);
                }
                if let Some(cob_id) = &frame.cob_id {
                    out.push_str("

        /// The default COB-ID, including the flags in its upper bits.
        #[must_use]
        pub const fn cob_id(");
                    if !frame.frame.depends_on_node_id() {
                        out.push_str("_");
                    }
                    put!(out, "node_id: u8) -> u32 {{
            {}
        }}", cob_id);
                }
                out.push_str("

        /// Reads the present values from the dictionary.
        #[must_use]
        pub fn load(data: &Data) -> Self {
            Self {");
                for field in &frame.fields {
                    put!(out, "
                {}: {},", field.field.name, field.load);
                }
                out.push_str("
            }
        }

        /// Writes the values to the dictionary without checking limits; constants are unchanged.
        pub fn store(&self, ");
                if !frame.writes_data {
                    out.push_str("_");
                }
                out.push_str("data: &mut Data) {");
                for field in &frame.fields {
                    if let Some(store) = &field.store {
                        put!(out, "
            {};", store);
                    }
                }
                put!(out, "
        }}

        /// Packs the values into a frame.
        #[must_use]
        pub fn pack(&self) -> [u8; {}] {{
            let frame = ", frame.frame.length);
                for (index0, field) in (&frame.fields).into_iter().enumerate() {
                    if !(index0 == 0) {
                        out.push_str("
                | ");
                    }
                    put!(out, "pack::<{}>(self.{}, {}, {})", field.type_, field.field.name, field.field.first, field.field.bits);
                }
                put!(out, ";
            let bytes = frame.to_le_bytes();
            core::array::from_fn(|at| bytes[at])
        }}

        /// Unpacks the values of a frame.
        #[must_use]
        pub fn unpack(frame: [u8; {}]) -> Self {{
            let frame = frame.iter().rev().fold(0, |frame, &byte| (frame << 8) | u64::from(byte));
            Self {{", frame.frame.length);
                for field in &frame.fields {
                    put!(out, "
                {}: unpack(frame, {}, {}, {}),", field.field.name, field.field.first, field.field.bits, field.field.is_signed());
                }
                out.push_str("
            }
        }
    }");
                if self.options.runtime {
                    put!(out, "

    impl objdict_device::Pdo for {} {{
        type Data = Data;
        const INDEX: u16 = 0x{};
        const LENGTH: usize = {};

        fn load(data: &Data) -> Self {{
            Self::load(data)
        }}

        fn store(&self, data: &mut Data) {{
            Self::store(self, data);
        }}

        fn to_bytes(&self) -> [u8; 8] {{
            first(&self.pack())
        }}

        fn from_bytes(bytes: [u8; 8]) -> Self {{
            Self::unpack(first(&bytes))
        }}
    }}", crate::escape::capitalize(&frame.frame.name), crate::escape::hex4(&frame.frame.communication_index), frame.frame.length);
                }
                out.push_str("
");
            }
            out.push_str("}

");
        }
        put!(out, "/// All entries in ascending order of index and sub-index.
#[allow(dead_code, unreachable_pub, clippy::wildcard_imports)]
#[rustfmt::skip]
pub static ENTRIES: [Entry; {}] = {{
    use table::*;
    [", self.rows.len());
        for view in &self.rows {
            put!(out, "
        Entry::new(0x{}, 0x{}, {}, {}, {}, {}), // {}", crate::escape::hex4(&view.row.index), crate::escape::hex2(&view.row.sub), view.type_, view.flags, view.ram, view.row.rom, crate::escape::code_span(&view.row.name));
        }
        put!(out, "
    ]
}};

impl table::Table for Od {{
    const ENTRIES: &'static [Entry] = &ENTRIES;

    #[rustfmt::skip]
    const ROM: &'static [u8] = {{
        static ROM: [u8; {}] = [", self.table.rom.len());
        for line in &self.rom {
            put!(out, "
            {},", line);
        }
        out.push_str("
        ];
        &ROM
    };");
        if self.options.entry_names {
            out.push_str("

    // not part of the program unless used");
            if self.options.feature_gates {
                out.push_str("
    #[cfg(feature = \"od-names\")]");
            }
            put!(out, "
    #[rustfmt::skip]
    const NAMES: &'static [&'static str] = {{
        static NAMES: [&str; {}] = [", self.rows.len());
            for view in &self.rows {
                put!(out, "
            {},", crate::escape::rust_text(&view.row.name));
            }
            out.push_str("
        ];
        &NAMES
    };");
        }
        if self.options.feature_gates {
            out.push_str("

    const CHECKS_LIMITS: bool = cfg!(feature = \"od-limits\");");
        }
        out.push_str("
}");
        if let Some(room) = &self.hook_room {
            put!(out, "

impl table::Hooked for Od {{
    type Room = [u8; {}];
    const ROOM: [u8; {}] = [0; {}];
}}", room, room, room);
        }
        if self.options.cell.is_some() {
            out.push_str("

/// The values, for interrupts and the main program: `SHARED.with(|data| data.get(…))`.
#[allow(dead_code, unreachable_pub)]
pub static SHARED: objdict_device::Shared<Data> = objdict_device::Shared::new(Data::new(NODE_ID));");
        }
        if self.options.runtime {
            put!(out, "

/// The values with the hooks of the application.
#[allow(dead_code, unreachable_pub)]
pub type Watched<H> = objdict_device::Watched<Data, H, {}>;

", self.rows.len().div_ceil(8));
            if !self.table.groups.is_empty() {
                out.push_str("impl objdict_device::Grouped for Od {
    const GROUPS: &'static [table::AnyGroup<Self>] = &[");
                for group in &self.table.groups {
                    put!(out, "
        groups::{}.any(),", group.field.to_string().to_uppercase());
                }
                put!(out, "
    ];
}}

/// The values with the memory that keeps their groups.
#[allow(dead_code, unreachable_pub)]
pub type Stored<S> = objdict_device::Stored<Data, S, {}>;

/// The values with that memory and the hooks of the application.
#[allow(dead_code, unreachable_pub)]
pub type WatchedStored<S, H> = objdict_device::Watched<Stored<S>, H, {}>;

", self::largest_image(self.table), self.rows.len().div_ceil(8));
            }
            put!(out, "/// A node with `CHANNELS` SDO servers for values of at most `BUFFER` bytes, and with the PDOs of this device.
#[allow(dead_code, unreachable_pub)]
pub type Node<const BUFFER: usize, const CHANNELS: usize, D = Data> =
    objdict_device::Node<D, BUFFER, CHANNELS, {}, {}, {}>;

/// The PDOs, for `Node::new`.
#[allow(dead_code, unreachable_pub)]
#[rustfmt::skip]
pub const fn pdos() -> objdict_device::Pdos<{}, {}> {{
    objdict_device::Pdos::new({}, {})
}}

/// A node with the defaults, before its boot-up.
#[allow(dead_code, unreachable_pub)]
pub const fn node<const BUFFER: usize, const CHANNELS: usize>(node_id: u8) -> Node<BUFFER, CHANNELS> {{
    Node::new(node_id, Data::new(node_id), pdos())
}}

#[allow(unreachable_pub)]
pub use objdict_device::table;", self.pdos[0].len(), self.pdos[1].len(), self.consumers, self.pdos[0].len(), self.pdos[1].len(), Self::indexes(&self.pdos[0]), Self::indexes(&self.pdos[1]));
        }
        else {
            put!(out, "

/// The code that serves the table, which is the same for every device.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::arithmetic_side_effects, clippy::nursery, clippy::pedantic)]
#[rustfmt::skip]
pub mod table {{
{}
}}", self.code());
        }
        out
    }
}
