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

const TRANSMISSION: &str = "The transmission type: `sync/1` to `sync/240`, `event`, `event-vendor`, `rtr`, `rtr-sync`, or its number; earlier files have `type`.";
const INHIBIT: &str = "The inhibit time of the producer: a text with a unit, or a number of 100 µs.";
const EVENT_TIMER: &str = "The event timer of the producer: a text with a unit, or a number of ms.";
const DEADLINE: &str = "The time after which a consumer, or the manager, reports the PDO as missing: a text with a unit, or a number of ms.";
const HEARTBEAT: &str = "The producer heartbeat time (1017h): a text with a unit, or a number of ms.";
const WATCH: &str = "The number of heartbeat times after which other nodes consider it lost: `1.5x`.";
const IDENTITY: Shape = Shape::Word(&["none", "vendor", "product", "revision", "serial"]);
const ERROR_BEHAVIOR: &str = "The reactions to classes of errors (1029h), by sub-index.";

pub(super) const NETWORK: &[Key] = &[
    key("bus", Shape::Map(BUS), "The network as a whole."),
    key("manager", Shape::Map(MANAGER), "The manager, which configures and starts the nodes (CiA 302-2)."),
    key("node", Shape::Named(NODE), "The nodes by their names."),
    key("type", Shape::Named(NODE), "Keys that several nodes have in common, by the name that nodes `use`."),
    key("link", Shape::List(LINK), "A producer, its consumers, and the entries between them."),
];

pub(super) const BUS: &[Key] = &[
    key("name", Shape::Text, "The name of the network."),
    key(
        "bit-rate",
        Shape::Integer(1, 1000),
        "The bit rate in kbit/s. Default: the bit rate of the nodes' DCFs, if they agree; for a `bus.yml`, 1000.",
    ),
    key(
        "manager",
        Shape::Text,
        "The node that is the manager, or the name of a manager without a description, which must not resemble the name of a node.",
    ),
    key(
        "sync",
        time(32, 1000),
        "The communication cycle period (1006h) of the manager, which sends SYNC with the CAN-ID of its 1005h: a text with a unit, or a number of µs.",
    ),
    key(
        "sync-window",
        time(32, 1000),
        "The synchronous window length (1007h) of the manager: a text with a unit, or a number of µs.",
    ),
    key("sync-overflow", bits(8), "The synchronous counter overflow value (1019h) of the manager."),
    key(
        "identity",
        IDENTITY,
        "The numbers that the manager compares before it boots a node (1F84h to 1F88h): `vendor` includes the device type, each later word the previous ones. Default: all that are stated.",
    ),
    key(
        "unused-pdos",
        UNUSED_PDOS,
        "`off`: downloads disable PDOs that no link, key, `set` or `sdo` uses; a PDO with a constant COB-ID remains valid, with a warning. Default: `keep`.",
    ),
    key(
        "run-time-folder",
        Shape::Text,
        "The folder in which the manager finds the configurations of the nodes at run time.",
    ),
];

pub(super) const MANAGER: &[Key] = &[
    key("id", NODE_ID, "The node-ID of a manager without a description."),
    key("vendor-id", bits(32), "The vendor-ID (1018h:01). Default: from the description."),
    key("product-code", bits(32), "The product code (1018h:02). Default: from the description."),
    key("revision-number", bits(32), "The revision number (1018h:03). Default: from the description."),
    key("serial-number", bits(32), "The serial number (1018h:04). Default: from the description."),
    key("heartbeat", MILLISECONDS, HEARTBEAT),
    key("watch", Shape::Spelled(FACTOR), WATCH),
    key("watches-nodes", Shape::Flag, "The manager monitors the nodes (1016h). Default: yes."),
    key("time-cob-id", bits(32), "The COB-ID of TIME (1012h)."),
    key(
        "emcy-inhibit",
        TENTHS,
        "The inhibit time of EMCY (1015h): a text with a unit, or a number of 100 µs.",
    ),
    key(
        "nmt-inhibit",
        TENTHS,
        "The inhibit time of NMT commands (102Ah): a text with a unit, or a number of 100 µs.",
    ),
    key("error-behavior", NUMBERS, ERROR_BEHAVIOR),
    key("start", Shape::Flag, "The manager becomes operational by itself (1F80h)."),
    key("start-nodes", Shape::Flag, "The manager starts the nodes (1F80h)."),
    key("start-all-nodes", Shape::Flag, "One command starts all nodes (1F80h)."),
    key("reset-all-nodes", Shape::Flag, "The manager resets all nodes when a mandatory one fails (1F80h)."),
    key("stop-all-nodes", Shape::Flag, "The manager stops all nodes when a mandatory one fails (1F80h)."),
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
    key("id", NODE_ID, "The node-ID. Default: from the description."),
    key(
        "use",
        Shape::Text,
        "The type whose keys the node or type inherits. Its own keys take precedence; tables (`set`, `watches`, `tpdo.1`) are merged, lists replaced.",
    ),
    key(
        "modules",
        Shape::Numerals(1, 0xFFFF),
        "The modules of a coupler, in order, by their numbers in the description.",
    ),
    key("heartbeat", MILLISECONDS, HEARTBEAT),
    key("watch", Shape::Spelled(FACTOR), WATCH),
    key("watches-manager", Shape::Flag, "The node monitors the manager (1016h)."),
    key(
        "watches",
        Shape::SpelledByName(FACTOR_OR_TIME),
        "Further nodes that it monitors, each with a number of heartbeat times or a time: `{ right = \"1.5x\", left = \"500ms\" }`.",
    ),
    key("guard-time", MILLISECONDS, "The guard time (100Ch): a text with a unit, or a number of ms."),
    key("life-time-factor", bits(8), "The life time factor (100Dh)."),
    key("time-cob-id", bits(32), "The COB-ID of TIME (1012h)."),
    key("error-behavior", NUMBERS, ERROR_BEHAVIOR),
    key(
        "set",
        Shape::Values,
        "Values by entry, as in `objdict configure --set`: `{ \"6423\" = true, \"1006\" = \"33ms\" }`.",
    ),
    key("rpdo", Shape::Numbered(1, 512, PDO), "RPDOs that links do not use, by number."),
    key("tpdo", Shape::Numbered(1, 512, PDO), "TPDOs that links do not use, by number."),
    key("unused-pdos", UNUSED_PDOS, "As in `bus`, for this node."),
    key(
        "sdo",
        Shape::List(SDO),
        "Downloads at the end of the configuration, in this order, even if the node already has the value.",
    ),
    key("boot", Shape::Flag, "The manager boots the node (1F81h)."),
    key("mandatory", Shape::Flag, "A failure of the node stops the network (1F81h)."),
    key(
        "reset-communication",
        Shape::Flag,
        "The manager may reset the operational node (1F81h). Lely 2.4 never boots a node that is not operational if this is `false`.",
    ),
    key("retry-factor", bits(8), "The allowed failures of error control (1F81h)."),
    key("software-file", Shape::Text, "The program for the node (1F58h)."),
    key("software-version", bits(32), "The expected software identification (1F55h)."),
    key(
        "restore",
        bits(8),
        "The sub-index of 1011h that restores the defaults (1F8Ah). With it, Lely 2.4 reports error J.",
    ),
    key("identity", IDENTITY, "As in `bus`, for this node. Default: from `bus`."),
    key("revision-number", bits(32), "The expected revision number (1F87h); FFFFFFFFh: not compared."),
    key("serial-number", bits(32), "The expected serial number (1F88h); FFFFFFFFh: not compared."),
    key("run-time-folder", Shape::Text, "As in `bus`, for this node."),
];

pub(super) const PDO: &[Key] = &[
    key("enabled", Shape::Flag, "The PDO is valid."),
    key(
        "cob-id",
        Shape::IntegerOr(0, 0xFFFF_FFFF, "auto"),
        "The COB-ID; `auto`: from the predefined connection set.",
    ),
    key("transmission", TRANSMISSION_TYPE, TRANSMISSION).formerly("type"),
    key("inhibit", TENTHS, INHIBIT),
    key("event-timer", MILLISECONDS, EVENT_TIMER),
    key("deadline", MILLISECONDS, DEADLINE),
    key("sync-start", bits(8), "The SYNC start value."),
    key(
        "map",
        Shape::AllSpelled(ADDRESSES),
        "The mapped entries in order: `[\"6000:1-5\", \"0005\"]`; `0005` is a dummy.",
    ),
];

pub(super) const SDO: &[Key] = &[
    key("entry", Shape::Spelled(ADDRESS), "The entry, by its address.").required(),
    key("value", Shape::ValueOrList, "The value, or several in order.").required(),
];

pub(super) const LINK: &[Key] = &[
    key("from", Shape::Spelled(LINK_END), "The producer and its entries.").required(),
    key("to", Shape::AllSpelled(LINK_END), "A consumer and its entries, or a list of consumers.").required(),
    key("transmission", TRANSMISSION_TYPE, TRANSMISSION).formerly("type"),
    key("inhibit", TENTHS, INHIBIT),
    key("event-timer", MILLISECONDS, EVENT_TIMER),
    key("deadline", MILLISECONDS, DEADLINE),
    key("can-id", Shape::Integer(1, 0x1FFF_FFFF), "The CAN-ID, for at most 64 bits. Default: a free one."),
];
