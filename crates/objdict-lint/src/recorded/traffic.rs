//! The rules about the traffic of a bus.

use objdict_model::diagnostic::text_rules;

text_rules! {
    "traffic/pdo-length" = PDO_LENGTH, Error;
    summary: "a PDO has another length than mapped",
    checks: "Whether each PDO of a node has as many bytes as its mapping: that of the description, or the one that was written in the log.",
    why: "Receivers discard a PDO that is too short and send EMCY 8210h, or they read other values than are meant.",
    example: "6 bytes of a TPDO that maps 7",
    remedy: "Correct the mapping in the description, or in the node.",
    source: "CiA 301 §7.2.2.4",

    "traffic/inhibit-time" = INHIBIT_TIME, Warning;
    summary: "a PDO comes earlier than its inhibit time allows",
    checks: "Whether event-driven PDOs are at least their inhibit time apart. 5 % less are allowed for clocks and the bus.",
    why: "The inhibit time limits the load of the bus; without it messages of lower priority may be late.",
    example: "a TPDO after 5 ms, with an inhibit time of 10 ms",
    remedy: "Write the inhibit time to the node (1800h, sub-index 3), or correct the description.",
    source: "CiA 301 §7.5.2.36",

    "traffic/sync-window" = SYNC_WINDOW, Warning;
    summary: "a synchronous PDO is outside of the window",
    checks: "Whether synchronous PDOs come within the synchronous window length (1007h) after SYNC.",
    why: "Consumers take the value for one of the next cycle, and nodes discard PDOs outside of the window.",
    example: "a PDO 3 ms after SYNC, with a window of 2 ms",
    remedy: "Make the window longer, or let fewer messages go before the PDO.",
    source: "CiA 301 §7.5.2.8",

    "traffic/late-heartbeat" = LATE_HEARTBEAT, Error;
    summary: "a heartbeat is late",
    checks: "Whether heartbeats come in 1.5 times the time of their producer (1017h), or in less if a consumer allows less (1016h). Without 1017h, a consumer alone decides.",
    why: "Consumers take the node for lost: they send EMCY 8130h and may stop.",
    example: "no heartbeat for 900 ms of a node with a producer time of 500 ms",
    remedy: "Find out why the node was silent, or allow more time in 1017h, and in 1016h of a consumer that waits less.",
    source: "CiA 301 §7.2.8.3.2.2",

    "traffic/event-timer" = EVENT_TIMER, Warning;
    summary: "a PDO exceeds its event timer",
    checks: "Whether event-driven PDOs come within 1.5 times their event timer after the one before. A node that was started, stopped or reset in between is not judged.",
    why: "Receivers that monitor the PDO take it for lost.",
    example: "a TPDO after 490 ms, with an event timer of 100 ms",
    remedy: "Find out what held the node up, or write the event timer to the node (1800h, sub-index 5).",
    source: "CiA 301 §7.5.2.37",

    "traffic/repeated-pdo" = REPEATED_PDO, Warning;
    summary: "a synchronous PDO comes twice after one SYNC",
    checks: "Whether PDOs with a transmission type from 1 to 240 come once after a SYNC at most.",
    why: "Two nodes may send the same CAN-ID, or a SYNC was not received.",
    example: "two frames of a TPDO 1 ms apart, with a SYNC every 20 ms",
    remedy: "Look for a second sender of the CAN-ID, and for a node that is late by a whole cycle.",
    source: "CiA 301 §7.2.2.2",

    "traffic/sync-cycle" = SYNC_CYCLE, Warning;
    summary: "the cycle of SYNC is irregular",
    checks: "Whether SYNC comes half to 1.5 times the communication cycle period (1006h) after the one before.",
    why: "Synchronous PDOs come with it: drives interpolate with a wrong time, and outputs are late.",
    example: "62 ms between two SYNC, with a period of 20 ms",
    remedy: "Look for a second producer of SYNC, for load of higher priority, and for a manager that is held up.",
    source: "CiA 301 §7.2.5",

    "traffic/not-operational" = NOT_OPERATIONAL, Error;
    summary: "a node that is not operational sends PDOs",
    checks: "Whether nodes send PDOs in the state operational only. The state is known by boot-up messages, heartbeats and NMT commands. Logs without NMT commands are not judged, nor nodes that start by themselves (1F80h, bit 2).",
    why: "In any other state a node has no PDOs: the manager does not expect them, and values may not be valid yet.",
    example: "a TPDO directly after the boot-up message",
    remedy: "Start the node by an NMT command first, or correct its firmware.",
    source: "CiA 301 §7.3.2.2.5",

    "traffic/unexpected-boot-up" = UNEXPECTED_BOOT_UP, Error;
    summary: "a node boots up in operation",
    checks: "Whether a node that is operational sends a boot-up message only after an NMT command that resets it. Logs without NMT commands are not judged.",
    why: "The node was reset by a watchdog or its supply, and has lost its configuration.",
    example: "a boot-up message between two PDOs of a node",
    remedy: "Look at the supply and the watchdog of the node, and let the manager configure it again.",
    source: "CiA 301 §7.3.2.1",

    "traffic/unknown-node" = UNKNOWN_NODE, Warning;
    summary: "a node that the network does not have sends frames",
    checks: "Whether the network describes each node that sends frames. Descriptions of single nodes are not judged.",
    why: "A node has a wrong node-ID or a wrong COB-ID, or is not in the project: its CAN-IDs may collide with those of another node.",
    example: "frames with the CAN-ID 1A3h in a network without node 35",
    remedy: "Add the node to the network, or correct its node-ID.",
    source: "CiA 301 §7.3.5",

    "traffic/unanswered-request" = UNANSWERED_REQUEST, Error;
    summary: "an SDO request has no answer",
    checks: "Whether each transfer that a client begins gets an answer before the next one begins or, at the end of the log, within a second. Logs without any answer are not judged, nor nodes that are neither described nor seen.",
    why: "The node is off, in the state stopped, or has another node-ID; a manager that waits does not boot it.",
    example: "a read of 1018h of a node that is silent",
    remedy: "Look at the node and its state, and at the termination of the bus.",
    source: "CiA 301 §7.2.4",

    "traffic/broken-transfer" = BROKEN_TRANSFER, Error;
    summary: "an SDO transfer is not sound",
    checks: "Whether the toggle bits of segments alternate, as many bytes are sent as were announced, and the checksum of blocks is right.",
    why: "The other side aborts the transfer, or takes a wrong value.",
    example: "a block transfer with the checksum DEADh",
    remedy: "Correct the client or the server that sends it.",
    source: "CiA 301 §7.2.4.3",

    "traffic/sdo-length" = SDO_LENGTH, Warning;
    summary: "an SDO frame does not have 8 bytes",
    checks: "Whether each frame of an SDO transfer has 8 bytes.",
    why: "Many nodes discard a frame that is shorter.",
    example: "a request of 6 bytes",
    remedy: "Fill the frame with zeros.",
    source: "CiA 301 §7.2.4.3",

    "traffic/sdo-size" = SDO_SIZE, Error;
    summary: "a value in an SDO transfer has another size than its data type",
    checks: "Whether each value that nodes answer or accept has as many bytes as the `DataType` of its entry. Transfers that do not say how many of their four bytes count are not judged.",
    why: "A client that uses the entry by its description takes or sends a wrong number, or is refused.",
    example: "two bytes of an entry that is described as UNSIGNED32",
    remedy: "Correct `DataType`, or the device: it aborts a write of another size with 0607 0010h.",
    source: "CiA 301 §7.2.4.3",

    "traffic/sdo-access" = SDO_ACCESS, Warning;
    summary: "an SDO transfer succeeds against the access of an entry",
    checks: "Whether nodes refuse to write entries that are ro or const, and to read those that are wo.",
    why: "The description belongs to another version of the device, or the device does not protect the entry.",
    example: "a node accepts a value for an entry with `AccessType=ro`",
    remedy: "Correct `AccessType`, or abort with 0601 0001h or 0601 0002h.",
    source: "CiA 301 §7.2.4.3.17",

    "traffic/sdo-limits" = SDO_LIMITS, Error;
    summary: "a value in an SDO transfer is outside its limits",
    checks: "Whether values that nodes answer or accept are within `LowLimit` and `HighLimit`.",
    why: "The limits in the description are not those of the device, or the device does not check them.",
    example: "120 for an entry with `HighLimit=100`",
    remedy: "Correct the limits, or the device.",
    source: "CiA 306-1 §4.6.3.2",
}
