//! The target `canopennode`.

use crate::{beside, checkout};

#[test]
fn the_declarations_are_there() {
    assert!(beside("canopennode", "include/301/CO_ODinterface.h").is_file());
    let stack = checkout("OBJDICT_CANOPENNODE_DIR");
    assert!(stack.is_none_or(|stack| stack.join("301/CO_ODinterface.h").is_file()));
}
