//! View of templates/c/_defaults.h: constants of identity and services.

use crate::defaults::{Constant, ConstantValue};
use crate::model::CobId;

/// Follows the prefix in each name.
const OF_DEFAULTS: &str = "default_";

/// A macro.
pub(super) struct DefaultMacro {
    pub(super) meaning: String,
    /// The name after the prefix, with the parameter of a function-like macro.
    pub(super) name: String,
    pub(super) value: String,
}

/// The macros of a constant.
pub(super) fn item_views(constant: &Constant) -> Vec<DefaultMacro> {
    let Constant { name, source, meaning, value } = constant;
    let meaning = format!("{meaning} ({source})");
    let upper = format!("{OF_DEFAULTS}{name}").to_ascii_uppercase();
    let item = |name: String, meaning: String, value: String| DefaultMacro { meaning, name, value };
    match value {
        ConstantValue::CobId(cob_id) | ConstantValue::CanId(cob_id) => {
            let is_can_id = matches!(value, ConstantValue::CanId(_));
            let value = of_node(*cob_id, is_can_id.then(|| cob_id.can_id_mask()));
            vec![item(format!("{upper}(node_id)"), meaning, value)]
        }
        ConstantValue::Flag(flag) => vec![item(upper, meaning, u8::from(*flag).to_string())],
        ConstantValue::Code(number) => vec![item(upper, meaning, format!("0x{number:X}u"))],
        ConstantValue::Number(number, _) => vec![item(upper, meaning, format!("{number}u"))],
        ConstantValue::Consumers(consumers) => {
            let pairs: Vec<String> =
                consumers.iter().map(|(node, time)| format!("{{{node}u, {time}u}}")).collect();
            let count = format!("{upper}_COUNT");
            let meaning = format!("{meaning}: an initializer");
            vec![
                item(count, format!("How many nodes there are ({source})"), format!("{}u", pairs.len())),
                item(upper, meaning, format!("{{{}}}", pairs.join(", "))),
            ]
        }
    }
}

/// A number, or some bits of it, as an expression of the node-ID.
pub(super) fn of_node(cob_id: CobId, mask: Option<u32>) -> String {
    let number = cob_id.number();
    match (cob_id.depends_on_node_id(), mask) {
        (true, None) => format!("(0x{number:X}u + (uint32_t)(node_id))"),
        (true, Some(mask)) => format!("((0x{number:X}u + (uint32_t)(node_id)) & 0x{mask:X}u)"),
        (false, mask) => format!("0x{:X}u", number & mask.unwrap_or(u32::MAX)),
    }
}
