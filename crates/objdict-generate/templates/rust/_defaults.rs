/// Default values of identity and services, decoded. COB-IDs are functions of the node-ID. `Data`
/// contains the present values.
#[allow(dead_code, unreachable_pub)]
#[allow(clippy::arithmetic_side_effects, clippy::cast_lossless)]
#[rustfmt::skip]
pub mod defaults {
{%- for item in defaults %}
{%- if !loop.first %}
{% endif %}
    /// {{ item.meaning }}.
{%- if let Some(uses_node_id) = item.function %}
    #[must_use]
    pub const fn {{ item.name }}({% if !uses_node_id %}_{% endif %}node_id: u8) -> {{ item.type_ }} {
        {{ item.value }}
    }
{%- else %}
    pub const {{ item.name }}: {{ item.type_ }} = {{ item.value }};
{%- endif %}
{%- endfor %}
}
