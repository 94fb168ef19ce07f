// Generated from templates/canopennode-v1/CO_OD.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl CanOpenNodeV1View<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * Object dictionary of {} by {}, for CANopenNode 1.3.
 */
#include \"CO_driver.h\"
#include \"CO_OD.h\"
#include \"CO_SDO.h\"", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor));
        for location in &ValueLocation::ALL {
            put!(out, "

struct sCO_OD_{} CO_OD_{} = {{
    CO_OD_FIRST_LAST_WORD,", location.name(), location.name());
            for variable in self.plan.of(location) {
                put!(out, "
    {}, /* {}h */", variable.initializer, crate::escape::hex4(&variable.index));
            }
            out.push_str("
    CO_OD_FIRST_LAST_WORD,
};");
        }
        out.push_str("

/* What a sub-index without an entry refers to: not constant, as the stack declares the data of all rows. */
UNSIGNED8 CO_OD_noEntry = 0u;

/* The rows of records, by sub-index. */");
        for object in &self.plan.rows {
            if !object.record.is_empty() {
                put!(out, "
const CO_OD_entryRecord_t OD_record{}[{}] = {{", self.plan.hex(object.index), object.record.len());
                for row in &object.record {
                    put!(out, "
    {{(void *){}, 0x{}, {}}},", row.data, crate::escape::hex4(&row.attribute), row.length);
                }
                out.push_str("
};");
            }
        }
        out.push_str("

const CO_OD_entry_t CO_OD[CO_OD_NoOfElements] = {");
        for object in &self.plan.rows {
            put!(out, "
    {{0x{}, {}, 0x{}, {}, (void *){}}}, /* {} */", crate::escape::hex4(&object.index), object.max_sub, crate::escape::hex4(&object.row.attribute), object.row.length, object.row.data, crate::escape::c_comment(&object.described));
        }
        out.push_str("
};");
        if !self.plan.formulas.is_empty() {
            if self.stores_bytes() {
                out.push_str("

static void CO_OD_store(UNSIGNED8 *bytes, UNSIGNED64 number, unsigned size)
{
    unsigned at;
    for (at = 0u; at < size; at++) {
        bytes[at] = (UNSIGNED8)(number >> (8u * at));
    }
}");
            }
            out.push_str("

void CO_OD_applyNodeId(uint8_t nodeId)
{");
            for formula in &self.plan.formulas {
                put!(out, "
    {}", formula);
            }
            out.push_str("
}");
        }
        if !self.hooks.is_empty() {
            out.push_str("
");
            for index in &self.hooks {
                put!(out, "
CO_SDO_abortCode_t CO_OD_hook{}(CO_ODF_arg_t *ODF_arg);", index);
            }
            out.push_str("

void CO_OD_initHooks(void *SDO, void *object)
{");
            for index in &self.hooks {
                put!(out, "
    CO_OD_configure((CO_SDO_t *)SDO, 0x{}u, CO_OD_hook{}, object, 0, 0u);", index, index);
            }
            out.push_str("
}");
        }
        out
    }
}
