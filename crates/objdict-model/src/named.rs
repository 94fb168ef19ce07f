//! Enums whose variants have names.

/// Declares an enum and the names of its variants in one table, which provides `name`, `Display` and the lookup in
/// `ALL`. A variant can have a code.
#[macro_export]
macro_rules! named {
    ($(#[$about:meta])* pub enum $Name:ident {
        $($(#[$of_variant:meta])* $Variant:ident $((code $code:literal))? = $name:literal,)+
    }) => {
        $(#[$about])*
        pub enum $Name {
            $($(#[$of_variant])* $Variant $(= $code)?,)+
        }

        impl $Name {
            /// Every variant, in the order of their declaration.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$Variant),+];

            /// The name of the variant.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Variant => $name,)+
                }
            }
        }

        impl std::fmt::Display for $Name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.name())
            }
        }
    };
}
