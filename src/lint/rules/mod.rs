//! The rules about the model, one file each. A new rule is a file and a line here.

macro_rules! rules {
    ($($group:ident { $($rule:ident,)* })*) => {
        $(mod $group { $(pub(super) mod $rule;)* })*

        /// Every rule about the model.
        pub(crate) static RULES: &[&crate::lint::Rule] = &[$($(&$group::$rule::RULE,)*)*];
    };
}

rules! {
    cia306 {
        invalid_value,
        sub_without_object,
    }
}
