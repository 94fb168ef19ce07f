//! Storage groups: structs of values that CANopenNode stores together.

use super::names::word;
use crate::dictionary::ResolvedObject;
use crate::{Options, StackLayout};

/// Names not available for groups: `OD_<name>` and `OD_<name>_t` have another meaning.
const TAKEN: &str = "t size attr entry stream io extension attributes applyNodeId initHooks initLimits writeLimited H DEFINITION";

/// Prefixes of other macros of the tables.
const BEGINS: [&str; 8] = ["read_", "write_", "CNT_", "ENTRY_", "ATTR_", "FLAGS_", "obj_", "INIT_"];

/// The group of an object: from the description, else from the options, else by index.
pub(super) fn group(object: &ResolvedObject<'_>, options: &Options) -> String {
    match (object.group(options), options.layout) {
        (Some(name), _) => identifier(name),
        (None, StackLayout::Complete) => by_index(object.index).to_owned(),
        (None, _) => "RAM".to_owned(),
    }
}

/// Communication parameters are stored by default; commands, states and application values are not.
fn by_index(index: u16) -> &'static str {
    match index {
        0x1001..=0x1003 | 0x1010 | 0x1011 | 0x1020..=0x1027 | 0x1200 | 0x1F50..=0x1F57 => "RAM",
        0x1000..=0x1FFF => "PERSIST_COMM",
        _ => "RAM",
    }
}

fn identifier(name: &str) -> String {
    let name = word(name);
    let taken = TAKEN.split_ascii_whitespace().any(|taken| taken.eq_ignore_ascii_case(&name));
    if taken || BEGINS.iter().any(|begin| name.starts_with(begin)) { format!("{name}_") } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_identifiers() {
        assert_eq!(identifier("PERSIST_APP"), "PERSIST_APP");
        assert_eq!(identifier(" my group\u{e9}"), "my_groupe");
        assert_eq!(identifier("size"), "size_");
        assert_eq!(identifier("ENTRY_H1000"), "ENTRY_H1000_");
        assert_eq!(by_index(0x1003), "RAM");
        assert_eq!(by_index(0x1400), "PERSIST_COMM");
        assert_eq!(by_index(0x2000), "RAM");
        assert_eq!([by_index(0x1F51), by_index(0x1F80)], ["RAM", "PERSIST_COMM"]);
    }
}
