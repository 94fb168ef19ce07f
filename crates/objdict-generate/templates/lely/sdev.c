{# LelyView<'_>::source #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * The static device {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for Lely core 2.4.
 */
#include "{{ head.stem }}.h"

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
#define {{ head.upper }}_NAME(text)
#else
#define {{ head.upper }}_NAME(text) .name = text,
#endif
#if LELY_NO_CO_OBJ_LIMITS
#define {{ head.upper }}_MIN(...)
#define {{ head.upper }}_MAX(...)
#else
#define {{ head.upper }}_MIN(...) .min = {__VA_ARGS__},
#define {{ head.upper }}_MAX(...) .max = {__VA_ARGS__},
#endif
#if LELY_NO_CO_OBJ_DEFAULT
#define {{ head.upper }}_DEFAULT(...)
#else
#define {{ head.upper }}_DEFAULT(...) .def = {__VA_ARGS__},
#endif
{%- for object in objects %}

static const struct co_ssub {{ head.lower }}_{{ object.index|hex4 }}[] = {
{%- for row in object.rows %}
    {
        {{ head.upper }}_NAME({{ row.name }})
        .subidx = 0x{{ row.sub|hex2 }}u,
        .type = CO_DEFTYPE_{{ row.data_type }},
{%- if let Some((low, high)) = row.limits %}
        {{ head.upper }}_MIN({{ low }}) {{ head.upper }}_MAX({{ high }})
{%- endif %}
        {{ head.upper }}_DEFAULT({{ row.default }})
        .val = { {{- row.value -}} },
        .access = CO_ACCESS_{{ row.access|upper }}, .pdo_mapping = {{ row.mapping }}, .flags = {{ row.flags }},
    },
{%- endfor %}
};
{%- endfor %}

static const struct co_sobj {{ head.lower }}_objects[] = {
{%- for object in objects %}
    { {{- head.upper }}_NAME({{ object.name }}) .idx = 0x{{ object.index|hex4 }}u, .code = CO_OBJECT_{{ object.code }}, .nsub = {{ object.rows.len() }}u, .subs = {{ head.lower }}_{{ object.index|hex4 }}},
{%- endfor %}
};

const struct co_sdev {{ head.lower }}_sdev = {
{%- for (member, value) in self.members() %}
    .{{ member }} = {{ value }},
{%- endfor %}
    .nobj = {{ objects.len() }}u,
    .objs = {{ head.lower }}_objects,
};

#if LELY_NO_MALLOC
static void {{ head.lower }}_row(co_sub_t *sub, const struct co_ssub *row, void *val)
{
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
}

co_dev_t *{{ head.lower }}_create(void)
{
    static co_dev_t dev;
    static co_obj_t objs[{{ objects.len() }}];
    static co_sub_t subs[{{ self.entries() }}];
    static union co_val vals[{{ self.entries() }}]; /* those of an object follow each other like the members of a struct */
    const struct co_sdev *const table = &{{ head.lower }}_sdev;
    co_sub_t *sub = subs;
    union co_val *val = vals;
    co_unsigned16_t at;
    if (__co_dev_init(&dev, table->id) == NULL) {
        return NULL;
    }
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
    for (at = 0u; at < table->nobj; at++) {
        const struct co_sobj *const object = &table->objs[at];
        co_obj_t *const obj = &objs[at];
        size_t size = 0u;
        co_unsigned8_t row_at;
        __co_obj_init(obj, object->idx, val, 0u);
        obj->code = object->code;
#if !LELY_NO_CO_OBJ_NAME
        obj->name = (char *)object->name;
#endif
        for (row_at = 0u; row_at < object->nsub; row_at++) {
            const struct co_ssub *const row = &object->subs[row_at];
            size = ALIGN(size, co_type_alignof(row->type));
            {{ head.lower }}_row(sub, row, (char *)val + size);
            size += co_type_sizeof(row->type);
            co_obj_insert_sub(obj, sub);
            sub++;
        }
        obj->size = size;
        co_dev_insert_obj(&dev, obj);
        val += object->nsub;
    }
    return &dev;
}
#endif
{%- if !hooks.is_empty() %}

void {{ head.lower }}_init_hooks(co_dev_t *dev, void *data)
{
{%- for hook in hooks %}
{%- for sub in hook.written %}
    co_sub_set_dn_ind(co_dev_find_sub(dev, 0x{{ hook.index|hex4 }}u, 0x{{ sub|hex2 }}u), {{ head.lower }}_hook{{ hook.index|hex4 }}_dn, data);
{%- endfor %}
{%- endfor %}
#if !LELY_NO_CO_OBJ_UPLOAD
{%- for hook in hooks %}
{%- for sub in hook.read %}
    co_sub_set_up_ind(co_dev_find_sub(dev, 0x{{ hook.index|hex4 }}u, 0x{{ sub|hex2 }}u), {{ head.lower }}_hook{{ hook.index|hex4 }}_up, data);
{%- endfor %}
{%- endfor %}
#endif
}
{%- endif %}
