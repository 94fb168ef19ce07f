/* What the dictionary says by default of the identity and the services of the node, decoded: COB-IDs need the node-ID. */
{%- for item in items %}
#define {{ upper }}_{{ item.name }} {{ item.value }} /* {{ item.meaning }} */
{%- endfor %}
