//! The rules about what nodes share: the bus, the CAN-IDs, and each other's services.

use crate::diagnostic::text_rules;

text_rules! {
    "network/duplicate-node-id" = DUPLICATE_NODE_ID, Error;
    summary: "two nodes have the same node-ID",
    checks: "Whether each node-ID is that of one node, the manager included.",
    why: "Both nodes answer at once, and each destroys the frames of the other. dcfgen does not report it.",
    example: "a node that was copied, with the node-ID of the original",
    remedy: "Give one of them another node-ID.",
    source: "CiA 301 §7.3.5",

    "network/unsupported-bit-rate" = UNSUPPORTED_BIT_RATE, Error;
    summary: "a node does not support the bit rate of the network",
    checks: "Whether the bit rate is one of CiA 301, the `BaudRate_x` keys of each description allow it, and each DCF or XDC states the same one. Without a bit rate of the network, DCFs are compared with the first one.",
    why: "The node goes bus-off, or keeps the others from sending.",
    example: "a network of 1000 kbit/s with a node that has `BaudRate_1000=0`, `bit-rate = 100`",
    remedy: "Use a bit rate that all nodes support, or correct the DCF.",
    source: "CiA 301 §6.2; CiA 306-1 §4.6.2",

    "network/duplicate-can-id" = DUPLICATE_CAN_ID, Error;
    summary: "two nodes send the same CAN-ID",
    checks: "Whether each CAN-ID is sent by one node: PDOs, EMCY, SDO and heartbeats of all nodes, and what the manager sends. A manager without a description has a PDO for each RPDO that no node sends, so each of these needs a CAN-ID of its own. The manager is the client of the default SDO of each node, so no other client (1280h) may use its CAN-IDs.",
    why: "CAN has no arbitration between equal CAN-IDs: frames with different data destroy each other, and receivers take the data of both.",
    example: "TPDO 1 of two nodes on 18Bh, or a TPDO on 585h, where node 5 answers SDOs",
    remedy: "Give one of them another CAN-ID. What a node is to receive is in its RPDO.",
    source: "CiA 301 §7.3.3",

    "network/restricted-can-id" = RESTRICTED_CAN_ID, Error;
    summary: "a service has a CAN-ID that belongs to another one",
    checks: "Whether the CAN-ID of each valid PDO is one that CiA 301 leaves to PDOs, and so for SYNC, TIME and EMCY as descriptions have them. `cia301/restricted-can-id` checks what the network file gives these services.",
    why: "The service disturbs NMT, SDO or error control of other nodes, also of those that are added later.",
    example: "`cob_id: 0x605`",
    remedy: "Use a CAN-ID of 181h to 57Fh or 680h to 6DFh.",
    source: "CiA 301 §7.3.5, table 40",

    "network/pdo-length" = PDO_LENGTH, Error;
    summary: "sender and receiver of a PDO disagree about its length",
    checks: "Whether the TPDO with the CAN-ID of an RPDO has the bytes that the RPDO maps. If it has more bytes, the finding is a warning.",
    why: "A node does not process a PDO that is too short, and sends EMCY 8210h. Of a PDO that is too long, it uses the first bytes; many devices also send EMCY 8220h, once.",
    example: "a TPDO with 16 bits, received by an RPDO with 32",
    remedy: "Map the same lengths, with dummies for the entries that the receiver does not need.",
    source: "CiA 301 §7.2.2, §7.4.7.1",

    "network/no-sync-sender" = NO_SYNC_SENDER, Error;
    summary: "a PDO waits for SYNC, which no node sends",
    checks: "Whether a node sends SYNC, with the CAN-ID of 1005h, where a valid PDO has a transmission type that SYNC triggers. Without any sender of SYNC it is a warning, because the nodes boot, and so is another CAN-ID for PDOs that the network file does not configure and that no described node shares.",
    why: "The PDO is never sent, or takes no effect.",
    example: "`transmission: 1` without `sync_period`, 1005h = 81h in one node",
    remedy: "Set the SYNC period of the manager, give SYNC one CAN-ID, or use an event-driven transmission type.",
    source: "CiA 301 §7.2.2.2, §7.5.2.5",

    "network/duplicate-sync-sender" = DUPLICATE_SYNC_SENDER, Error;
    summary: "two nodes send SYNC or TIME",
    checks: "Whether at most one node sends SYNC, and one TIME.",
    why: "Synchronous PDOs are sent at twice the rate, and their counter is wrong.",
    example: "`sync_period` of the manager, and a DCF in which 1005h has bit 30",
    remedy: "Leave one of them; clear bit 30 in the others.",
    source: "CiA 301 §7.5.2.5",

    "network/sync-counter" = SYNC_COUNTER, Error;
    summary: "nodes count SYNC differently",
    checks: "Whether 1019h of all nodes that hear SYNC has the value of the one that sends it. A node without 1019h expects no counter.",
    why: "A SYNC of another length is an EMCY 8240h, and PDOs with a SYNC start value never start.",
    example: "`sync_overflow: 10` of the manager and 1019h = 0 in a node",
    remedy: "Set 1019h to the same value in all nodes.",
    source: "CiA 301 §7.5.2.22",

    "network/sync-window" = SYNC_WINDOW, Warning;
    summary: "the synchronous PDOs do not fit into their time",
    checks: "Whether SYNC and all synchronous PDOs, each with the most stuff bits, fit into the synchronous window length, or else into the communication cycle period. A window that is longer than the period is an error.",
    why: "Nodes drop a synchronous PDO that they could not send inside the window; without a window PDOs fall into the next cycle.",
    example: "20 PDOs of 8 bytes and a cycle of 10 ms at 125 kbit/s",
    remedy: "Lengthen the window or the cycle, or divide the PDOs by transmission types and SYNC start values.",
    source: "CiA 301 §7.5.2.7",

    "network/pdo-times" = PDO_TIMES, Warning;
    summary: "the times of a PDO contradict each other",
    checks: "Whether the event timer of a TPDO is not shorter than its inhibit time, and each receiver, the manager of a `bus.yml` included, waits longer than the event timer: a shorter deadline is an error.",
    why: "A PDO is not sent more often than its inhibit time allows; a receiver that waits too short reports EMCY 8250h all the time.",
    example: "an inhibit time of 100 ms, an event timer of 50 ms",
    remedy: "Make the event timer longer than the inhibit time, and the deadline longer than the event timer.",
    source: "CiA 301 §7.5.2.35, §7.5.2.37",

    "network/short-heartbeat-time" = SHORT_HEARTBEAT_TIME, Warning;
    summary: "a node waits too short for a heartbeat",
    checks: "Whether each consumer heartbeat time is at least 1.5 times the producer heartbeat time of the node that it monitors. One that is not longer than the producer heartbeat time is an error.",
    why: "A heartbeat has the lowest priority, so under load nodes report the loss of others that are there.",
    example: "`heartbeat_multiplier: 1.0`",
    remedy: "Use a consumer heartbeat time of 1.5 to 3 times the producer heartbeat time.",
    source: "CiA 301 §7.2.8.3.2",

    "network/silent-node" = SILENT_NODE, Warning;
    summary: "a heartbeat is monitored that no node sends",
    checks: "Whether each node that 1016h of another one monitors is in the network and has a producer heartbeat time, and whether the manager has one if a node is to monitor it. A node that monitors itself is an error, and so is one that the network file writes into 1016h and that is not there, and one that the manager boots: it waits for the first heartbeat.",
    why: "The monitoring never begins, or reports the loss of the node for ever.",
    example: "1016h:01 with node 7 in a network without it",
    remedy: "Set the producer heartbeat time of the node, or free the sub-index of 1016h.",
    source: "CiA 301 §7.5.2.19",

    "network/wrong-identity" = WRONG_IDENTITY, Warning;
    summary: "the manager expects another device than the description says",
    checks: "Whether revision number, serial number (1018h or `LSS_SerialNumber`) and software version (1F56h) of the network file, and 1F84h to 1F88h and 1028h of a described manager, are those of the description of the node. A number that the node does not answer is an error if the manager boots the node.",
    why: "The manager does not boot the node, or does not hear its emergencies.",
    example: "`revision_number: 0x20000` for an EDS with the revision 10000h",
    remedy: "Correct the number, or use the description that belongs to the device.",
    source: "CiA 302-2, 1F84h to 1F88h",

    "network/ambiguous-identity" = AMBIGUOUS_IDENTITY, Warning;
    summary: "a description states two numbers for what the manager checks",
    checks: "Whether vendor-ID, product code and revision number of `DeviceInfo`, which the manager expects in 1F85h to 1F87h, are those of 1018h in the same description. 0 and FFFFFFFFh count as not stated. If the manager expects another number than 1018h has, it is an error.",
    why: "The manager does not boot a node that answers with another number. Vendors often write a version of the file as `RevisionNumber`.",
    example: "`RevisionNumber=1` for a device with 1018h:03 = 10002h",
    remedy: "State the number of the device, correct the description, or let the manager check less.",
    source: "CiA 302-2, 1F85h to 1F87h; CiA 306-1, `RevisionNumber`",

    "network/boot-time" = BOOT_TIME, Warning;
    summary: "the configuration takes longer than the boot time",
    checks: "Whether the downloads of each mandatory node take less than the boot time of the manager, on a bus that carries nothing else.",
    why: "The manager gives the network up before it is configured.",
    example: "`boot_time: 50` with 100 downloads at 125 kbit/s",
    remedy: "Lengthen the boot time, store the configuration in the nodes, or leave downloads out.",
    source: "CiA 302-2, 1F89h",

    "network/bus-load" = BUS_LOAD, Warning;
    summary: "the bus is loaded too much",
    checks: "Whether cyclic PDOs, SYNC and heartbeats, each with the most stuff bits, take at most 80 % of the bit rate; without a stated bit rate, at most all of 1000 kbit/s. Event-driven PDOs count with their inhibit time or event timer.",
    why: "PDOs are late, and there is no time for SDO and emergencies.",
    example: "30 PDOs of 8 bytes each 10 ms at 250 kbit/s",
    remedy: "Lengthen times, map entries together, or raise the bit rate.",
    source: "CiA 301 §7.2.2",

    "network/late-message" = LATE_MESSAGE, Warning;
    summary: "a message may come too late",
    checks: "Whether each message is on the bus before its deadline in the worst case: all messages of higher priority come at once, with the most stuff bits, and an SDO frame is just being sent. The deadline is the period, the event timer, or how long a receiver waits. PDOs that an event may trigger at any time, EMCY, NMT and TIME are not counted. Synchronous PDOs, but for those that a receiver waits for, are left to `network/sync-window`.",
    why: "The next value overwrites one that was not sent, or a receiver reports the sender as lost.",
    example: "a PDO of 8 bytes each millisecond on 57Fh, behind 8 others at 1000 kbit/s",
    remedy: "Give the message a lower CAN-ID, lengthen the times of those before it, or raise the bit rate. `objdict network timing` shows all times.",
    source: "Davis, Burns, Bril, Lukkien: Controller Area Network (CAN) schedulability analysis (2007)",
}
