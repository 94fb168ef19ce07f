//! The file of `network build --lock`: TOML that objdict writes and reads.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use objdict_keyed::section::{Key, KeyedTable, Shape, bits, integer, key};
use objdict_keyed::toml;
use objdict_model::diagnostic::Findings;
use objdict_model::json::quoted;
use objdict_model::model::{MappedObject, PdoKind};
use objdict_network::{Compiled, LockedPdo, Network, NetworkLock, mirrored_numbers};
use objdict_node::configure::PdoName;

const LOCK: &[Key] = &[key("pdo", Shape::List(PDO), "The PDOs of the network that was built.")];

const NUMBER: Shape = Shape::Integer(1, 512);
const MAPPING: (i128, i128) = (0, u32::MAX as i128);

const PDO: &[Key] = &[
    key("node", Shape::Text, "The name of the node."),
    key("kind", Shape::Word(&["rpdo", "tpdo"]), "The direction, from the view of the node."),
    key("number", NUMBER, "The PDO number."),
    key("can-id", bits(29), "The CAN-ID."),
    key("map", Shape::Numerals(MAPPING.0, MAPPING.1), "The mapped objects, as in 1600h and 1A00h."),
    key("manager", NUMBER, "The number of the PDO at the other side, in a manager without a description."),
];

/// The PDOs of a network that is built.
pub(super) fn locked(network: &Network, compiled: &Compiled) -> NetworkLock {
    let numbers =
        [PdoKind::Rpdo, PdoKind::Tpdo].map(|kind| mirrored_numbers(network, &compiled.slaves, kind));
    let numbers: BTreeMap<_, _> =
        numbers.into_iter().flatten().map(|(slave, pdo, number)| ((slave.node, pdo), number)).collect();
    // the PDOs of a generated manager are counterparts
    let pdos = compiled.nodes().filter(|slave| !network.is_made(slave.node)).flat_map(|slave| {
        let name = &network.nodes[slave.node].name.value;
        let active = slave.pdos.iter().filter(|state| state.is_active());
        active.map(|state| {
            let locked = LockedPdo {
                can_id: state.can_id().number,
                mapping: state.mapping.values().copied().collect(),
                manager: numbers.get(&(slave.node, state.pdo)).copied(),
            };
            ((name.clone(), state.pdo), locked)
        })
    });
    NetworkLock(pdos.collect())
}

/// Reads a lock. Invalid content is a finding.
pub fn read_lock(text: &str, findings: &mut Findings) -> NetworkLock {
    let tree = toml::read(text, findings);
    let table = tree.as_ref().and_then(|tree| KeyedTable::new("the lock", tree, LOCK, findings));
    let items = table.as_ref().and_then(|table| table.list("pdo", findings)).unwrap_or_default();
    let mut pdo = |item| {
        let table = KeyedTable::new("pdo", item, PDO, findings)?;
        for name in ["node", "kind", "number", "can-id", "map"] {
            table.required("pdo", name, findings)?;
        }
        let node = table.text("node", findings)?.value;
        let kind = table.word("kind", findings)?.value;
        let kind = if kind == "rpdo" { PdoKind::Rpdo } else { PdoKind::Tpdo };
        let number = table.integer("number", findings)?.value;
        let mapping = table.list("map", findings)?.iter().map(|item| {
            let number = integer("map", item, MAPPING, findings)?;
            Some(MappedObject::from_number(u32::try_from(number).ok()?))
        });
        let mapping = mapping.collect::<Option<_>>()?;
        let can_id = table.integer("can-id", findings)?.value;
        let manager = table.integer("manager", findings).map(|number| number.value);
        Some(((node, PdoName { kind, number }), LockedPdo { can_id, mapping, manager }))
    };
    NetworkLock(items.iter().filter_map(&mut pdo).collect())
}

/// The text of a lock.
pub fn write_lock(lock: &NetworkLock) -> String {
    let mut text =
        "# CAN-IDs and PDOs that `objdict network build --lock` keeps; add this file to version control\n"
            .to_owned();
    for ((node, PdoName { kind, number }), locked) in &lock.0 {
        let mapping: Vec<String> =
            locked.mapping.iter().map(|object| format!("0x{:08X}", object.to_number())).collect();
        let _ = write!(
            text,
            "\n[[pdo]]\nnode = {}\nkind = \"{}\"\nnumber = {number}\ncan-id = 0x{:X}\nmap = [{}]\n",
            quoted(node),
            kind.to_string().to_lowercase(),
            locked.can_id,
            mapping.join(", "),
        );
        if let Some(number) = locked.manager {
            let _ = writeln!(text, "manager = {number}");
        }
    }
    text
}
