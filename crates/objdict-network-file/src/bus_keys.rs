//! The keys of `bus.yml`, for dcfgen 2.4.2 and for ros2_canopen.

use objdict_keyed::section::{Key, Shape, bits, key};

/// A key that belongs to the drivers and launch files of ROS.
const fn ros(name: &'static str) -> Key {
    key(name, Shape::Foreign, "For drivers of ROS.")
}

const DCF_PATH: &str = "The folder in which the manager finds the configurations of the nodes when it runs.";
const MULTIPLIER: &str = "After how many producer heartbeat times a consumer gives the node up.";
const SUB_INDEX: Shape = Shape::Integer(0, 255);
const NODE_ID: Shape = Shape::Integer(1, 127);

pub(super) const OPTIONS: &[Key] = &[
    key("dcf_path", Shape::Text, DCF_PATH),
    key("heartbeat_multiplier", Shape::Number, MULTIPLIER),
    key("retry_factor", bits(8), "How often an error control service may fail (1F81h)."),
];

pub(super) const MASTER: &[Key] = &[
    key("node_id", NODE_ID, "The node-ID of the manager.").required(),
    key("baudrate", Shape::Integer(1, 1000), "The bit rate in kbit/s."),
    key("vendor_id", bits(32), "Vendor-ID (1018h:01)."),
    key("product_code", bits(32), "Product code (1018h:02)."),
    key("revision_number", bits(32), "Revision number (1018h:03)."),
    key("serial_number", bits(32), "Serial number (1018h:04)."),
    key("sync_period", bits(32), "Communication cycle period in microseconds (1006h)."),
    key("sync_window", bits(32), "Synchronous window length in microseconds (1007h)."),
    key("sync_overflow", bits(8), "Synchronous counter overflow value (1019h)."),
    key("time_cob_id", bits(32), "COB-ID of TIME (1012h)."),
    key("emcy_inhibit_time", bits(16), "Inhibit time of EMCY in multiples of 100 µs (1015h)."),
    key("nmt_inhibit_time", bits(16), "Inhibit time of NMT commands in multiples of 100 µs (102Ah)."),
    key("heartbeat_producer", bits(16), "Producer heartbeat time in milliseconds (1017h)."),
    key("heartbeat_multiplier", Shape::Number, MULTIPLIER),
    key("heartbeat_consumer", Shape::Flag, "Whether the manager monitors the nodes (1016h)."),
    key("error_behavior", Shape::Numbers((1, 254), (0, 255)), "Reactions to classes of errors (1029h)."),
    key("start", Shape::Flag, "Whether the manager becomes operational by itself."),
    key("start_nodes", Shape::Flag, "Whether the manager starts the nodes."),
    key("start_all_nodes", Shape::Flag, "Whether one command starts all nodes."),
    key("reset_all_nodes", Shape::Flag, "Whether all nodes are reset when a mandatory one fails."),
    key("stop_all_nodes", Shape::Flag, "Whether all nodes are stopped when a mandatory one fails."),
    key("boot_time", bits(32), "The time in milliseconds in which all mandatory nodes boot (1F89h)."),
    ros("driver"),
    ros("package"),
    ros("namespace"),
    ros("boot_timeout"),
];

pub(super) const NODE: &[Key] = &[
    key("dcf", Shape::Text, "The file with the description of the node."),
    key("node_id", NODE_ID, "The node-ID; that of the description without this key."),
    key("dcf_path", Shape::Text, DCF_PATH),
    key("revision_number", bits(32), "The expected revision number (1F87h)."),
    key("serial_number", bits(32), "The expected serial number (1F88h)."),
    key("time_cob_id", bits(32), "COB-ID of TIME (1012h)."),
    key("heartbeat_producer", bits(16), "Producer heartbeat time in milliseconds (1017h)."),
    key("heartbeat_multiplier", Shape::Number, MULTIPLIER),
    key("heartbeat_consumer", Shape::Flag, "Whether the node monitors the manager (1016h)."),
    key("guard_time", bits(16), "Guard time in milliseconds (100Ch)."),
    key("life_time_factor", bits(8), "Life time factor (100Dh)."),
    key("retry_factor", bits(8), "How often an error control service may fail (1F81h)."),
    key("error_behavior", Shape::Numbers((1, 254), (0, 255)), "Reactions to classes of errors (1029h)."),
    key("rpdo", Shape::Numbered(1, 512, PDO), "What the node receives, by PDO number."),
    key("tpdo", Shape::Numbered(1, 512, PDO), "What the node transmits, by PDO number."),
    key("boot", Shape::Flag, "Whether the manager configures and starts the node."),
    key("mandatory", Shape::Flag, "Whether the network stops without the node."),
    key("reset_communication", Shape::Flag, "Whether the manager may reset a node that is operational."),
    key("software_file", Shape::Text, "The program for the node (1F58h)."),
    key("software_version", bits(32), "The expected software identification (1F55h)."),
    key("restore_configuration", bits(8), "The sub-index of 1011h that restores the defaults (1F8Ah)."),
    key("sdo", Shape::List(SDO), "Downloads at the end of the configuration, in this order."),
    key("configuration_file", Shape::Text, "Has no effect in dcfgen 2.4.2."),
    ros("driver"),
    ros("package"),
    ros("namespace"),
    ros("boot_timeout"),
    ros("boot_timeout_ms"),
    ros("sdo_timeout_ms"),
    ros("non_transmit_timeout"),
    ros("period"),
    ros("polling"),
    ros("diagnostics"),
    ros("enable_lazy_load"),
    ros("remappings"),
    ros("device_type"),
    ros("switching_state"),
    ros("homing_timeout_seconds"),
    ros("num_channels"),
    ros("channels"),
    ros("channel"),
    ros("channel_names"),
    ros("position_mode"),
    ros("velocity_mode"),
    ros("effort_mode"),
    ros("scale_pos_to_dev"),
    ros("scale_pos_from_dev"),
    ros("scale_vel_to_dev"),
    ros("scale_vel_from_dev"),
    ros("scale_eff_to_dev"),
    ros("scale_eff_from_dev"),
    ros("offset_pos_to_dev"),
    ros("offset_pos_from_dev"),
];

pub(super) const PDO: &[Key] = &[
    key("enabled", Shape::Flag, "Whether the PDO is valid in the end."),
    key(
        "cob_id",
        Shape::IntegerOr(0, 0xFFFF_FFFF, "auto"),
        "COB-ID, with bit 31 for a PDO that stays invalid.",
    ),
    key("transmission", bits(8), "Transmission type."),
    key("inhibit_time", bits(16), "Inhibit time in multiples of 100 µs."),
    key("event_timer", bits(16), "Event timer in milliseconds."),
    key("event_deadline", bits(16), "The consumer timeout of the PDO in milliseconds."),
    key("sync_start", bits(8), "SYNC start value."),
    key("mapping", Shape::List(MAPPING), "The mapped entries, in the order of the frame."),
];

pub(super) const MAPPING: &[Key] = &[
    key("index", bits(16), "The index of the object.").required(),
    key("sub_index", SUB_INDEX, "The sub-index of the entry."),
    key("bits", bits(8), "Has no effect: the data type of the entry says the length."),
];

pub(super) const SDO: &[Key] = &[
    key("index", bits(16), "The index of the object.").required(),
    key("sub_index", SUB_INDEX, "The sub-index of the entry."),
    key("value", Shape::Value, "The value."),
];
