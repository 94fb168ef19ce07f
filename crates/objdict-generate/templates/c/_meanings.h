{# MeaningMacros<'_>::text #}
{% if !enums.is_empty() -%}
/* Named values of entries. With ..._MASK, the value is that of these bits; any others are possible. */
{%- for view in enums %}

/** {{ view.of.title|doxygen }}: {{ self::entries(&view.of.entries) }} */
{%- for value in view.values %}
#define {{ upper }}_{{ value.name|upper }} {{ value.number }} /**< {{ value.label|doxygen }} */
{%- endfor %}
{%- endfor %}
{%- if !words.is_empty() %}

{% endif %}
{%- endif %}
{%- if !words.is_empty() -%}
/* Bit fields of entries: ..._GET(word) extracts the value, ..._WITH(word, value) returns the word with a new value, of which
   only the lowest bits are used. */
{%- for view in words %}

/** {{ view.of.title|doxygen }}: {{ self::entries(&view.of.entries) }} */
{%- for part in view.parts %}
#define {{ part.name }}_SHIFT {{ part.of.first }}u /**< {{ part.of.label|doxygen }} */
#define {{ part.name }}_BITS {{ part.of.bits }}u
#define {{ part.name }}_MASK {{ part.mask }}
#define {{ part.name }}_GET(word) {{ part.get }}
#define {{ part.name }}_WITH(word, value) {{ part.with }}
{%- endfor %}
{%- endfor %}
{%- endif %}
