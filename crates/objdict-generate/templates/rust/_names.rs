/// The name of each entry in the description; not part of the program unless used.
{%- if gates %}
#[cfg(feature = "od-names")]
{%- endif %}
#[allow(dead_code)]
#[rustfmt::skip]
static NAMES: [&str; {{ rows.len() }}] = [
{%- for view in rows %}
    {{ view.row.name|rust_text }},
{%- endfor %}
];

{% if gates -%}
#[cfg(feature = "od-names")]
{% endif -%}
#[allow(dead_code, unreachable_pub)]
impl Entry {
    /// The name in the description.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match ENTRIES.binary_search_by_key(&self.key(), Self::key) {
            Ok(row) => NAMES.get(row).copied().unwrap_or(""),
            Err(_) => "",
        }
    }
}
