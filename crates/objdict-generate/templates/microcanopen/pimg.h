{# MicroCanOpenView<'_>::header #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * Process image of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}, for MicroCANopen.
 */
#ifndef {{ head.upper }}_PIMG_H
#define {{ head.upper }}_PIMG_H

#include "mco.h"

/* The node-ID in SDO replies that depend on it. */
#ifndef {{ head.upper }}_NODE_ID
#define {{ head.upper }}_NODE_ID {{ dictionary.node_id.unwrap_or(1) }}
#endif

/* Heartbeat time in milliseconds, for MCO_Init(). */
#define {{ head.upper }}_HEARTBEAT {{ self.heartbeat() }}

/* Offsets in the process image; values are little-endian. */
{%- for entry in self.placed() %}
#define P_{{ entry.name }}_OFF {{ entry.place() }} /* {{ entry.index|hex4 }}h sub-index {{ entry.entry.sub|hex2 }}h, {{ entry.size }} byte{% if entry.size != 1 %}s{% endif %}: {{ entry.entry.entry.name|c_comment }} */
{%- endfor %}

/* Size of the process image in bytes, at least one. */
#define PROCIMG_SIZE {% if image.size > 0 %}{{ image.size }}{% else %}1{% endif %}

/* Sets the process image to the defaults of the description. */
void {{ head.lower }}_init_image(void);

/* Initialises the PDOs; call it in MCOUSER_ResetCommunication() after MCO_Init(). */
void {{ head.lower }}_init_pdos(void);

#endif
