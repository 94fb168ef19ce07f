/* Default values of identity and services, decoded. COB-IDs depend on the node-ID. */
{%- for item in defaults %}
#define {{ upper }}_{{ item.name }} {{ item.value }} /**< {{ item.meaning }} */
{%- endfor %}
