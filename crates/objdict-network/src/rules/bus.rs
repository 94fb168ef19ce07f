//! The rules about shared resources of nodes: the bus, the CAN-IDs, and each other's services.

use crate::diagnostic::text_rules;

text_rules! {
    "network/duplicate-node-id" = DUPLICATE_NODE_ID, Error;
    summary: "two nodes have the same node-ID",
    checks: "Each node-ID may be used by only one node, including the manager.",
    why: "Both nodes respond at once, and each destroys the other's frames. dcfgen does not report it.",
    example: "a node that was copied, with the node-ID of the original",
    remedy: "Assign one of them a different node-ID.",
    source: "CiA 301 §7.3.5",

    "network/unsupported-bit-rate" = UNSUPPORTED_BIT_RATE, Error;
    summary: "a node does not support the bit rate of the network",
    checks: "The bit rate must be one of CiA 301, and the `BaudRate_x` keys of each description must allow it. Each DCF or XDC must state the same bit rate. If the network has no bit rate, DCFs are compared with the first one.",
    why: "The node goes bus-off or prevents other nodes from sending.",
    example: "a network of 1000 kbit/s with a node that has `BaudRate_1000=0`, `bit-rate = 100`",
    remedy: "Use a bit rate that all nodes support, or correct the DCF.",
    source: "CiA 301 §6.2; CiA 306-1 §4.6.2",

    "network/duplicate-can-id" = DUPLICATE_CAN_ID, Error;
    summary: "two nodes send the same CAN-ID",
    checks: "Only one node may send each CAN-ID. This covers PDOs, EMCY, SDO and heartbeats of all nodes, and all frames of the manager. A manager without a description has a PDO for each RPDO that no node sends, so each of these needs a CAN-ID of its own. The manager is the client of each node's default SDO, so no other client (1280h) may use its CAN-IDs.",
    why: "CAN has no arbitration between equal CAN-IDs: frames with different data destroy each other, and receivers use the data of both.",
    example: "TPDO 1 of two nodes on 18Bh, or a TPDO on 585h, where node 5 answers SDOs",
    remedy: "Assign one of them a different CAN-ID. An RPDO selects the frames that a node receives.",
    source: "CiA 301 §7.3.3",

    "network/restricted-can-id" = RESTRICTED_CAN_ID, Error;
    summary: "a service has a CAN-ID that belongs to a different service",
    checks: "A valid PDO must have a CAN-ID that CiA 301 leaves to PDOs. The same applies to SYNC, TIME and EMCY as descriptions define them. If the network file sets these services, `cia301/restricted-can-id` checks them.",
    why: "The service disturbs NMT, SDO or error control of other nodes, including nodes added later.",
    example: "`cob_id: 0x605`",
    remedy: "Use a CAN-ID of 181h to 57Fh or 680h to 6DFh.",
    source: "CiA 301 §7.3.5, table 40",

    "network/pdo-length" = PDO_LENGTH, Error;
    summary: "sender and receiver of a PDO disagree about its length",
    checks: "The TPDO with the CAN-ID of an RPDO must have the number of bytes that the RPDO maps. If it has more bytes, the finding is a warning.",
    why: "A node does not process a PDO that is too short and sends EMCY 8210h. If a PDO is too long, it uses the first bytes; many devices also send EMCY 8220h, once.",
    example: "a TPDO with 16 bits, received by an RPDO with 32",
    remedy: "Map the same lengths, with dummies for the entries that the receiver does not need.",
    source: "CiA 301 §7.2.2, §7.4.7.1",

    "network/no-sync-sender" = NO_SYNC_SENDER, Error;
    summary: "a PDO waits for SYNC, but no node sends it",
    checks: "If SYNC triggers a valid PDO's transmission type, a node must send SYNC with the CAN-ID of 1005h. It is a warning if no node sends SYNC, because the nodes boot. A different CAN-ID is a warning for PDOs that the network file does not configure and no described node shares.",
    why: "The PDO is never sent or has no effect.",
    example: "`transmission: 1` without `sync_period`, 1005h = 81h in one node",
    remedy: "Set the SYNC period of the manager, give SYNC one CAN-ID, or use an event-driven transmission type.",
    source: "CiA 301 §7.2.2.2, §7.5.2.5",

    "network/duplicate-sync-sender" = DUPLICATE_SYNC_SENDER, Error;
    summary: "two nodes send SYNC or TIME",
    checks: "At most one node may send SYNC, and at most one may send TIME.",
    why: "Synchronous PDOs are sent at twice the rate, and their counter is wrong.",
    example: "`sync_period` of the manager, and a DCF in which 1005h has bit 30",
    remedy: "Keep one of them; clear bit 30 in the others.",
    source: "CiA 301 §7.5.2.5",

    "network/sync-counter" = SYNC_COUNTER, Error;
    summary: "nodes count SYNC differently",
    checks: "1019h of all nodes that receive SYNC must have the sender's value. A node without 1019h expects no counter.",
    why: "A SYNC of a different length causes EMCY 8240h, and PDOs with a SYNC start value never start.",
    example: "`sync_overflow: 10` of the manager and 1019h = 0 in a node",
    remedy: "Set 1019h to the same value in all nodes.",
    source: "CiA 301 §7.5.2.22",

    "network/sync-window" = SYNC_WINDOW, Warning;
    summary: "the synchronous PDOs exceed their time",
    checks: "SYNC and all synchronous PDOs, each with the maximum number of stuff bits, must fit into the synchronous window length. Without one, they must fit into the communication cycle period. A window longer than the period is an error.",
    why: "Nodes drop a synchronous PDO that they could not send within the window; without a window, PDOs run into the next cycle.",
    example: "20 PDOs of 8 bytes and a cycle of 10 ms at 125 kbit/s",
    remedy: "Lengthen the window or the cycle, or divide the PDOs by transmission types and SYNC start values.",
    source: "CiA 301 §7.5.2.7",

    "network/pdo-times" = PDO_TIMES, Warning;
    summary: "the times of a PDO contradict each other",
    checks: "A TPDO's event timer must not be shorter than its inhibit time. Each receiver must wait longer than the event timer, including the manager of a `bus.yml`. A shorter deadline is an error.",
    why: "A PDO is not sent more often than its inhibit time allows; a receiver whose deadline is too short reports EMCY 8250h continuously.",
    example: "an inhibit time of 100 ms, an event timer of 50 ms",
    remedy: "Make the event timer longer than the inhibit time, and the deadline longer than the event timer.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",

    "network/short-heartbeat-time" = SHORT_HEARTBEAT_TIME, Warning;
    summary: "a consumer heartbeat time is too short",
    checks: "Each consumer heartbeat time must be at least 1.5 times the producer heartbeat time of the monitored node. If it is not longer than the producer heartbeat time, the finding is an error.",
    why: "A heartbeat has the lowest priority, so under load nodes report the loss of nodes that are present.",
    example: "`heartbeat_multiplier: 1.0`",
    remedy: "Use a consumer heartbeat time of 1.5 to 3 times the producer heartbeat time.",
    source: "CiA 301 §7.2.8.3.2",

    "network/silent-node" = SILENT_NODE, Warning;
    summary: "a monitored node sends no heartbeat",
    checks: "Each node monitored by 1016h must be in the network and have a producer heartbeat time. The manager needs one too if a node monitors it. It is an error if a node monitors itself, or if the network file writes a missing node into 1016h. A node without a heartbeat that the manager boots is also an error: the manager waits for the first heartbeat.",
    why: "The monitoring never starts or continuously reports the loss of the node.",
    example: "1016h:01 with node 7 in a network without it",
    remedy: "Set the producer heartbeat time of the node, or free the sub-index of 1016h.",
    source: "CiA 301 §7.5.2.19",

    "network/wrong-identity" = WRONG_IDENTITY, Warning;
    summary: "the identity that the manager expects differs from the description",
    checks: "The network file's revision number, serial number (1018h or `LSS_SerialNumber`) and software version (1F56h) must match the node's description. So must 1F84h to 1F88h and 1028h of a described manager. If the manager boots the node, a number that the node does not report is an error.",
    why: "The manager does not boot the node or does not receive its emergencies.",
    example: "`revision_number: 0x20000` for an EDS with the revision 10000h",
    remedy: "Correct the number, or use the description that belongs to the device.",
    source: "CiA 302-2, 1F84h to 1F88h",

    "network/ambiguous-identity" = AMBIGUOUS_IDENTITY, Warning;
    summary: "a description states two numbers for a value that the manager checks",
    checks: "The manager expects the vendor-ID, product code and revision number of `DeviceInfo` in 1F85h to 1F87h. They must match 1018h of the same description. 0 and FFFFFFFFh are treated as not stated. If the manager expects a number that differs from 1018h, it is an error.",
    why: "The manager does not boot a node that responds with a different number. Vendors often write a file version as `RevisionNumber`.",
    example: "`RevisionNumber=1` for a device with 1018h:03 = 10002h",
    remedy: "Specify the device's number, correct the description, or let the manager check less.",
    source: "CiA 302-2, 1F85h to 1F87h; CiA 306-1, `RevisionNumber`",

    "network/boot-time" = BOOT_TIME, Warning;
    summary: "the configuration takes longer than the boot time",
    checks: "On a bus without other traffic, the downloads of each mandatory node must take less than the manager's boot time.",
    why: "The manager gives up before the network is configured.",
    example: "`boot_time: 50` with 100 downloads at 125 kbit/s",
    remedy: "Lengthen the boot time, store the configuration in the nodes, or omit downloads.",
    source: "CiA 302-2, 1F89h",

    "network/bus-load" = BUS_LOAD, Warning;
    summary: "the bus load is too high",
    checks: "Cyclic PDOs, SYNC and heartbeats, each with the maximum number of stuff bits, may use at most 80 % of the bit rate. Without a stated bit rate, they may use at most all of 1000 kbit/s. Event-driven PDOs are counted with their inhibit time or event timer.",
    why: "PDOs are late, and no capacity is left for SDO and emergencies.",
    example: "30 PDOs of 8 bytes each 10 ms at 250 kbit/s",
    remedy: "Lengthen times, map entries together, or increase the bit rate.",
    source: "CiA 301 §7.2.2",

    "network/late-message" = LATE_MESSAGE, Warning;
    summary: "a message may be sent too late",
    checks: "Each message must be on the bus before its deadline in the worst case. Then all messages of higher priority are sent at once, with the maximum number of stuff bits, during the transmission of an SDO frame. The deadline is the period, the event timer, or the time that a receiver waits. PDOs that an event may trigger at any time, EMCY, NMT and TIME are not counted. Synchronous PDOs are left to `network/sync-window`, unless a receiver waits for them.",
    why: "The next value overwrites one that was not sent, or a receiver reports the loss of the sender.",
    example: "a PDO of 8 bytes each millisecond on 57Fh, behind 8 others at 1000 kbit/s",
    remedy: "Assign the message a lower CAN-ID, lengthen the times of the messages before it, or increase the bit rate. `objdict network timing` shows all times.",
    source: "Davis, Burns, Bril, Lukkien: Controller Area Network (CAN) schedulability analysis (2007)",
}
