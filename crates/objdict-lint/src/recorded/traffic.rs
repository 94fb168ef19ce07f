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
    checks: "Whether heartbeats come in the time that a consumer allows (1016h) or, without a consumer, in 1.5 times the time of their producer (1017h).",
    why: "Consumers take the node for lost: they send EMCY 8130h and may stop.",
    example: "no heartbeat for 900 ms of a node with a producer time of 500 ms",
    remedy: "Find out why the node was silent, or allow more time in 1016h.",
    source: "CiA 301 §7.2.8.3.2.2",

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
