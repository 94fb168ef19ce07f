{# PdoFiles<'_>::header #}
/**
 * @file
 * {{ table.head.made_by }}; do not edit.
 *
 * The default mapping of PDOs: one struct per PDO with its members in frame order.
 *
 * {{ lower }}_..._load() reads the values from the dictionary, {{ lower }}_..._store() writes them without checking
 * limits; {{ lower }}_..._pack() and {{ lower }}_..._unpack() convert them to a frame and back.
{%- if !are_fixed %}
 *
 * SDOs can write the mappings, but the structs keep these: the application transfers a PDO with another one with {{ lower }}_read()
 * and {{ lower }}_write().
{%- endif %}
 */
#ifndef {{ upper }}_PDO_H
#define {{ upper }}_PDO_H

#include "{{ stem }}.h"

#ifndef {{ upper }}_NO_PDO

#ifdef __cplusplus
extern "C" {
#endif
{%- for frame in frames %}

/** {{ frame.frame.title }} ({{ frame.frame.communication_index|hex4 }}h, {{ frame.frame.mapping_index|hex4 }}h) */
#define {{ frame.macro_prefix }}_LENGTH {{ frame.frame.length }}u
{%- if let Some(transmission_type) = frame.frame.transmission_type %}
#define {{ frame.macro_prefix }}_TRANSMISSION_TYPE {{ transmission_type }}u
{%- endif %}
{%- if let Some(cob_id) = frame.cob_id %}
#define {{ frame.macro_prefix }}_COB_ID(node_id) {{ cob_id }}
{%- endif %}

typedef struct {
{%- for field in frame.fields %}
    {{ field.declaration }}; /**< {{ field.row.index|hex4 }}h sub-index {{ field.row.sub|hex2 }}h: {{ field.row.name|doxygen }} */
{%- endfor %}
} {{ frame.type_name }}_t;

void {{ frame.type_name }}_load(const {{ lower }}_data_t *data, {{ frame.type_name }}_t *pdo);
void {{ frame.type_name }}_store(const {{ frame.type_name }}_t *pdo, {{ lower }}_data_t *data);
void {{ frame.type_name }}_pack(const {{ frame.type_name }}_t *pdo, uint8_t frame[{{ frame.frame.length }}]);
void {{ frame.type_name }}_unpack(const uint8_t frame[{{ frame.frame.length }}], {{ frame.type_name }}_t *pdo);
{%- endfor %}

#ifdef __cplusplus
}
#endif

#endif /* {{ upper }}_NO_PDO */

#endif
