//! View of templates/c/_defaults.h: constants of identity and services.

use askama::Template;

use crate::defaults::{Constant, ConstantValue};
use crate::model::CobId;
use crate::names::Scope;

/// Follows the prefix in each name.
const OF_DEFAULTS: &str = "default_";

/// The macros.
#[derive(Template)]
#[template(path = "c/_defaults.h", escape = "none")]
pub(super) struct Defaults {
    upper: String,
    items: Vec<ItemView>,
}

/// A macro.
struct ItemView {
    meaning: String,
    /// The name after the prefix, with the parameter of a function-like macro.
    name: String,
    value: String,
}

impl Defaults {
    pub(super) fn new(constants: &[Constant], prefix: &str) -> Self {
        let items = constants.iter().flat_map(item_views).collect();
        Self { upper: prefix.to_ascii_uppercase(), items }
    }
}

/// Reserves the macro names, so that no object gets one of them.
pub(super) fn take_names(constants: &[Constant], macros: &mut Scope) {
    for item in constants.iter().flat_map(item_views) {
        let name = item.name.split('(').next().unwrap_or_default();
        macros.take(name.to_ascii_lowercase());
    }
}

fn item_views(constant: &Constant) -> Vec<ItemView> {
    let Constant { name, source, meaning, value } = constant;
    let meaning = format!("{meaning} ({source})");
    let upper = format!("{OF_DEFAULTS}{name}").to_ascii_uppercase();
    let item = |name: String, meaning: String, value: String| ItemView { meaning, name, value };
    match value {
        ConstantValue::CobId(cob_id) => {
            vec![item(format!("{upper}(node_id)"), meaning, of_node(*cob_id, None))]
        }
        ConstantValue::CanId(cob_id) => {
            let value = of_node(*cob_id, Some(cob_id.can_id_mask()));
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
