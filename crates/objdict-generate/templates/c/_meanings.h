{% if !enums.is_empty() -%}
/* What values of entries mean, as the description names them. */
{%- for view in enums %}

/* {{ view.of.title|c_comment }}: {{ view.entries }} */
{%- for value in view.values %}
#define {{ upper }}_{{ value.name|upper }} {{ value.number }} /* {{ value.label|c_comment }} */
{%- endfor %}
{%- endfor %}
{%- if !words.is_empty() %}

{% endif %}
{%- endif %}
{%- if !words.is_empty() -%}
/* Parts of the words that entries hold: ..._GET(word) takes one out, ..._WITH(word, value) gives the word with another one,
   of whose bits the lowest count. */
{%- for view in words %}

/* {{ view.of.title|c_comment }}: {{ view.entries }} */
{%- for part in view.parts %}
#define {{ part.name }}_SHIFT {{ part.of.first }}u /* {{ part.of.label|c_comment }} */
#define {{ part.name }}_BITS {{ part.of.bits }}u
#define {{ part.name }}_MASK {{ part.mask }}
#define {{ part.name }}_GET(word) {{ part.get }}
#define {{ part.name }}_WITH(word, value) {{ part.with }}
{%- endfor %}
{%- endfor %}
{%- endif %}
