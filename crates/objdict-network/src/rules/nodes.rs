//! The rules about the configuration of nodes.

use crate::diagnostic::text_rules;

text_rules! {
    source: "CiA 301 §7.2.4.3.17";

    "network/unknown-node-id" = UNKNOWN_NODE_ID, Error;
    summary: "the node-ID of a node is not known",
    checks: "Whether each node has a node-ID from 1 to 127: in the network file, or in its DCF or XDC.",
    why: "Nothing can be sent to the node. dcfgen leaves it out with a warning, or stops with a traceback.",
    example: "a node of an EDS without `node_id`",
    remedy: "Give the node its node-ID.",
    source: "CiA 301 §7.3.5",

    "network/missing-entry" = MISSING_ENTRY, Error;
    summary: "a setting needs an entry that the node does not have",
    checks: "Whether the description of a node has each object and sub-index that the network file writes or maps, and 1000h, which the manager reads first. A service that the node does not have is a warning: it stays off; so is a revision or serial number that 1018h does not have. A software version that 1F56h does not have is an error: the manager does not boot the node.",
    why: "The node aborts the download with 0602 0000h or 0609 0011h, and the manager does not start it.",
    example: "`heartbeat_producer: 500` for a node without 1017h",
    remedy: "Remove the setting, or correct index and sub-index.",

    "network/other-node-id" = OTHER_NODE_ID, Error;
    summary: "a DCF was made for another node",
    checks: "Whether the node-ID of each DCF or XDC is that of its node. Where `network.toml` or `bus.yml` states the node-ID, another one is a warning, because formulas with `$NODEID` follow it.",
    why: "The configuration of one node goes to another one: COB-IDs that are numbers, node-specific values and the serial number are those of the other node.",
    example: "`Node5DCFName=left.dcf`, where `left.dcf` has `NodeID=11`",
    remedy: "Use the DCF of the node, correct its node-ID, or use the EDS.",
    source: "CiA 306-1, `NodeID`; CiA 306-3",

    "network/other-net-number" = OTHER_NET_NUMBER, Warning;
    summary: "a DCF was made for another network",
    checks: "Whether `NetNumber` of each DCF, where it is not 0, is that of the other ones.",
    why: "The DCF was made for another network, so its CAN-IDs and heartbeat times may not fit.",
    example: "`NetNumber=1` and `NetNumber=2`",
    remedy: "Use the DCFs of one network, or correct `NetNumber`.",
    source: "CiA 306-1, `NetNumber`",

    "network/contradictory-values" = CONTRADICTION, Error;
    summary: "an entry is set to two values",
    checks: "Whether `set` gives an entry the same value as the other keys of the network and its links. A download of `sdo` with another value is a warning: it is the last one, so its value remains. `id` and `heartbeat` of a described manager are the same in its two tables.",
    why: "One of the two is not what the node does.",
    example: r#"`heartbeat = "200ms"` and `set = { "1017" = 0 }`"#,
    remedy: "Remove one of the two.",
    source: "objdict, docs/guides/network.md",

    "network/read-only-entry" = READ_ONLY_ENTRY, Error;
    summary: "an entry is written that cannot be written",
    checks: "Whether each entry that the network file writes is writable by its access type.",
    why: "The node aborts the download with 0601 0002h, and the manager does not start it.",
    example: "an `sdo` for 1000h",
    remedy: "Remove the setting, or write another entry.",

    "network/invalid-value" = INVALID_VALUE, Error;
    summary: "a value does not fit its entry",
    checks: "Whether each value that the network file gives to an entry is one of its data type and inside its limits, and whether transmission types and overflow values of the SYNC counter (1019h) are reserved. A reserved type of a PDO that the network does not need is a warning.",
    why: "dcfgen stops with a traceback or cuts the value; the node aborts the download with 0609 0030h.",
    example: "300 for an INTEGER8, `transmission: 245`",
    remedy: "Write a value of the data type and inside the limits.",

    "network/unmappable-entry" = UNMAPPABLE_ENTRY, Error;
    summary: "an entry is mapped that no such PDO can carry",
    checks: "Whether each mapped entry supports PDO mapping, has a fixed length, and can be written by an RPDO or read by a TPDO.",
    why: "The node aborts the download of the mapping with 0604 0041h.",
    example: "the statusword 6041h, which is `ro`, in an RPDO",
    remedy: "Map another entry, or move it to a PDO of the other direction.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "network/idle-pdo" = IDLE_PDO, Warning;
    summary: "a PDO is configured that stays off",
    checks: "Whether a PDO that the network file configures has a valid COB-ID: in the file, or in the description of the node.",
    why: "Bit 31 of the COB-ID switches the PDO off. dcfgen sends none of its settings, without a word.",
    example: "`tpdo: 3: {transmission: 1}` for a node whose 1802h:01 is 8000 0000h",
    remedy: "Give the PDO a COB-ID, or `auto`.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",

    "network/pdo-too-long" = PDO_TOO_LONG, Error;
    summary: "more is mapped into a PDO than a frame carries",
    checks: "Whether the mapped entries of each PDO have at most 64 bits.",
    why: "The node aborts the download of the mapping with 0604 0042h. dcfgen warns.",
    example: "three entries of 32 bits in one PDO",
    remedy: "Move entries to another PDO.",
    source: "CiA 301 §7.5.2.36",

    "network/no-free-can-id" = NO_FREE_CAN_ID, Error;
    summary: "no CAN-ID is left for a PDO",
    checks: "Whether each PDO with `cob_id: auto` gets a CAN-ID: PDO 1 to 4 that of the predefined connection set, others one of 680h to 6DFh; and whether each link without a CAN-ID gets one.",
    why: "The PDO cannot be used.",
    example: "100 nodes that use PDO 5",
    remedy: "Give CAN-IDs by number.",
    source: "CiA 301 §7.3.5; dcf-tools 2.4.2",

    "network/no-heartbeat-consumer" = NO_HEARTBEAT_CONSUMER, Warning;
    summary: "a node cannot monitor a heartbeat",
    checks: "Whether a node that is to monitor another one has a free sub-index in 1016h, whether the time fits into it, and whether each sub-index in use names another node; one that the network file names twice is an error.",
    why: "The node does not notice that the other one is gone.",
    example: "`heartbeat_consumer: true` for a node without 1016h",
    remedy: "Remove the setting, or free a sub-index of 1016h.",
    source: "CiA 301 §7.5.2.19",

    "network/heartbeat-and-guarding" = HEARTBEAT_AND_GUARDING, Warning;
    summary: "a node uses heartbeat and node guarding",
    checks: "Whether a node has a producer heartbeat time as well as a guard time and a life time factor.",
    why: "A node uses one of the two; with a producer heartbeat time it does not answer the guarding.",
    example: "`heartbeat_producer: 500`, `guard_time: 100` and `life_time_factor: 3`",
    remedy: "Remove `guard_time` and `life_time_factor`.",
    source: "CiA 301 §7.2.8.3",

    "network/duplicate-manager" = DUPLICATE_MANAGER, Error;
    summary: "two nodes are managers",
    checks: "Whether the DCF or XDC of a node that is not the manager says `CANopenManager=1`. Flying masters (bit 5 of 1F80h) are passed over: they take turns.",
    why: "Both managers configure and start the nodes, and undo what the other one did.",
    example: "the DCF of a slave that was copied from that of the manager",
    remedy: "Write `CANopenManager=0` into the DCF of the node.",
    source: "CiA 302-2; CiA 306-1, `CANopenManager`",

    "network/refused-download" = REFUSED_DOWNLOAD, Error;
    summary: "a node refuses a download of its configuration",
    checks: "Whether each node accepts the downloads of its configuration in their order, from the values that it has when it is switched on: identifiers change only while their service is not valid, mappings only while their PDO is not valid, and mapped entries fit. The configured values of a DCF can be sent.",
    why: "The manager does not start a node that aborts a download.",
    example: "`sdo` with 85h for 1014h of a node whose EMCY has the CAN-ID 86h",
    remedy: "Correct the value. For a COB-ID use `set`, which switches the service off first.",
    source: "CiA 301 §7.5.2; CiA 302-3, 1F22h",

    "network/refused-configuration" = REFUSED_CONFIGURATION, Error;
    summary: "a node refuses the configuration that the manager holds",
    checks: "Whether each node accepts every download of its DCF (1F20h) and of its concise DCF (1F22h) in the description of the manager.",
    why: "The manager does not start a node that aborts a download.",
    example: "1F22h:05 of the manager writes to 2FFFh, which node 5 does not have",
    remedy: "Write the DCF of the manager anew.",
    source: "CiA 302-3, 1F20h, 1F22h; CiA 301 §7.2.4.3.17",

    "network/other-configuration" = OTHER_CONFIGURATION, Error;
    summary: "the manager sends other values than the DCF of the node has",
    checks: "Whether 1F20h and 1F22h of a configured manager give each entry the value that the DCF of the node has.",
    why: "The values of the manager are sent last, so the node does not do what its DCF says, perhaps with the CAN-ID of another node.",
    example: "1F22h:0B of the manager sets 1800h:01 to 18Ch, the CAN-ID of node 12",
    remedy: "Write the DCFs of node and manager anew.",
    source: "CiA 302-3, 1F20h, 1F22h",

    "network/configuration-date" = CONFIGURATION_DATE, Warning;
    summary: "a node has another configuration date than the manager expects",
    checks: "Whether date and time of the configuration in 1F26h and 1F27h of the manager are those in 1020h of the node. 0 is not checked.",
    why: "The manager configures the node at each start.",
    example: "1F26h:05 is 15666, and 1020h:01 of node 5 is 15600",
    remedy: "Write the DCFs of node and manager anew, with the same date.",
    source: "CiA 302-3, 1F26h, 1F27h; CiA 301 §7.5.2.22",

    "network/mandatory-not-booted" = MANDATORY_NOT_BOOTED, Warning;
    summary: "the manager does not boot a mandatory node",
    checks: "Whether the manager configures and starts each node that is mandatory: by the keys of the network file, and in 1F81h of a described manager.",
    why: "The manager waits for the node, but neither checks nor configures nor starts it, so the network starts while the node is in the state pre-operational, with the values of its description.",
    example: "`mandatory = true` and `boot = false`",
    remedy: "Have the manager boot the node, or leave `mandatory` out.",
    source: "CiA 302-2, 1F81h",

    "network/kept-alive-without-state" = KEPT_ALIVE_WITHOUT_STATE, Error;
    summary: "the manager must not reset a node that does not report its state",
    checks: "Whether each node that the manager boots and must not reset while it is operational (1F81h bit 4) reports its state when it is switched on: by a heartbeat that its description has as the default of 1017h, or by node guarding (100Ch) where the manager expects no heartbeat.",
    why: "The manager does not reset the node before it knows the state. When the network is switched on, nothing is configured yet, so the manager waits for a heartbeat that does not come, and does not boot the node (errors E and F of CiA 302-2).",
    example: "`reset-communication = false` for a node with `DefaultValue=0` in `[1017]` and without 100Ch",
    remedy: "Let the manager reset the node (`reset-communication = true`), or store a heartbeat time in the node and describe it by a DCF.",
    source: "CiA 302-2, 1F81h",

    "network/nothing-to-restore" = NOTHING_TO_RESTORE, Error;
    summary: "the manager restores the defaults of a node that cannot restore them",
    checks: "Whether each node whose defaults the manager restores before it configures the node (1F8Ah, `restore`) has this sub-index of 1011h.",
    why: "The node refuses the request, and the manager does not boot it (error J of CiA 302-2).",
    example: "`restore = 1` for a node without 1011h",
    remedy: "Remove `restore`, or name a sub-index of 1011h that the node has.",
    source: "CiA 302-2, 1F8Ah; CiA 301 §7.5.2.14",

    "network/absent-slave" = ABSENT_SLAVE, Warning;
    summary: "the manager waits for a node that is not in the network",
    checks: "Whether each node-ID that 1F81h of the manager assigns as a slave belongs to a node of the network. A mandatory one that is absent is an error, and one that the manager boots.",
    why: "The manager looks for the node for ever. Without a mandatory one it does not start the network.",
    example: "1F81h:09 is 1, but no node has the node-ID 9",
    remedy: "Describe the node, or write 0 into the sub-index.",
    source: "CiA 302-2, 1F81h",
}
