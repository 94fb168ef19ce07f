// Generated from templates/zencan/device.toml by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl ZencanConfig {
    pub(super) fn text(&self) -> String {
        let mut out = String::new();
        put!(out, "# {}; do not edit.
#
# Device configuration for zencan-build 0.0.5.

device_name = {}
hardware_version = {}
software_version = {}
heartbeat_period = {}
autostart = \"unsupported\"
support_storage = {}

[identity]
vendor_id = 0x{:08X}
product_code = 0x{:08X}
revision_number = 0x{:08X}

[pdos]
num_rpdo = {}
num_tpdo = {}", self.made_by, crate::escape::toml_string(&self.settings.texts[0]), crate::escape::toml_string(&self.settings.texts[1]), crate::escape::toml_string(&self.settings.texts[2]), self.settings.heartbeat_period, self.stores, self.settings.identity[0], self.settings.identity[1], self.settings.identity[2], self.counts[0], self.counts[1]);
        for pdo in &self.pdos {
            put!(out, "

[pdos.{}.{}]
cob_id = 0x{:X}
extended = {}
add_node_id = {}
enabled = {}
rtr_disabled = {}
transmission_type = {}
mappings = [", pdo.kind.to_string().to_lowercase(), pdo.number, pdo.can_id(), pdo.has(CobId::FRAME), pdo.add_node_id, !pdo.has(CobId::BIT_31), pdo.has(CobId::BIT_30), pdo.transmission_type);
            for mapped in &pdo.mappings {
                put!(out, "
    {{ index = 0x{}, sub = {}, size = {} }},", crate::escape::hex4(&mapped.index), mapped.sub, mapped.bits);
            }
            out.push_str("
]");
        }
        for object in &self.objects {
            put!(out, "

[[objects]]
index = 0x{}
parameter_name = {}", crate::escape::hex4(&object.index), object.name);
            match &object.kind {
                ObjectContent::Var(entry) => {
                    put!(out, "
object_type = \"var\"
data_type = \"{}\"
access_type = \"{}\"", entry.data_type, entry.access);
                    if let Some(default) = &entry.default {
                        put!(out, "
default_value = {}", default);
                    }
                    put!(out, "
pdo_mapping = \"{}\"", entry.pdo_mapping);
                    if entry.persist {
                        out.push_str("
persist = true");
                    }
                }
                ObjectContent::Array { entry, size } => {
                    put!(out, "
object_type = \"array\"
array_size = {}
data_type = \"{}\"
access_type = \"{}\"", size, entry.data_type, entry.access);
                    if let Some(default) = &entry.default {
                        put!(out, "
default_value = {}", default);
                    }
                    put!(out, "
pdo_mapping = \"{}\"", entry.pdo_mapping);
                    if entry.persist {
                        out.push_str("
persist = true");
                    }
                }
                ObjectContent::Record(subs) => {
                    out.push_str("
object_type = \"record\"");
                    for view in subs {
                        let entry = &view.entry;
                        put!(out, "

[[objects.subs]]
sub_index = {}
parameter_name = {}
field_name = \"{}\"
data_type = \"{}\"
access_type = \"{}\"", view.sub, view.name, view.field, entry.data_type, entry.access);
                        if let Some(default) = &entry.default {
                            put!(out, "
default_value = {}", default);
                        }
                        put!(out, "
pdo_mapping = \"{}\"", entry.pdo_mapping);
                        if entry.persist {
                            out.push_str("
persist = true");
                        }
                    }
                }
            }
        }
        out
    }
}
