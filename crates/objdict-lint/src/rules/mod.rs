//! The rules about the model, one file per topic: a new rule is a row of `rules!` in its file and a check. Rules that
//! only add a page to a shared check are in `demands.rs` of their group.

use crate::Rule;

macro_rules! groups {
    ($($(#[$when:meta])? $group:ident $(: $demands:ident)? { $($file:ident,)* })*) => {
        $(
            $(#[$when])?
            mod $group {
                $(pub(super) mod $demands;)?
                $(pub(super) mod $file;)*

                const FILES: &[&[&crate::Rule]] = &[$($demands::RULES,)? $($file::RULES,)*];
                pub(super) static RULES: [&crate::Rule; super::count(FILES)] =
                    super::in_order(FILES, super::count(&[$($demands::RULES)?]));
            }
        )*

        /// The groups by name.
        static RULES: &[(&str, &[&Rule])] = &[$($(#[$when])? (stringify!($group), &$group::RULES),)*];
    };
}

pub(crate) use self::cia306::lists::renumbered;
pub use self::cia306::lists::without_disabled;
pub(crate) use self::configuration::entries::is_same as is_same_product;

/// Every rule about the model.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    rules_of(|_| true)
}

/// The rules of some groups.
pub(crate) fn rules_of(is_meant: impl Fn(&str) -> bool) -> impl Iterator<Item = &'static Rule> {
    let groups = RULES.iter().filter(move |(group, _)| is_meant(group));
    groups.flat_map(|(_, rules)| rules.iter().copied())
}

/// The number of rules in the files of a group.
const fn count(files: &[&[&Rule]]) -> usize {
    let (mut count, mut file) = (0, 0);
    while file < files.len() {
        count += files[file].len();
        file += 1;
    }
    count
}

/// The rules of a group in the order of their checks and pages: the `first` ones as in their file, the
/// others by name. The compiler sorts them, because sorting takes 3 % of the instructions for a small file.
const fn in_order<const COUNT: usize>(files: &[&[&'static Rule]], first: usize) -> [&'static Rule; COUNT] {
    let mut rules = [files[0][0]; COUNT];
    let (mut count, mut file) = (0, 0);
    while file < files.len() {
        let mut row = 0;
        while row < files[file].len() {
            let mut at = count;
            while at > first && is_after(rules[at - 1], files[file][row]) {
                rules[at] = rules[at - 1];
                at -= 1;
            }
            rules[at] = files[file][row];
            (count, row) = (count + 1, row + 1);
        }
        file += 1;
    }
    rules
}

const fn is_after(one: &Rule, other: &Rule) -> bool {
    let (one, other) = (one.info.id.as_bytes(), other.info.id.as_bytes());
    let mut at = 0;
    while at < one.len() && at < other.len() && one[at] == other[at] {
        at += 1;
    }
    at < one.len() && (at == other.len() || one[at] > other[at])
}

groups! {
    cia301: demands {
        cob_ids,
        emergency,
        error_control,
        identity,
        mapped_objects,
        pdo_mapping,
        pdo_parameters,
        sdos,
        storage,
        sync,
    }
    #[cfg(feature = "catalogue")]
    cia302: demands {
        managers,
    }
    #[cfg(feature = "catalogue")]
    cia304 {
        mapping,
        parameters,
    }
    #[cfg(feature = "catalogue")]
    cia305 {
        lss,
    }
    cia306 {
        configured_values,
        connected_modules,
        device_info,
        file_info,
        keys,
        lists,
        modules,
        pdos,
        sub_indexes,
        types,
        values,
    }
    #[cfg(feature = "catalogue")]
    cia311 {
        application_process,
    }
    #[cfg(feature = "catalogue")]
    cia401: demands {
        channels,
    }
    #[cfg(feature = "catalogue")]
    cia402: demands {
        companions,
        limits,
        mapping,
        modes,
        values,
    }
    #[cfg(feature = "catalogue")]
    cia404: demands {
        channels,
    }
    #[cfg(feature = "catalogue")]
    cia406: demands {
        functions,
        measuring_range,
    }
    #[cfg(feature = "catalogue")]
    custom: demands {}
    #[cfg(feature = "catalogue")]
    naming {
        wording,
    }
    #[cfg(feature = "catalogue")]
    portability {
        compact,
        sections,
    }
    configuration {
        entries,
    }
}
