// Generated from templates/lely/sdev.c by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl LelyView<'_> {
    pub(super) fn source(&self) -> String {
        let mut out = String::new();
        put!(out, "/*
 * {}; do not edit.
 *
 * The static device {} by {}, for Lely core 2.4.
 */
#include \"{}.h\"

/* An empty text, octet string or DOMAIN; without malloc() with room for CO_ARRAY_CAPACITY bytes. */
#if LELY_NO_MALLOC
#include <lely/co/detail/dev.h>
#include <lely/co/detail/obj.h>
#include <string.h>
#define EMPTY_ARRAY CO_ARRAY_C
#else
#define EMPTY_ARRAY NULL
#endif

/* The members that the library has only where LELY_NO_CO_OBJ_NAME, _LIMITS and _DEFAULT are not set. */
#if LELY_NO_CO_OBJ_NAME
#define {}_NAME(text)
#else
#define {}_NAME(text) .name = text,
#endif
#if LELY_NO_CO_OBJ_LIMITS
#define {}_MIN(...)
#define {}_MAX(...)
#else
#define {}_MIN(...) .min = {{__VA_ARGS__}},
#define {}_MAX(...) .max = {{__VA_ARGS__}},
#endif
#if LELY_NO_CO_OBJ_DEFAULT
#define {}_DEFAULT(...)
#else
#define {}_DEFAULT(...) .def = {{__VA_ARGS__}},
#endif", self.head.made_by, crate::escape::c_comment(&self.head.product), crate::escape::c_comment(&self.head.vendor), self.head.stem, self.head.upper, self.head.upper, self.head.upper, self.head.upper, self.head.upper, self.head.upper, self.head.upper, self.head.upper);
        for object in &self.objects {
            put!(out, "

static const struct co_ssub {}_{}[] = {{", self.head.lower, crate::escape::hex4(&object.index));
            for row in &object.rows {
                put!(out, "
    {{
        {}_NAME({})
        .subidx = 0x{}u,
        .type = CO_DEFTYPE_{},", self.head.upper, row.name, crate::escape::hex2(&row.sub), row.data_type);
                if let Some((low, high)) = &row.limits {
                    put!(out, "
        {}_MIN({}) {}_MAX({})", self.head.upper, low, self.head.upper, high);
                }
                put!(out, "
        {}_DEFAULT({})
        .val = {{{}}},
        .access = CO_ACCESS_{}, .pdo_mapping = {}, .flags = {},
    }},", self.head.upper, row.default, row.value, row.access.to_string().to_uppercase(), row.mapping, row.flags);
            }
            out.push_str("
};");
        }
        put!(out, "

static const struct co_sobj {}_objects[] = {{", self.head.lower);
        for object in &self.objects {
            put!(out, "
    {{{}_NAME({}) .idx = 0x{}u, .code = CO_OBJECT_{}, .nsub = {}u, .subs = {}_{}}},", self.head.upper, object.name, crate::escape::hex4(&object.index), object.code, object.rows.len(), self.head.lower, crate::escape::hex4(&object.index));
        }
        put!(out, "
}};

const struct co_sdev {}_sdev = {{", self.head.lower);
        for (member, value) in self.members() {
            put!(out, "
    .{} = {},", member, value);
        }
        put!(out, "
    .nobj = {}u,
    .objs = {}_objects,
}};

#if LELY_NO_MALLOC
static void {}_row(co_sub_t *sub, const struct co_ssub *row, void *val)
{{
    __co_sub_init(sub, row->subidx, row->type, val);
    memcpy(val, &row->val, co_type_sizeof(row->type));
#if !LELY_NO_CO_OBJ_NAME
    sub->name = (char *)row->name;
#endif
#if !LELY_NO_CO_OBJ_LIMITS
    sub->min = row->min;
    sub->max = row->max;
#endif
#if !LELY_NO_CO_OBJ_DEFAULT
    sub->def = row->def;
#endif
    sub->access = row->access;
    sub->pdo_mapping = row->pdo_mapping;
    sub->flags = row->flags;
}}

co_dev_t *{}_create(void)
{{
    static co_dev_t dev;
    static co_obj_t objs[{}];
    static co_sub_t subs[{}];
    static union co_val vals[{}]; /* those of an object follow each other like the members of a struct */
    const struct co_sdev *const table = &{}_sdev;
    co_sub_t *sub = subs;
    union co_val *val = vals;
    co_unsigned16_t at;
    if (__co_dev_init(&dev, table->id) == NULL) {{
        return NULL;
    }}
#if !LELY_NO_CO_OBJ_NAME
    dev.name = (char *)table->name;
    dev.vendor_name = (char *)table->vendor_name;
    dev.product_name = (char *)table->product_name;
    dev.order_code = (char *)table->order_code;
#endif
    dev.vendor_id = table->vendor_id;
    dev.product_code = table->product_code;
    dev.revision = table->revision;
    dev.baud = table->baud;
    dev.rate = table->rate;
    dev.lss = table->lss;
    dev.dummy = table->dummy;
    for (at = 0u; at < table->nobj; at++) {{
        const struct co_sobj *const object = &table->objs[at];
        co_obj_t *const obj = &objs[at];
        size_t size = 0u;
        co_unsigned8_t row_at;
        __co_obj_init(obj, object->idx, val, 0u);
        obj->code = object->code;
#if !LELY_NO_CO_OBJ_NAME
        obj->name = (char *)object->name;
#endif
        for (row_at = 0u; row_at < object->nsub; row_at++) {{
            const struct co_ssub *const row = &object->subs[row_at];
            size = ALIGN(size, co_type_alignof(row->type));
            {}_row(sub, row, (char *)val + size);
            size += co_type_sizeof(row->type);
            co_obj_insert_sub(obj, sub);
            sub++;
        }}
        obj->size = size;
        co_dev_insert_obj(&dev, obj);
        val += object->nsub;
    }}
    return &dev;
}}
#endif", self.objects.len(), self.head.lower, self.head.lower, self.head.lower, self.objects.len(), self.entries(), self.entries(), self.head.lower, self.head.lower);
        if !self.hooks.is_empty() {
            put!(out, "

void {}_init_hooks(co_dev_t *dev, void *data)
{{", self.head.lower);
            for hook in &self.hooks {
                for sub in &hook.written {
                    put!(out, "
    co_sub_set_dn_ind(co_dev_find_sub(dev, 0x{}u, 0x{}u), {}_hook{}_dn, data);", crate::escape::hex4(&hook.index), crate::escape::hex2(&sub), self.head.lower, crate::escape::hex4(&hook.index));
                }
            }
            out.push_str("
#if !LELY_NO_CO_OBJ_UPLOAD");
            for hook in &self.hooks {
                for sub in &hook.read {
                    put!(out, "
    co_sub_set_up_ind(co_dev_find_sub(dev, 0x{}u, 0x{}u), {}_hook{}_up, data);", crate::escape::hex4(&hook.index), crate::escape::hex2(&sub), self.head.lower, crate::escape::hex4(&hook.index));
                }
            }
            out.push_str("
#endif
}");
        }
        out
    }
}
