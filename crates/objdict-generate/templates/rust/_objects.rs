{# ObjectModules<'_>::text #}
{% for area in areas -%}
{%- if !loop.first %}
{% endif -%}
#[allow(unused_imports, unreachable_pub)]
pub use self::{{ area.name }}::*;

/// {{ area.title }}: `0x{{ area.first|hex4 }}` to `0x{{ area.last|hex4 }}`.
#[allow(dead_code, unreachable_pub, unused_imports, clippy::wildcard_imports)]
#[rustfmt::skip]
pub mod {{ area.name }} {
    use super::*;
{%- for view in area.objects %}
{% if view.object.single %}
{%- let handle = view.handles[0] %}
    /// `0x{{ view.object.index|hex4 }}`: {{ handle.doc }}.
    pub const {{ handle.name }}: Handle<{{ handle.type_of() }}, {{ self::access(handle.row) }}> = Handle::of(0x{{ view.object.index|hex4 }}, 0x{{ handle.row.sub|hex2 }});
{%- else %}
{%- if let Some(array) = view.array %}
    /// `0x{{ view.object.index|hex4 }}`: {{ view.object.name|code_span }}, by sub-index.
    pub const {{ array.name }}: Array<{{ array.type_ }}, {{ array.access }}> = Array::of(0x{{ view.object.index|hex4 }}, {{ array.length }});
{% endif %}
    /// `0x{{ view.object.index|hex4 }}`: {{ view.object.name|code_span }}.
    pub mod {{ view.object.module }} {
        use super::*;

        /// Index of the object.
        pub const INDEX: u16 = 0x{{ view.object.index|hex4 }};
{%- for handle in view.handles %}
        /// Sub-index `0x{{ handle.row.sub|hex2 }}`: {{ handle.doc }}.
        pub const {{ handle.name }}: Handle<{{ handle.type_of() }}, {{ self::access(handle.row) }}> = Handle::of(INDEX, 0x{{ handle.row.sub|hex2 }});
{%- endfor %}
    }
{%- endif %}
{%- endfor %}
}
{% endfor %}
