{# ObjdictMacrosView<'_>::mapping #}
/*
 * {{ head.made_by }}; do not edit.
 *
 * PDO mapping of {{ head.product|c_comment }} by {{ head.vendor|c_comment }}.
 */
#include "objdict.h"
{%- let rpdos = self.of(PdoKind::Rpdo) %}
{%- if !rpdos.is_empty() %}

const PDO_MAP gRpdoMap[NUM_OF_RPDOS] = {
{%- for pdo in rpdos %}
    { /* RPDO {{ pdo.number }} */
        NUM_OF_MAP_ENTRIES({{ pdo.entries.len() }}),
        {
{%- for entry in pdo.entries %}
            {{ entry }},
{%- endfor %}
{%- for _ in 0..pdo.unused() %}
            VOID_MAP_ENTRY,
{%- endfor %}
        },
    },
{%- endfor %}
};
{%- endif %}
{%- let tpdos = self.of(PdoKind::Tpdo) %}
{%- if !tpdos.is_empty() %}

const PDO_MAP gTpdoMap[NUM_OF_TPDOS] = {
{%- for pdo in tpdos %}
    { /* TPDO {{ pdo.number }} */
        NUM_OF_MAP_ENTRIES({{ pdo.entries.len() }}),
        {
{%- for entry in pdo.entries %}
            {{ entry }},
{%- endfor %}
{%- for _ in 0..pdo.unused() %}
            VOID_MAP_ENTRY,
{%- endfor %}
        },
    },
{%- endfor %}
};
{%- endif %}
