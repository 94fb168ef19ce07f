//! The keys of `network.toml`.

use objdict_keyed::notation::{ADDRESS, ADDRESSES, FACTOR, FACTOR_OR_TIME, LINK_END, TRANSMISSION_TYPE};
use objdict_keyed::section::{Key, Shape, bits, key};

/// A time in an object of this many bits, with the unit in nanoseconds.
const fn time(bits: u32, unit: u64) -> Shape {
    Shape::Time((1 << bits) - 1, unit)
}

const MILLISECONDS: Shape = time(16, 1_000_000);
const TENTHS: Shape = time(16, 100_000);
const NODE_ID: Shape = Shape::Integer(1, 127);
const NUMBERS: Shape = Shape::Numbers((1, 254), (0, 255));

const UNUSED_PDOS: Shape = Shape::Word(&["keep", "off"]);

const TRANSMISSION: &str = "The transmission type: `sync/1` to `sync/240`, `event`, `rtr`, or its number.";
const INHIBIT: &str = "The inhibit time: a text with a unit, or a number of 100 µs.";
const EVENT_TIMER: &str = "The event timer: a text with a unit, or a number of ms.";
const DEADLINE: &str = "Consumer timeout of the PDO: a text with a unit, or a number of ms.";
const HEARTBEAT: &str = "Producer heartbeat time (1017h): a text with a unit, or a number of ms.";
const WATCH: &str = "After how many producer heartbeat times others give it up: `1.5x`.";
const IDENTITY: Shape = Shape::Word(&["none", "vendor", "product", "revision", "serial"]);
const ERROR_BEHAVIOR: &str = "Reactions to classes of errors (1029h), by sub-index.";

pub(super) const NETWORK: &[Key] = &[
    key("bus", Shape::Map(BUS), "The network as a whole."),
    key("manager", Shape::Map(MANAGER), "The manager, which configures and starts the nodes (CiA 302-2)."),
    key("node", Shape::Named(NODE), "The nodes by their names."),
    key("type", Shape::Named(NODE), "Keys that several nodes have in common, by the name that nodes `use`."),
    key("link", Shape::List(LINK), "Which entries go where."),
];

pub(super) const BUS: &[Key] = &[
    key("name", Shape::Text, "The name of the network."),
    key("bit-rate", Shape::Integer(1, 1000), "The bit rate in kbit/s."),
    key(
        "manager",
        Shape::Text,
        "The node that is the manager. One without a description has its `id` in `manager`.",
    ),
    key(
        "sync",
        time(32, 1000),
        "Communication cycle period (1006h) of the manager: a text with a unit, or a number of µs.",
    ),
    key(
        "sync-window",
        time(32, 1000),
        "Synchronous window length (1007h): a text with a unit, or a number of µs.",
    ),
    key("sync-overflow", bits(8), "Synchronous counter overflow value (1019h)."),
    key(
        "identity",
        IDENTITY,
        "Which numbers of the nodes the manager checks before it boots them (1F84h to 1F88h).",
    ),
    key("unused-pdos", UNUSED_PDOS, "`off`: downloads switch off PDOs that no link and no key uses."),
    key(
        "run-time-folder",
        Shape::Text,
        "The folder in which the manager finds the configurations of the nodes when it runs.",
    ),
];

pub(super) const MANAGER: &[Key] = &[
    key("id", NODE_ID, "The node-ID of a manager without a description."),
    key("vendor-id", bits(32), "Vendor-ID (1018h:01)."),
    key("product-code", bits(32), "Product code (1018h:02)."),
    key("revision-number", bits(32), "Revision number (1018h:03)."),
    key("serial-number", bits(32), "Serial number (1018h:04)."),
    key("heartbeat", MILLISECONDS, HEARTBEAT),
    key("watch", Shape::Spelled(FACTOR), WATCH),
    key("watches-nodes", Shape::Flag, "Whether the manager monitors the nodes (1016h)."),
    key("time-cob-id", bits(32), "COB-ID of TIME (1012h)."),
    key("emcy-inhibit", TENTHS, "Inhibit time of EMCY (1015h): a text with a unit, or a number of 100 µs."),
    key(
        "nmt-inhibit",
        TENTHS,
        "Inhibit time of NMT commands (102Ah): a text with a unit, or a number of 100 µs.",
    ),
    key("error-behavior", NUMBERS, ERROR_BEHAVIOR),
    key("start", Shape::Flag, "Whether the manager becomes operational by itself."),
    key("start-nodes", Shape::Flag, "Whether the manager starts the nodes."),
    key("start-all-nodes", Shape::Flag, "Whether one command starts all nodes."),
    key("reset-all-nodes", Shape::Flag, "Whether all nodes are reset when a mandatory one fails."),
    key("stop-all-nodes", Shape::Flag, "Whether all nodes are stopped when a mandatory one fails."),
    key(
        "boot-time",
        time(32, 1_000_000),
        "The time in which all mandatory nodes boot (1F89h): a text with a unit, or a number of ms.",
    ),
];

pub(super) const NODE: &[Key] = &[
    key(
        "file",
        Shape::Text,
        "The file with the description, relative to this file; `plant.nxdc#2` is the second device of a file with several, `family.toml#io8` a variant.",
    ),
    key("id", NODE_ID, "The node-ID; that of the description without this key."),
    key("use", Shape::Text, "The `type` whose keys it has too, where it does not have them itself."),
    key(
        "modules",
        Shape::Numerals(1, 0xFFFF),
        "The modules that are plugged, in order, by their numbers in the description.",
    ),
    key("heartbeat", MILLISECONDS, HEARTBEAT),
    key("watch", Shape::Spelled(FACTOR), WATCH),
    key("watches-manager", Shape::Flag, "Whether the node monitors the manager (1016h)."),
    key(
        "watches",
        Shape::SpelledByName(FACTOR_OR_TIME),
        "Further nodes that it monitors: `1.5x` or `500ms`.",
    ),
    key("guard-time", MILLISECONDS, "Guard time (100Ch): a text with a unit, or a number of ms."),
    key("life-time-factor", bits(8), "Life time factor (100Dh)."),
    key("time-cob-id", bits(32), "COB-ID of TIME (1012h)."),
    key("error-behavior", NUMBERS, ERROR_BEHAVIOR),
    key("set", Shape::Values, "Values by entry, as `objdict configure --set` takes them."),
    key("rpdo", Shape::Numbered(1, 512, PDO), "RPDOs that links leave alone, by PDO number."),
    key("tpdo", Shape::Numbered(1, 512, PDO), "TPDOs that links leave alone, by PDO number."),
    key("unused-pdos", UNUSED_PDOS, "`off`: downloads switch off its PDOs that no link and no key uses."),
    key("sdo", Shape::List(SDO), "Downloads at the end of the configuration, in this order."),
    key("boot", Shape::Flag, "Whether the manager configures and starts the node."),
    key("mandatory", Shape::Flag, "Whether the network stops without the node."),
    key("reset-communication", Shape::Flag, "Whether the manager may reset a node that is operational."),
    key("retry-factor", bits(8), "How often an error control service may fail (1F81h)."),
    key("software-file", Shape::Text, "The program for the node (1F58h)."),
    key("software-version", bits(32), "The expected software identification (1F55h)."),
    key("restore", bits(8), "The sub-index of 1011h that restores the defaults (1F8Ah)."),
    key(
        "identity",
        IDENTITY,
        "Which numbers the manager checks before it boots the node; that of `bus` without this key.",
    ),
    key("revision-number", bits(32), "The expected revision number (1F87h)."),
    key("serial-number", bits(32), "The expected serial number (1F88h)."),
    key(
        "run-time-folder",
        Shape::Text,
        "The folder of the configuration of this node when the manager runs.",
    ),
];

pub(super) const PDO: &[Key] = &[
    key("enabled", Shape::Flag, "Whether the PDO is valid in the end."),
    key(
        "cob-id",
        Shape::IntegerOr(0, 0xFFFF_FFFF, "auto"),
        "COB-ID; `auto`: that of the predefined connection set.",
    ),
    key("transmission", TRANSMISSION_TYPE, TRANSMISSION).formerly("type"),
    key("inhibit", TENTHS, INHIBIT),
    key("event-timer", MILLISECONDS, EVENT_TIMER),
    key("deadline", MILLISECONDS, DEADLINE),
    key("sync-start", bits(8), "SYNC start value."),
    key(
        "map",
        Shape::AllSpelled(ADDRESSES),
        "The mapped entries in the order of the frame: `6000:1`, `6000:1-5`, `0005` for a dummy.",
    ),
];

pub(super) const SDO: &[Key] = &[
    key("entry", Shape::Spelled(ADDRESS), "The entry, by its address.").required(),
    key("value", Shape::ValueOrList, "The value, or several ones in order.").required(),
];

pub(super) const LINK: &[Key] = &[
    key(
        "from",
        Shape::Spelled(LINK_END),
        "The entries of the producer: `left.6000:1-5`, `left.Statusword`; only the name of a manager without a description.",
    )
    .required(),
    key("to", Shape::AllSpelled(LINK_END), "As many entries of one consumer, or of each in a list; a manager as in `from`.")
        .required(),
    key("transmission", TRANSMISSION_TYPE, TRANSMISSION).formerly("type"),
    key("inhibit", TENTHS, INHIBIT),
    key("event-timer", MILLISECONDS, EVENT_TIMER),
    key("deadline", MILLISECONDS, DEADLINE),
    key("can-id", Shape::Integer(1, 0x1FFF_FFFF), "The CAN-ID; a free one without this key."),
];
