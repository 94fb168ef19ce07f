//! View of templates/rust/_defaults.rs: constants of identity and services.

use super::literal::{grouped, hex};
use crate::defaults::{Constant, ConstantValue};
use crate::model::CobId;

/// A constant or a function.
pub(super) struct ItemView {
    /// Its meaning and its source.
    pub(super) meaning: String,
    /// For a function, whether it uses its argument.
    pub(super) function: Option<bool>,
    pub(super) name: String,
    pub(super) type_: String,
    /// An expression.
    pub(super) value: String,
}

pub(super) fn item_view(constant: &Constant) -> ItemView {
    let Constant { name, source, meaning, value } = constant;
    let of_cob_id =
        |cob_id: CobId, mask| (Some(cob_id.depends_on_node_id()), "u32".to_owned(), of_node(cob_id, mask));
    let (function, type_, value) = match value {
        ConstantValue::CobId(cob_id) => of_cob_id(*cob_id, None),
        ConstantValue::CanId(cob_id) => of_cob_id(*cob_id, Some(cob_id.can_id_mask())),
        ConstantValue::Flag(flag) => (None, "bool".to_owned(), flag.to_string()),
        ConstantValue::Code(number) => (None, "u32".to_owned(), hex((*number).into())),
        ConstantValue::Number(number, bits) => (None, format!("u{bits}"), grouped(&number.to_string(), 3)),
        ConstantValue::Consumers(consumers) => {
            let list: Vec<String> =
                consumers.iter().map(|(node, time)| format!("({node}, {time})")).collect();
            (None, format!("[(u8, u16); {}]", list.len()), format!("[{}]", list.join(", ")))
        }
    };
    let name = if function.is_some() { name.clone() } else { name.to_ascii_uppercase() };
    let source = if source.starts_with("CiA") { format!("`CiA` {}", &source[4..]) } else { source.clone() };
    ItemView { meaning: format!("{meaning} ({source})"), function, name, type_, value }
}

/// A number, or some bits of it, as an expression of the node-ID.
pub(super) fn of_node(cob_id: CobId, mask: Option<u32>) -> String {
    let number = cob_id.number();
    match (cob_id.depends_on_node_id(), mask) {
        (true, None) => format!("{} + node_id as u32", hex(number.into())),
        (true, Some(mask)) => format!("({} + node_id as u32) & {}", hex(number.into()), hex(mask.into())),
        (false, mask) => hex((number & mask.unwrap_or(u32::MAX)).into()),
    }
}
