//! The kinds of incidents on a bus: each is a rule with what it needs, its likely causes, what to check, and what it causes itself.

use objdict_model::diagnostic::{RuleInfo, text_rules};

/// What a kind of incident adds to its rule.
#[derive(Debug)]
pub struct IncidentKind {
    /// The rule: its severity says whether an incident is a problem or a warning.
    pub rule: &'static RuleInfo,
    /// The likely causes, the likeliest first.
    pub causes: &'static [&'static str],
    /// What to check, in this order.
    pub look: &'static [&'static str],
    /// The rules whose incidents are its consequences, if they begin with it.
    pub leads_to: &'static [&'static RuleInfo],
}

macro_rules! incident_kinds {
    ($(
        $id:literal = $NAME:ident, $severity:ident $(, leads to [$($effect:ident),+])?;
        causes: [$($cause:literal),+],
        look: [$($look:literal),+],
        $($part:ident: $text:literal,)+
    )+) => {
        text_rules! { $($id = $NAME, $severity; $($part: $text,)+)+ }

        /// Every kind of incident; one that is earlier is the cause of one that is later.
        pub static KINDS: &[IncidentKind] = &[$(IncidentKind {
            rule: &$NAME,
            causes: &[$($cause),+],
            look: &[$($look),+],
            leads_to: &[$($(&$effect),+)?],
        }),+];
    };
}

incident_kinds! {
    "traffic/bus-off" = BUS_OFF, Error, leads to [ERROR_FRAMES, LATE_HEARTBEAT, UNANSWERED_REQUEST, EVENT_TIMER, SYNC_CYCLE, SILENT_NODE, EMERGENCY, REPEATED_PDO];
        causes: ["a short circuit or an open line", "a wrong bit rate", "missing termination"],
        look: ["measure 60 Ω between CAN_H and CAN_L with the supply off", "check that all nodes use the same bit rate", "disconnect nodes one by one"],
        summary: "the logger is bus-off",
        checks: "An error frame must not report bus-off.",
        needs: "Error frames in the log (`candump -e`).",
        why: "The logger's controller has left the bus, so frames are missing in the log and perhaps on the bus.",
        example: "an error frame with the class bus-off",
        remedy: "Repair the wiring and restart the logger's controller.",
        source: "ISO 11898-1 §12.1.4",

    "traffic/interrupted-bus" = INTERRUPTED_BUS, Error, leads to [LATE_HEARTBEAT, UNANSWERED_REQUEST, EVENT_TIMER, SYNC_CYCLE, SILENT_NODE, EMERGENCY, REPEATED_PDO];
        causes: ["the common supply or the trunk line", "the logger lost frames or was paused", "the manager stopped the bus"],
        look: ["check the supply and the trunk cable", "compare with a second logger"],
        summary: "several nodes fall silent at once",
        checks: "At least two nodes fall silent or are late at once.",
        needs: "Nodes with heartbeats or cyclic messages.",
        why: "The silence has one cause: the bus, the supply or the log.",
        example: "no heartbeat of nodes 3, 4 and 5 after the same moment",
        remedy: "Look for a cause that the nodes share.",
        source: "CiA 301 §7.2.8.3.2.2",

    "traffic/missing-node" = MISSING_NODE, Error, leads to [UNANSWERED_REQUEST, EMERGENCY];
        causes: ["the node is off or not connected", "the node has a different node-ID", "the node has a different bit rate"],
        look: ["check the node-ID of the device (switches, LSS)", "check supply, connector and bit rate of the node", "look for frames with an unexpected CAN-ID"],
        summary: "a node never responds",
        checks: "A node that is addressed by SDO, or individually by an NMT command, must send at least one frame.",
        needs: "Responses of other nodes. Scans, which address more than three absent nodes, are excluded.",
        why: "The node is not on the bus, so it ignores every request of the manager.",
        example: "a read of 1000h of node 4, which sends no frame",
        remedy: "Connect the node, or remove it from the manager's configuration.",
        source: "CiA 301 §7.2.4",

    "traffic/unexpected-boot-up" = UNEXPECTED_BOOT_UP, Error, leads to [NOT_OPERATIONAL, LATE_HEARTBEAT, EVENT_TIMER, EMERGENCY, UNANSWERED_REQUEST, SILENT_NODE, NOT_STARTED, DRIVE_FAULT];
        causes: ["a dip of the supply", "the watchdog of the node", "a fault in its firmware"],
        look: ["measure the supply of the node when loads switch", "read 1003h and the reset cause of the node", "make the manager reconfigure the node"],
        summary: "a node reboots during operation",
        checks: "An operational node may send a boot-up message only after an NMT command that resets it.",
        needs: "NMT commands in the log, and an earlier frame of the node.",
        why: "The watchdog or the supply has reset the node, and its configuration is lost.",
        example: "a boot-up message between two PDOs of a node",
        remedy: "Check the node's supply and watchdog, and let the manager configure the node again.",
        source: "CiA 301 §7.3.2.1",

    "traffic/repeated-boot" = REPEATED_BOOT, Error, leads to [UNEXPECTED_BOOT_UP, NOT_OPERATIONAL, LATE_HEARTBEAT, EMERGENCY, UNANSWERED_REQUEST, NOT_STARTED, REFUSED_WRITE];
        causes: ["the manager does not accept the node and resets it again", "the node's supply voltage drops", "the watchdog of the node"],
        look: ["check the last frames before each boot-up for a rejected write or a wrong identity", "measure the supply of the node"],
        summary: "a node reboots repeatedly",
        checks: "A node must not send three or more boot-up messages at intervals of at most ten seconds.",
        needs: "Boot-up messages.",
        why: "The node never becomes usable.",
        example: "three boot-up messages of node 5 in four seconds",
        remedy: "Remove the cause of the failed boots; the last frames before each boot-up show it.",
        source: "CiA 302-2 §5",

    "traffic/late-heartbeat" = LATE_HEARTBEAT, Error, leads to [EVENT_TIMER, UNANSWERED_REQUEST, EMERGENCY, SILENT_NODE, SYNC_CYCLE, NOT_STARTED];
        causes: ["supply or connector of the node", "the node hangs, or its watchdog resets it", "bit errors: wiring, termination, bit rate", "the node is busy, for example storing parameters"],
        look: ["check supply and status LEDs of the node", "check connector and cable at the time of the incident", "look for error frames and a boot-up message after it"],
        summary: "a heartbeat is late",
        checks: "A heartbeat must arrive within 1.5 times the producer time (1017h), or within the shorter consumer time (1016h). Without both, it must arrive within three times its previous regular period.",
        needs: "A producer or consumer time, in the description or in the log, or three regular heartbeats.",
        why: "Consumers consider the node lost: they send EMCY 8130h and may stop.",
        example: "no heartbeat for 900 ms of a node with a producer time of 500 ms",
        remedy: "Find out why the node was silent, or allow more time in 1017h and in the 1016h of consumers with a shorter time.",
        source: "CiA 301 §7.2.8.3.2.2",

    "traffic/silent-node" = SILENT_NODE, Error, leads to [EVENT_TIMER, UNANSWERED_REQUEST, EMERGENCY];
        causes: ["supply or connector of the node", "the node hangs"],
        look: ["check supply and status LEDs of the node", "check connector and cable"],
        summary: "a node or a cyclic PDO falls silent",
        checks: "A node without a heartbeat must continue to respond to guarding. PDOs that were sent at regular times must continue, even if their node has a heartbeat.",
        needs: "A response to guarding, or a PDO that was sent 20 times at regular intervals, mostly with unchanged data. PDOs that are sent only on changes do not qualify. Stopped or reset nodes and PDOs without their SYNC are excluded.",
        why: "Nothing monitors such a node, so the manager works with old values.",
        example: "no TPDO 1 for three seconds, after 300 frames 10 ms apart",
        remedy: "Find out why the node was silent, and enable its heartbeat (1017h).",
        source: "CiA 301 §7.2.8",

    "traffic/drive-fault" = DRIVE_FAULT, Error, leads to [EMERGENCY, EVENT_TIMER, REFUSED_TRANSITION, QUICK_STOP, SILENT_NODE, MOTION_ERROR, INTERNAL_LIMIT, SET_POINT, RPDO_DEADLINE];
        causes: ["the fault that EMCY and 603Fh report", "if the drive reports none: a safety input, STO or the motor supply"],
        look: ["look up the error code in the drive's manual", "read 603Fh (683Fh for the second axis)", "remove the cause, then reset the fault: controlword 80h, 06h, 07h, 0Fh"],
        summary: "a drive reports a fault",
        checks: "The statusword (6041h, plus 800h for each further axis) must not show a fault.",
        needs: "A PDO or SDO with the statusword. The PDO mapping is known from the description, from the log or, for PDO 1, from CiA 402.",
        why: "A drive with a fault has no torque and ignores commands until the fault is reset.",
        example: "a statusword of 0218h",
        remedy: "Remove the cause, then reset the fault.",
        source: "CiA 402-2 §8.4",

    "traffic/emergency" = EMERGENCY, Error;
        causes: ["the fault that the error code identifies"],
        look: ["look up the error code in the manual of the device", "read 1001h and 1003h of the node"],
        summary: "a node reports an error",
        checks: "A node must not send EMCY with an error code. EMCY 0000h or a boot-up message ends the incident.",
        needs: "EMCY messages.",
        why: "The device has a problem and may have stopped.",
        example: "EMCY 3210h of node 5",
        remedy: "Remove the cause that the manual lists for the code.",
        source: "CiA 301 §7.2.7",

    "traffic/refused-write" = REFUSED_WRITE, Error;
        causes: ["the configuration is for a different device or firmware", "the entry is not writable in the current state", "the value is out of range"],
        look: ["compare the entry with the description and the manual of this revision", "correct the configuration of the manager"],
        summary: "a node rejects a write",
        checks: "A node must not abort a write. The incident ends when the node accepts a later write of the entry.",
        needs: "The request and its response.",
        why: "The device's value differs from the configuration.",
        example: "a write of 2001h that is aborted with 0602 0000h",
        remedy: "Correct the configuration, or the description from which it is generated.",
        source: "CiA 301 §7.2.4.3.17",

    "traffic/unanswered-request" = UNANSWERED_REQUEST, Error;
        causes: ["the node is stopped or busy", "the node has no SDO server for this request", "the response has a different COB-ID"],
        look: ["check the NMT state of the node", "repeat the request with only this node on the bus"],
        summary: "an SDO request gets no response",
        checks: "Each transfer that a client starts must get a response before the next one starts or, at the end of the log, within a second. A client must not give up (abort 0504 0000h).",
        needs: "Any response in the log, and a node that is described or was seen.",
        why: "The node is off, stopped or has a different node-ID. A manager that waits for the response does not boot the node.",
        example: "a read of 1018h of a node that is silent",
        remedy: "Check the node, its state and the bus termination.",
        source: "CiA 301 §7.2.4",

    "traffic/broken-transfer" = BROKEN_TRANSFER, Error;
        causes: ["a fault in the SDO client or server", "a lost frame"],
        look: ["compare the preceding segments with CiA 301", "look for error frames at this time"],
        summary: "an SDO transfer breaks the protocol",
        checks: "The toggle bits of segments must alternate, the number of bytes must match the announced size, and block checksums must be correct. Neither side may abort for such a reason (0503h, 0504h).",
        needs: "All frames of the transfer, from its start.",
        why: "The other side aborts the transfer or accepts a wrong value.",
        example: "a block transfer with the checksum DEADh",
        remedy: "Correct the client or server that sends the faulty frame.",
        source: "CiA 301 §7.2.4.3",

    "traffic/not-operational" = NOT_OPERATIONAL, Error, leads to [NOT_STARTED];
        causes: ["the firmware sends PDOs in any state", "the log lacks the command that started the node"],
        look: ["look for the NMT command before the PDO"],
        summary: "a node that is not operational sends PDOs",
        checks: "A node may send PDOs only when operational. Boot-up messages, heartbeats and NMT commands show its state.",
        needs: "NMT commands in the log. Nodes that start by themselves (1F80h, bit 2) are excluded.",
        why: "In other states a node has no PDOs. The manager does not expect them, and their values may not be valid yet.",
        example: "a TPDO directly after the boot-up message",
        remedy: "Start the node with an NMT command first, or correct its firmware.",
        source: "CiA 301 §7.3.2.2.5",

    "traffic/not-started" = NOT_STARTED, Warning;
        causes: ["the manager waits for a node or a response", "the node is not in the list of the manager (1F81h)"],
        look: ["look for the last SDO of the manager to this node"],
        summary: "a node is never started",
        checks: "A node that boots must become operational.",
        needs: "An NMT command that starts a different node, and two seconds of log after the boot-up message.",
        why: "Until it is started, the node neither sends nor receives PDOs.",
        example: "node 13 boots, is configured, and stays pre-operational",
        remedy: "Start the node, or write 1F80h so that it starts by itself.",
        source: "CiA 302-2 §5",

    "traffic/limit-switch" = LIMIT_SWITCH, Warning, leads to [QUICK_STOP, INTERNAL_LIMIT];
        causes: ["the axis was moved to its end", "wiring or polarity of the switch", "a wrong position after power-up: no homing"],
        look: ["check the position of the axis", "compare the position (6064h) with the software limits (607Dh)"],
        summary: "a drive is on a limit switch",
        checks: "A limit switch in the digital inputs (60FDh, bits 0 and 1, plus 800h for each further axis) may become active only while the drive is homing.",
        needs: "A PDO or SDO with 60FDh that showed the switch as inactive before.",
        why: "The drive stops and moves only in the opposite direction.",
        example: "60FDh changes from 0 to 2",
        remedy: "Move the axis off the switch, and find out why it reached the switch.",
        source: "CiA 402-2 §19.4",

    "traffic/motion-error" = MOTION_ERROR, Error, leads to [QUICK_STOP, SET_POINT, INTERNAL_LIMIT];
        causes: ["the axis is blocked or overloaded", "acceleration or velocity is too high", "wrong gains of the control loop, or a window that is too small (6065h)"],
        look: ["compare demand (6062h) and actual value (6064h) at this time", "read the following error window (6065h) and its time (6066h)"],
        summary: "a drive reports a mode-specific error",
        checks: "Bit 13 of the statusword must not be set in a mode that defines it: following error (modes 1 and 8), slippage (3) or homing error (6).",
        needs: "A PDO or SDO with the statusword, and one with the mode (6061h).",
        why: "The axis does not move as it should.",
        example: "a statusword of 2237h in mode 8",
        remedy: "Remove the cause, or change the profile or the window.",
        source: "CiA 402-2 §11",

    "traffic/set-point" = SET_POINT, Warning;
        causes: ["a limit or the mode prevents the drive from accepting it", "the controlword changes before the drive reads it"],
        look: ["check the mode (6061h), the limits (607Dh) and bit 12 of the statusword"],
        summary: "a drive does not acknowledge a set-point",
        checks: "A drive in profile position mode (1) must set bit 12 of its statusword within half a second after bit 4 of the controlword is set.",
        needs: "Controlword, statusword and mode (6061h) in the log.",
        why: "The drive does not move to the position.",
        example: "a controlword of 1Fh, and a statusword of 0237h a second later",
        remedy: "Keep bit 4 set until bit 12 of the statusword is set, then clear it.",
        source: "CiA 402-2 §11.3",

    "traffic/internal-limit" = INTERNAL_LIMIT, Warning;
        causes: ["a set-point beyond a limit (607Dh, 607Fh, 6072h)", "a limit switch"],
        look: ["compare the set-point with the limits"],
        summary: "a drive's internal limit is active",
        checks: "Bit 11 of the statusword must not be set while operation is enabled.",
        needs: "A PDO or SDO with the statusword.",
        why: "The drive does not follow the set-point.",
        example: "a statusword of 0A37h",
        remedy: "Correct the set-point or the limit.",
        source: "CiA 402-2 §8.4",

    "traffic/quick-stop" = QUICK_STOP, Warning;
        causes: ["a limit switch or a stop input", "the quick stop of the other axis"],
        look: ["check the digital inputs (60FDh), and look up the quick-stop triggers in the manual"],
        summary: "a drive stops by itself",
        checks: "The statusword shows a quick stop that no controlword requested.",
        needs: "Controlword and statusword in the log.",
        why: "The drive has aborted its motion.",
        example: "a statusword of 0207h after the controlword 0Fh",
        remedy: "Remove the cause, then enable operation again.",
        source: "CiA 402-2 §8.4",

    "traffic/refused-transition" = REFUSED_TRANSITION, Warning;
        causes: ["the motor supply or the STO signal is missing", "a step of the sequence 06h, 07h, 0Fh is missing"],
        look: ["check motor supply, STO and brake", "compare the preceding controlwords with the state machine"],
        summary: "a drive does not enable operation",
        checks: "A drive must be in the state operation enabled two seconds after the controlword requests it.",
        needs: "Controlword and statusword in the log.",
        why: "The drive does not move.",
        example: "a controlword of 0Fh with a statusword of 0231h",
        remedy: "Follow the state machine: 06h, 07h, 0Fh.",
        source: "CiA 402-2 §8.4",

    "traffic/error-frames" = ERROR_FRAMES, Warning;
        causes: ["missing or additional termination", "wiring, shield or ground", "two bit rates on the bus"],
        look: ["measure 60 Ω between CAN_H and CAN_L with the supply off", "check which frames precede them"],
        summary: "the log contains error frames",
        checks: "The log must not contain error frames.",
        needs: "A logger that records error frames (`candump -e`).",
        why: "Frames are repeated or lost; heartbeats and SDOs fail sporadically.",
        example: "two error frames in six seconds",
        remedy: "Repair the wiring and the termination.",
        source: "ISO 11898-1 §10.4",

    "traffic/pdo-length" = PDO_LENGTH, Error;
        causes: ["the sender's mapping differs from the description", "two nodes send this CAN-ID"],
        look: ["compare 1A00h and 1600h of sender and receiver with the description", "look for a second sender of the CAN-ID"],
        summary: "a PDO's length differs from its mapping",
        checks: "Each PDO of a node must have as many bytes as its mapping in the description, or as the mapping that was written in the log.",
        needs: "A mapping, in the description or written in the log.",
        why: "Receivers discard a PDO that is too short and send EMCY 8210h, or they read wrong values.",
        example: "6 bytes of a TPDO that maps 7",
        remedy: "Correct the mapping in the description or in the node.",
        source: "CiA 301 §7.2.2.4",

    "traffic/event-timer" = EVENT_TIMER, Warning;
        causes: ["the node is delayed", "the event timer was not written to the node"],
        look: ["read 1800h sub-index 5 of the node", "look for traffic with higher priority"],
        summary: "a PDO exceeds its event timer",
        checks: "An event-driven PDO must follow its predecessor within 1.5 times the event timer.",
        needs: "The event timer, in the description or in the log. Nodes that were started, stopped or reset in between are excluded.",
        why: "Receivers that monitor the PDO consider it lost.",
        example: "a TPDO after 490 ms, with an event timer of 100 ms",
        remedy: "Find out what delayed the node, or write the event timer to the node (1800h, sub-index 5).",
        source: "CiA 301 §7.5.2.37",

    "traffic/rpdo-deadline" = RPDO_DEADLINE, Warning;
        causes: ["the sender is delayed or silent", "the deadline is shorter than the period of the sender"],
        look: ["compare 1400h sub-index 5 with the event timer or the SYNC of the sender"],
        summary: "a PDO arrives after its receiver's deadline",
        checks: "A PDO must arrive within the deadline of each node that receives it (sub-index 5 of the RPDO).",
        needs: "The deadline, in the description or in the log, and a previous PDO.",
        why: "The receiver reports EMCY 8250h and may stop.",
        example: "400 ms between two PDOs, with a deadline of 100 ms",
        remedy: "Find out what delays the sender, or allow more time.",
        source: "CiA 301 §7.5.2.35",

    "traffic/inhibit-time" = INHIBIT_TIME, Warning;
        causes: ["the inhibit time was not written to the node", "two nodes send this CAN-ID"],
        look: ["read 1800h sub-index 3 of the node"],
        summary: "a PDO is sent before its inhibit time elapses",
        checks: "Event-driven PDOs must be at least one inhibit time apart (tolerance 5 %).",
        needs: "The inhibit time, in the description or in the log.",
        why: "The inhibit time limits the bus load; without it, messages of lower priority may be late.",
        example: "a TPDO after 5 ms, with an inhibit time of 10 ms",
        remedy: "Write the inhibit time to the node (1800h, sub-index 3), or correct the description.",
        source: "CiA 301 §7.5.2.36",

    "traffic/sync-cycle" = SYNC_CYCLE, Warning;
        causes: ["a second node produces SYNC", "the manager is delayed", "traffic with higher priority"],
        look: ["read 1005h bit 30 of each node: only one may produce SYNC", "check the bus load at this time"],
        summary: "the SYNC period is irregular",
        checks: "Until the end of the log, each SYNC must arrive 0.5 to 1.5 times the communication cycle period (1006h) after the previous one. Without 1006h, the period of a SYNC that was regular applies.",
        needs: "1006h, or a SYNC that was regular 20 times. SYNC may end after a command that stops nodes.",
        why: "Synchronous PDOs depend on SYNC: drives interpolate with a wrong time, and outputs are late.",
        example: "62 ms between two SYNC, with a period of 20 ms",
        remedy: "Look for a second SYNC producer, for load of higher priority, and for a delayed manager.",
        source: "CiA 301 §7.2.5",

    "traffic/sync-window" = SYNC_WINDOW, Warning;
        causes: ["the window is too short for the load after SYNC", "the node is late"],
        look: ["compare 1007h with the time of the last synchronous PDO"],
        summary: "a synchronous PDO misses the SYNC window",
        checks: "A synchronous PDO must arrive within the synchronous window length (1007h) after SYNC.",
        needs: "1007h, in the description or in the log.",
        why: "Consumers assign the value to the next cycle, and nodes discard PDOs outside the window.",
        example: "a PDO 3 ms after SYNC, with a window of 2 ms",
        remedy: "Make the window longer, or send fewer messages before the PDO.",
        source: "CiA 301 §7.5.2.8",

    "traffic/shared-can-id" = SHARED_CAN_ID, Warning;
        causes: ["two nodes use the same node-ID", "two PDOs use the same COB-ID"],
        look: ["switch one node off and check whether the CAN-ID is still sent", "read the COB-IDs of all TPDOs (1800h to 19FFh sub-index 1)"],
        summary: "two nodes probably send with one CAN-ID",
        checks: "A frame's CAN-ID must not belong to two valid TPDOs. Heartbeats must not arrive twice per period four times in a row.",
        needs: "COB-IDs or the heartbeat time (1017h), in descriptions or in the log. A frame does not identify its sender, so the finding is only probable.",
        why: "Receivers mix the values of both senders, and both controllers go bus-off when they send at the same time.",
        example: "heartbeats of node 5 after 30 and 70 ms in turn, with a time of 100 ms",
        remedy: "Give one of the nodes a different node-ID, or one of the PDOs a different COB-ID.",
        source: "CiA 301 §7.3.5",

    "traffic/load-peak" = LOAD_PEAK, Warning;
        causes: ["many PDOs after one SYNC or one event", "event-driven PDOs without an inhibit time"],
        look: ["find the shortest intervals in the list of messages", "distribute synchronous PDOs over several SYNCs"],
        summary: "bus load peaks at 90 % or more",
        checks: "The bus load must not be 90 % or more for 100 ms.",
        needs: "The bit rate (from the network or DCF, or `--bit-rate`). A load above 100 % is ignored: it shows that the logger's timestamps differ from the times on the bus.",
        why: "Low-priority messages are late: heartbeats, SDOs.",
        example: "96 % for 100 ms, with 30 % on average",
        remedy: "Set inhibit times for event-driven PDOs, or increase the bit rate.",
        source: "CiA 301 §5.4",

    "traffic/repeated-pdo" = REPEATED_PDO, Warning;
        causes: ["two nodes send this CAN-ID", "a SYNC is missing in the log"],
        look: ["switch the node off and check whether the CAN-ID is still sent"],
        summary: "a synchronous PDO is sent twice after one SYNC",
        checks: "PDOs with a transmission type from 1 to 240 may be sent at most once after each SYNC.",
        needs: "The transmission type, in the description or in the log.",
        why: "Two nodes may send the same CAN-ID, or a SYNC was not received.",
        example: "two frames of a TPDO 1 ms apart, with a SYNC every 20 ms",
        remedy: "Look for a second sender of the CAN-ID, and for a node that is late by a whole cycle.",
        source: "CiA 301 §7.2.2.2",

    "traffic/unknown-node" = UNKNOWN_NODE, Warning;
        causes: ["a wrong node-ID or COB-ID", "a node that is not in the project"],
        look: ["switch nodes off one by one until the CAN-ID disappears"],
        summary: "a node that is not in the network sends frames",
        checks: "The network must describe each node that sends frames.",
        needs: "A network. Descriptions of single nodes are not enough.",
        why: "A node has a wrong node-ID or COB-ID, or is not in the project. Its CAN-IDs may collide with other nodes.",
        example: "frames with the CAN-ID 1A3h in a network without node 35",
        remedy: "Add the node to the network, or correct its node-ID.",
        source: "CiA 301 §7.3.5",

    "traffic/sdo-length" = SDO_LENGTH, Warning;
        causes: ["a client or node truncates SDO frames"],
        look: ["check which side sends the frame"],
        summary: "an SDO frame is not 8 bytes long",
        checks: "Each frame of an SDO transfer must have 8 bytes.",
        needs: "Frames of SDO transfers.",
        why: "Many nodes discard shorter frames.",
        example: "a request of 6 bytes",
        remedy: "Pad the frame with zeros.",
        source: "CiA 301 §7.2.4.3",

    "traffic/malformed-frame" = MALFORMED_FRAME, Warning;
        causes: ["a different protocol on the bus", "a fault in the sender's firmware"],
        look: ["find the node that sends the CAN-ID"],
        summary: "a service frame has the wrong length",
        checks: "SYNC may have at most one byte; NMT commands have two, heartbeats one, EMCY eight and TIME six.",
        needs: "Frames of these services.",
        why: "Nodes discard the frame, or report EMCY 8240h.",
        example: "a SYNC of two bytes",
        remedy: "Correct the sender.",
        source: "CiA 301 §7.2",

    "traffic/other-identity" = OTHER_IDENTITY, Error;
        causes: ["a different device or version was installed", "the description belongs to a different device"],
        look: ["compare the label of the device with the description"],
        summary: "a node is not the described device",
        checks: "The device type (1000h), vendor-ID, product code and upper half of the revision number (1018h) that a node returns must match its description.",
        needs: "A description of the node that contains these values, and a response of the node.",
        why: "Entries and PDOs may differ from the description.",
        example: "a product code of 12h, and 11h in the description",
        remedy: "Use the description of this device, or install the described device.",
        source: "CiA 301 §7.5.2.18",

    "traffic/sdo-size" = SDO_SIZE, Error;
        causes: ["the description belongs to a different firmware version"],
        look: ["compare the revision (1018h sub-index 3) with the description"],
        summary: "a value's size differs from its data type",
        checks: "Each value that a node returns or accepts must have as many bytes as the `DataType` of its entry.",
        needs: "A description of the node. Transfers that do not indicate how many of their four bytes are used are excluded.",
        why: "A client that follows the description reads or sends a wrong number, or is rejected.",
        example: "two bytes of an entry that is described as UNSIGNED32",
        remedy: "Correct `DataType` or the device, which must abort a write of a different size with 0607 0010h.",
        source: "CiA 301 §7.2.4.3",

    "traffic/sdo-access" = SDO_ACCESS, Warning;
        causes: ["the description belongs to a different firmware version"],
        look: ["compare the revision (1018h sub-index 3) with the description"],
        summary: "an SDO transfer succeeds despite the entry's access",
        checks: "A node must reject writes to ro and const entries, and reads of wo entries.",
        needs: "A description of the node.",
        why: "The description belongs to a different version of the device, or the device does not protect the entry.",
        example: "a node accepts a value for an entry with `AccessType=ro`",
        remedy: "Correct `AccessType`, or let the device abort with 0601 0001h or 0601 0002h.",
        source: "CiA 301 §7.2.4.3.17",

    "traffic/sdo-limits" = SDO_LIMITS, Error;
        causes: ["the description belongs to a different firmware version"],
        look: ["compare the limits with the manual"],
        summary: "a value in an SDO transfer is outside its limits",
        checks: "Values that a node returns or accepts must be within `LowLimit` and `HighLimit`.",
        needs: "A description of the node.",
        why: "The device's limits differ from the described limits, or the device does not check them.",
        example: "120 for an entry with `HighLimit=100`",
        remedy: "Correct the limits or the device.",
        source: "CiA 306-1 §4.6.3.2",
}
