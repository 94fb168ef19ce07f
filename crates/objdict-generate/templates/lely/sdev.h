{# LelyView<'_>::header #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * The static device {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for Lely core 2.4.
 */
#ifndef {{ head.upper }}_SDEV_H
#define {{ head.upper }}_SDEV_H

#include <lely/co/sdev.h>
{%- if !hooks.is_empty() %}
#include <lely/co/dev.h>
#include <lely/co/obj.h>
{%- endif %}

#ifdef __cplusplus
extern "C" {
#endif

/* The argument of co_dev_create_from_sdev(). */
extern const struct co_sdev {{ head.lower }}_sdev;

#if LELY_NO_MALLOC
/* In place of co_dev_create_from_sdev(): makes the one device in static memory; NULL for an invalid node-ID. Call it once. */
co_dev_t *{{ head.lower }}_create(void);
#endif
{%- if !hooks.is_empty() %}

/*
 * Functions that the application defines. They take the value of `req` with co_sub_on_dn(), or provide it with co_sub_on_up(), and
 * return 0 or an abort code. A download calls them for each segment; co_sub_on_dn() returns 0 when the value is complete.
 */
{%- for hook in hooks %}
{%- if !hook.written.is_empty() %}
co_unsigned32_t {{ head.lower }}_hook{{ hook.index|hex4 }}_dn(co_sub_t *sub, struct co_sdo_req *req, void *data);
{%- endif %}
{%- if !hook.read.is_empty() %}
co_unsigned32_t {{ head.lower }}_hook{{ hook.index|hex4 }}_up(const co_sub_t *sub, struct co_sdo_req *req, void *data);
{%- endif %}
{%- endfor %}

/* Has the library call them, with this `data`, for a device of the table. Call it once the device exists. */
void {{ head.lower }}_init_hooks(co_dev_t *dev, void *data);
{%- endif %}

#ifdef __cplusplus
}
#endif

#endif
