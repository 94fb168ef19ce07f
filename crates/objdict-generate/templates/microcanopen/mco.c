{# MicroCanOpenView<'_>::source #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Tables of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for MicroCANopen.
 */
#include "{{ head.stem }}_pimg.h"

/* The variable values, which PDOs may map. */
UNSIGNED8 gProcImg[PROCIMG_SIZE];

/* Replies to SDO requests, 8 bytes each, with an end mark. */
UNSIGNED8 MEM_CONST SDOResponseTable[] = {
{%- for reply in replies %}
    {{ reply.row }}, /* {{ reply.described|c_comment }} */
{%- endfor %}
    SDOREPLY(0xFFFF, 0xFF, 0xFF, 0xFFFFFFFFL)
};

/* Entries of the process image, with an end mark. */
OD_PROCESS_DATA_ENTRY MEM_CONST gODProcTable[] = {
{%- for entry in image.entries %}
    ODENTRY(0x{{ entry.index|hex4 }}, 0x{{ entry.entry.sub|hex2 }}, {{ entry.flags() }}, P_{{ entry.name }}_OFF),
{%- endfor %}
    ODENTRY(0xFFFF, 0xFF, 0xFF, 0xFF)
};

/* Sets the process image to the defaults of the description. */
void {{ head.lower }}_init_image(void)
{
    unsigned at;
    for (at = 0; at < PROCIMG_SIZE; at++) {
        gProcImg[at] = 0;
    }
{%- for (offset, value) in self.defaults() %}
    gProcImg[{{ offset }}] = {{ value }};
{%- endfor %}
}

/* Initialises the PDOs; call it in MCOUSER_ResetCommunication() after MCO_Init(). */
void {{ head.lower }}_init_pdos(void)
{
{%- for call in calls %}
    MCO_Init{{ call.kind }}({{ call.number }}, {% if let Some((id, is_added)) = call.can_id %}0x{{ "{:03X}"|format(id) }}{% if *is_added %} + {{ self.node_id() }}{% endif %}{% else %}0{% endif %}
    {%- if call.kind == PdoKind::Tpdo %}, {{ call.event }}, {{ call.inhibit }}{% endif %}, {{ call.length }}, {{ call.offset }});
{%- endfor %}
}
