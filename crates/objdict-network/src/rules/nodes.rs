//! The rules about the configuration of nodes.

use crate::diagnostic::text_rules;

text_rules! {
    source: "CiA 301 §7.2.4.3.17";

    "network/unknown-node-id" = UNKNOWN_NODE_ID, Error;
    summary: "a node's node-ID is unknown",
    checks: "Each node needs a node-ID from 1 to 127, either in the network file or in its DCF or XDC.",
    why: "No requests can be sent to the node. dcfgen leaves it out with a warning or stops with a traceback.",
    example: "a node of an EDS without `node_id`",
    remedy: "Assign the node its node-ID.",
    source: "CiA 301 §7.3.5",

    "network/missing-entry" = MISSING_ENTRY, Error;
    summary: "a setting needs an entry that the node does not have",
    checks: "A node's description must contain each object and sub-index that the network file writes or maps, and 1000h, which the manager reads first. A service that the node does not have is a warning and stays off. A revision or serial number that 1018h does not have is also a warning. A software version that 1F56h does not have is an error: the manager does not boot the node.",
    why: "The node aborts the download with 0602 0000h or 0609 0011h, and the manager does not start it.",
    example: "`heartbeat_producer: 500` for a node without 1017h",
    remedy: "Remove the setting, or correct index and sub-index.",

    "network/other-node-id" = OTHER_NODE_ID, Error;
    summary: "a DCF was created for a different node",
    checks: "The node-ID of each DCF or XDC must match its node. If `network.toml` or `bus.yml` states a different node-ID, this is a warning, because formulas with `$NODEID` follow the stated one.",
    why: "A node receives the configuration of a different node. COB-IDs that are numbers, node-specific values and the serial number belong to that node.",
    example: "`Node5DCFName=left.dcf`, where `left.dcf` has `NodeID=11`",
    remedy: "Use the DCF of the node, correct its node-ID, or use the EDS.",
    source: "CiA 306-1, `NodeID`; CiA 306-3",

    "network/other-net-number" = OTHER_NET_NUMBER, Warning;
    summary: "a DCF was created for a different network",
    checks: "All DCFs must have the same `NetNumber`; 0 is ignored.",
    why: "The DCF was created for a different network, so its CAN-IDs and heartbeat times may not match.",
    example: "`NetNumber=1` and `NetNumber=2`",
    remedy: "Use the DCFs of one network, or correct `NetNumber`.",
    source: "CiA 306-1, `NetNumber`",

    "network/contradictory-values" = CONTRADICTION, Error;
    summary: "an entry is set to two values",
    checks: "`set` must give an entry the same value as the other keys of the network and its links. A download of `sdo` with a different value is a warning: it is the last one, so its value remains. `id` and `heartbeat` of a described manager must be the same in its two tables.",
    why: "The node ignores one of the two values.",
    example: r#"`heartbeat = "200ms"` and `set = { "1017" = 0 }`"#,
    remedy: "Remove one of the two.",
    source: "objdict, docs/guides/network.md",

    "network/read-only-entry" = READ_ONLY_ENTRY, Error;
    summary: "an entry that cannot be written is written",
    checks: "The access type of each entry that the network file writes must allow writing.",
    why: "The node aborts the download with 0601 0002h, and the manager does not start it.",
    example: "an `sdo` for 1000h",
    remedy: "Remove the setting, or write a different entry.",

    "network/invalid-value" = INVALID_VALUE, Error;
    summary: "a value is not valid for its entry",
    checks: "Each value in the network file must be valid for the entry's data type and within its limits. Transmission types and overflow values of the SYNC counter (1019h) must not be reserved. A reserved type of a PDO that the network does not need is a warning.",
    why: "dcfgen stops with a traceback or truncates the value; the node aborts the download with 0609 0030h.",
    example: "300 for an INTEGER8, `transmission: 245`",
    remedy: "Write a value of the data type within the limits.",

    "network/unmappable-entry" = UNMAPPABLE_ENTRY, Error;
    summary: "an entry is mapped to a PDO that cannot carry it",
    checks: "Each mapped entry must support PDO mapping and have a fixed length. It must be writable for an RPDO and readable for a TPDO.",
    why: "The node aborts the download of the mapping with 0604 0041h.",
    example: "the statusword 6041h, which is `ro`, in an RPDO",
    remedy: "Map a different entry, or move it to a PDO of the other direction.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "network/idle-pdo" = IDLE_PDO, Warning;
    summary: "a configured PDO stays off",
    checks: "A PDO that the network file configures needs a valid COB-ID, in the file or in the node's description.",
    why: "Bit 31 of the COB-ID switches the PDO off. dcfgen silently omits all its settings.",
    example: "`tpdo: 3: {transmission: 1}` for a node whose 1802h:01 is 8000 0000h",
    remedy: "Assign a COB-ID to the PDO, or `auto`.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",

    "network/pdo-too-long" = PDO_TOO_LONG, Error;
    summary: "the mapped entries exceed the length of a frame",
    checks: "The mapped entries of each PDO may have at most 64 bits in total.",
    why: "The node aborts the download of the mapping with 0604 0042h. dcfgen warns.",
    example: "three entries of 32 bits in one PDO",
    remedy: "Move entries to a different PDO.",
    source: "CiA 301 §7.5.2.36",

    "network/no-free-can-id" = NO_FREE_CAN_ID, Error;
    summary: "no CAN-ID is left for a PDO",
    checks: "A CAN-ID must be free for each PDO with `cob_id: auto`. PDOs 1 to 4 get their CAN-ID from the predefined connection set, others get one from 680h to 6DFh. Each link without a CAN-ID needs one too.",
    why: "The PDO cannot be used.",
    example: "100 nodes that use PDO 5",
    remedy: "Assign CAN-IDs by number.",
    source: "CiA 301 §7.3.5; dcf-tools 2.4.2",

    "network/no-heartbeat-consumer" = NO_HEARTBEAT_CONSUMER, Warning;
    summary: "a node cannot monitor a heartbeat",
    checks: "A node that monitors other nodes needs a free sub-index in 1016h for each of them, and the time must fit into it. Each sub-index in use must name a different node. It is an error if the network file names a node twice.",
    why: "The node does not notice the loss of the monitored node.",
    example: "`heartbeat_consumer: true` for a node without 1016h",
    remedy: "Remove the setting, or free a sub-index of 1016h.",
    source: "CiA 301 §7.5.2.19",

    "network/heartbeat-and-guarding" = HEARTBEAT_AND_GUARDING, Warning;
    summary: "a node uses heartbeat and node guarding",
    checks: "Reports a node with a producer heartbeat time as well as a guard time and a life time factor.",
    why: "A node uses only one of the two; with a producer heartbeat time it does not respond to node guarding.",
    example: "`heartbeat_producer: 500`, `guard_time: 100` and `life_time_factor: 3`",
    remedy: "Remove `guard_time` and `life_time_factor`.",
    source: "CiA 301 §7.2.8.3",

    "network/duplicate-manager" = DUPLICATE_MANAGER, Error;
    summary: "two nodes are managers",
    checks: "In the DCF or XDC of a node that is not the manager, `CANopenManager=1` is reported. Flying masters (bit 5 of 1F80h) are exempt because they take turns.",
    why: "Both managers configure and start the nodes and undo each other's changes.",
    example: "a slave's DCF that was copied from the manager's DCF",
    remedy: "Write `CANopenManager=0` into the DCF of the node.",
    source: "CiA 302-2; CiA 306-1, `CANopenManager`",

    "network/refused-download" = REFUSED_DOWNLOAD, Error;
    summary: "a node rejects a download of its configuration",
    checks: "Each node must accept the downloads of its configuration in their order, starting from its values at power-on. Identifiers may change only while their service is not valid, and mappings only while their PDO is not valid. Mapped entries must fit. The configured values of a DCF must be transferable.",
    why: "The manager does not start a node that aborts a download.",
    example: "`sdo` with 85h for 1014h of a node whose EMCY has the CAN-ID 86h",
    remedy: "Correct the value. For a COB-ID use `set`, which switches the service off first.",
    source: "CiA 301 §7.5.2; CiA 302-3, 1F22h",

    "network/refused-configuration" = REFUSED_CONFIGURATION, Error;
    summary: "a node rejects the configuration that the manager holds",
    checks: "Each node must accept every download of its DCF (1F20h) and of its concise DCF (1F22h) in the manager's description.",
    why: "The manager does not start a node that aborts a download.",
    example: "1F22h:05 of the manager writes to 2FFFh, which node 5 does not have",
    remedy: "Write the manager's DCF again.",
    source: "CiA 302-3, 1F20h, 1F22h; CiA 301 §7.2.4.3.17",

    "network/other-configuration" = OTHER_CONFIGURATION, Error;
    summary: "the manager's values differ from the node's DCF",
    checks: "1F20h and 1F22h of a configured manager must give each entry the value from the node's DCF.",
    why: "The manager's values are sent last, so the node deviates from its DCF and may use the CAN-ID of a different node.",
    example: "1F22h:0B of the manager sets 1800h:01 to 18Ch, the CAN-ID of node 12",
    remedy: "Write the DCFs of node and manager again.",
    source: "CiA 302-3, 1F20h, 1F22h",

    "network/configuration-date" = CONFIGURATION_DATE, Warning;
    summary: "the manager expects a different configuration date than the node has",
    checks: "The configuration date and time in the manager's 1F26h and 1F27h must match 1020h of the node. 0 is not checked.",
    why: "The manager configures the node at each start.",
    example: "1F26h:05 is 15666, and 1020h:01 of node 5 is 15600",
    remedy: "Write the DCFs of node and manager again, with the same date.",
    source: "CiA 302-3, 1F26h, 1F27h; CiA 301 §7.5.2.22",

    "network/mandatory-not-booted" = MANDATORY_NOT_BOOTED, Warning;
    summary: "the manager does not boot a mandatory node",
    checks: "The manager must configure and start each mandatory node. This is checked in the keys of the network file and in 1F81h of a described manager.",
    why: "The manager waits for the node, but neither checks nor configures nor starts it. The network therefore starts while the node is pre-operational, with the values of its description.",
    example: "`mandatory = true` and `boot = false`",
    remedy: "Have the manager boot the node, or omit `mandatory`.",
    source: "CiA 302-2, 1F81h",

    "network/kept-alive-without-state" = KEPT_ALIVE_WITHOUT_STATE, Error;
    summary: "the manager must not reset a node that does not report its state",
    checks: "Bit 4 of 1F81h forbids the manager to reset a node that is operational. If the manager boots such a node, the node must report its state at power-on. It can do so by a heartbeat, if its description states one as the default of 1017h. Otherwise it needs node guarding (100Ch), and the manager must not expect a heartbeat.",
    why: "The manager does not reset the node before it knows the state. At power-on of the network nothing is configured yet, so the manager waits for a heartbeat that is never sent and does not boot the node (errors E and F of CiA 302-2).",
    example: "`reset-communication = false` for a node with `DefaultValue=0` in `[1017]` and without 100Ch",
    remedy: "Let the manager reset the node (`reset-communication = true`), or store a heartbeat time in the node and describe it by a DCF.",
    source: "CiA 302-2, 1F81h",

    "network/nothing-to-restore" = NOTHING_TO_RESTORE, Error;
    summary: "the manager restores the defaults of a node that cannot restore them",
    checks: "If the manager restores a node's defaults before it configures the node (1F8Ah, `restore`), the node must have this sub-index of 1011h.",
    why: "The node rejects the request, and the manager does not boot it (error J of CiA 302-2).",
    example: "`restore = 1` for a node without 1011h",
    remedy: "Remove `restore`, or name a sub-index of 1011h that the node has.",
    source: "CiA 302-2, 1F8Ah; CiA 301 §7.5.2.14",

    "network/absent-slave" = ABSENT_SLAVE, Warning;
    summary: "the manager waits for a node that is not in the network",
    checks: "Each node-ID that the manager's 1F81h assigns as a slave must belong to a node of the network. It is an error if the missing node is mandatory or the manager boots it.",
    why: "The manager searches for the node forever. If a mandatory node is missing, it does not start the network.",
    example: "1F81h:09 is 1, but no node has the node-ID 9",
    remedy: "Describe the node, or write 0 to the sub-index.",
    source: "CiA 302-2, 1F81h",
}
