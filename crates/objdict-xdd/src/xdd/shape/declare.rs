//! How the parts of CiA 311 are declared: once, for reading and for writing.
//!
//! ```text
//! shape! {
//!     Led ["LEDcolors" = colors, "LEDtype" = kind] {
//!         _ => labels,
//!         "LEDstate" => states,
//!     }
//! }
//! ```
//! In brackets stand the attributes, in braces the children in the order of the schema:
//!
//! | | |
//! |---|---|
//! | `"name" = field` | an attribute ([`AttributeField`](super::AttributeField)); `"#text"` is the text of the element |
//! | `"name" => field` | elements that are parts themselves ([`ChildField`](super::ChildField)): one, an optional one, a list |
//! | `"name" @ "attribute" => field` | elements that hold one value ([`ValueField`](super::ValueField)) in an attribute, or as `"#text"` |
//! | `_ => field` | elements of several names that belong to one field ([`Group`](super::Group)), such as labels |
//! | `"name" => { … }` | an element around other ones, which is not written when it would be empty |
//! | `"name" => [ … ]` | the same, always written, because the schema demands it |
//!
//! A field that is not mentioned does not compile, and what is not mentioned in a file goes to the
//! [`Leftovers`](crate::xdd::leftovers::Leftovers).

/// Declares how parts stand in an element each.
macro_rules! shape {
    ($($Part:ident $attributes:tt $children:tt)+) => {$(
        impl $crate::xdd::shape::Shape for $Part {
            fn read<'a>(
                element: $crate::xml::Element<'a>,
                leftovers: &mut $crate::xdd::leftovers::Leftovers<'a>,
            ) -> Self {
                let mut part = Self::default();
                let fields!($Part $attributes $children) = &mut part;
                take!(element, leftovers, $attributes $children);
                part
            }

            fn write(&self, name: &str, out: &mut $crate::xdd::markup::Markup) {
                let fields!($Part $attributes $children) = self;
                put!(out, name, $attributes $children);
            }
        }
    )+};
}

/// Declares how the variants of a part stand in elements of different names. Behind the name stands the
/// variant, which is used as pattern and as value.
macro_rules! variants {
    ($Part:ident { $($name:literal => ($($variant:tt)+)
        [$($attribute:literal = $of:ident),*] {$($key:tt $(@ $holder:literal)? => $child:ident),*})+ }
    ) => {
        impl $crate::xdd::shape::Variant for $Part {
            fn read<'a>(
                element: $crate::xml::Element<'a>,
                leftovers: &mut $crate::xdd::leftovers::Leftovers<'a>,
            ) -> Option<Self> {
                match element.name() {
                    $($name => {
                        $(let mut $of = Default::default();)*
                        $(let mut $child = Default::default();)*
                        {
                            $(let $of = &mut $of;)*
                            $(let $child = &mut $child;)*
                            take!(element, leftovers,
                                [$($attribute = $of),*] {$($key $(@ $holder)? => $child),*});
                        }
                        Some($($variant)+)
                    })+
                    _ => None,
                }
            }

            fn write(&self, out: &mut $crate::xdd::markup::Markup) {
                match self {
                    $($($variant)+ => {
                        put!(out, $name, [$($attribute = $of),*] {$($key $(@ $holder)? => $child),*});
                    })+
                }
            }
        }
    };
}

/// The pattern of all fields that a declaration mentions.
macro_rules! fields {
    ($Part:ident [$($attributes:tt)*] {$($children:tt)*}) => {
        fields!(@ $Part [] $($attributes)* , $($children)*)
    };
    (@ $Part:ident [$($field:ident)*]) => { $Part { $($field),* } };
    (@ $Part:ident $fields:tt , $($rest:tt)*) => { fields!(@ $Part $fields $($rest)*) };
    (@ $Part:ident [$($field:ident)*] $name:literal = $next:ident $($rest:tt)*) => {
        fields!(@ $Part [$($field)* $next] $($rest)*)
    };
    (@ $Part:ident $fields:tt $name:literal => {$($inner:tt)*} $($rest:tt)*) => {
        fields!(@ $Part $fields $($inner)* , $($rest)*)
    };
    (@ $Part:ident $fields:tt $name:literal => [$($inner:tt)*] $($rest:tt)*) => {
        fields!(@ $Part $fields $($inner)* , $($rest)*)
    };
    (@ $Part:ident [$($field:ident)*] $key:tt $(@ $holder:literal)? => $next:ident $($rest:tt)*) => {
        fields!(@ $Part [$($field)* $next] $($rest)*)
    };
}

/// Reads an element into variables, which are `&mut` of the fields.
macro_rules! take {
    ($element:expr, $leftovers:expr, [$($name:literal = $field:ident),* $(,)?] $children:tt) => {{
        $crate::xdd::shape::read_attributes($element, $leftovers, |_name, _text| {
            false $(|| _name == $name && $crate::xdd::shape::AttributeField::accept($field, _text))*
        });
        take!(@children $element, $leftovers, $children);
    }};
    (@children $element:expr, $leftovers:expr, {$($key:tt $(@ $holder:literal)? => $field:tt),* $(,)?}) => {
        $crate::xdd::shape::read_children($element, $leftovers, |_child, _leftovers| {
            false $(|| take!(@child _child, _leftovers, $key $(@ $holder)? => $field))*
        });
    };
    (@child $child:ident, $leftovers:ident, $name:literal => {$($inner:tt)*}) => {
        $child.name() == $name && {
            take!($child, $leftovers, [] {$($inner)*});
            true
        }
    };
    (@child $child:ident, $leftovers:ident, $name:literal => [$($inner:tt)*]) => {
        take!(@child $child, $leftovers, $name => {$($inner)*})
    };
    (@child $child:ident, $leftovers:ident, _ => $field:ident) => {
        $crate::xdd::shape::Group::accept($field, $child, $leftovers)
    };
    (@child $child:ident, $leftovers:ident, $name:literal @ $holder:literal => $field:ident) => {
        $child.name() == $name
            && $crate::xdd::shape::ValueField::accept($field, $child, $holder, $leftovers)
    };
    (@child $child:ident, $leftovers:ident, $name:literal => $field:ident) => {
        $child.name() == $name && $crate::xdd::shape::ChildField::accept($field, $child, $leftovers)
    };
}

/// Writes an element from variables, which are `&` of the fields.
macro_rules! put {
    ($out:expr, $name:expr, [$($attribute:literal = $field:ident),* $(,)?] $children:tt) => {{
        $out.open($name);
        $($crate::xdd::shape::write_attribute($field, $attribute, $out);)*
        put!(@children $out, $children);
        $out.close();
    }};
    (@children $out:expr, {$($key:tt $(@ $holder:literal)? => $field:tt),* $(,)?}) => {
        $(put!(@child $out, $key $(@ $holder)? => $field);)*
    };
    (@child $out:expr, $name:literal => {$($inner:tt)*}) => {
        $out.open_unless_empty($name);
        put!(@children $out, {$($inner)*});
        $out.close();
    };
    (@child $out:expr, $name:literal => [$($inner:tt)*]) => {
        $out.open($name);
        put!(@children $out, {$($inner)*});
        $out.close();
    };
    (@child $out:expr, _ => $field:ident) => { $crate::xdd::shape::Group::write($field, $out) };
    (@child $out:expr, $name:literal @ $holder:literal => $field:ident) => {
        $crate::xdd::shape::ValueField::write($field, $name, $holder, $out)
    };
    (@child $out:expr, $name:literal => $field:ident) => {
        $crate::xdd::shape::ChildField::write($field, $name, $out)
    };
}
