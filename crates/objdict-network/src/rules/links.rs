//! The rules about links, settings and described managers in a `network.toml`.

use crate::diagnostic::text_rules;

text_rules! {
    source: "CiA 301 §7.2.2";

    "network/unknown-node" = UNKNOWN_NODE, Error;
    summary: "a node is named that the network does not have",
    checks: "Each end of a link must begin with the name of a described node, or be the name of a manager without a description. `watches` and `manager` must name nodes.",
    why: "The link has no entries, so no PDO is configured for it; nothing is monitored; the intended node does not become the manager.",
    example: r#"`from = "lefft.6000:1-5"` in a network with the nodes `left` and `plc`"#,
    remedy: "Write the name of the node, or describe the node. A manager without a description is written without entries.",
    source: "objdict",

    "network/unknown-entry" = UNKNOWN_ENTRY, Error;
    summary: "a link names an entry that the node does not have",
    checks: "A link must name entries of each node that has a description. The node's description must contain the object and each sub-index of a range. A name must identify exactly one object or entry.",
    why: "The node rejects the mapping (SDO abort 0602 0000h or 0609 0011h).",
    example: r#"`from = "left.6000:1-9"` where 6000h has eight inputs"#,
    remedy: "Name entries of the description; `objdict show` lists them.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "network/link-direction" = LINK_DIRECTION, Error;
    summary: "a node cannot send or receive a linked entry",
    checks: "A TPDO of the producer and an RPDO of the other node must be able to carry each entry. This depends on its `PDOMapping`, access and data type.",
    why: "The node rejects the mapping (SDO abort 0604 0041h).",
    example: r#"`from = "left.6200:1"`, an output with the access `rww`"#,
    remedy: "Exchange `from` and `to`, or link a different entry.",
    source: "CiA 301 §7.4.7.1; CiA 306-1 §4.6.3",

    "network/link-mismatch" = LINK_MISMATCH, Error;
    summary: "the ends of a link have different numbers of entries or bits",
    checks: "Both ends must name the same number of entries, and each sent entry must have as many bits as the entry that receives it.",
    why: "PDOs have no types: bits are received by position, so the first difference shifts all entries after it.",
    example: r#"`from = "left.6000:1-5"`, `to = "plc.5200:1-4"`"#,
    remedy: "Name the same number of entries of the same length at both ends.",
    source: "CiA 301 §7.4.7.1",

    "network/link-type" = LINK_TYPE, Warning;
    summary: "linked entries have data types with different meanings",
    checks: "Linked entries must be both signed, both unsigned, or both of the same other type. `network/link-mismatch` covers their length.",
    why: "The consumer uses the bits unchanged: -1 becomes 65535, and a REAL32 a meaningless integer.",
    example: "an INTEGER16 to an UNSIGNED16",
    remedy: "Link an entry of the same type, or convert the value in the consumer.",
    source: "CiA 301 §7.1.4",

    "network/link-too-long" = LINK_TOO_LONG, Error;
    summary: "the entries of a link with a CAN-ID need more than one PDO",
    checks: "If a link has a CAN-ID, its entries may have at most 64 bits. They must have only one consumer if a manager without a description sends them.",
    why: "A CAN-ID has one sender and one layout. Without a CAN-ID, the entries are divided.",
    example: r#"`from = "left.6000:1-9"` with `can-id = 0x18B`"#,
    remedy: "Omit the CAN-ID, or divide the link into several links.",

    "network/two-producers" = TWO_PRODUCERS, Error;
    summary: "two links write the same entry",
    checks: "Each entry of a consumer may receive only one entry of one producer. A link that occurs twice is a warning.",
    why: "The entry has the value of the last PDO received.",
    example: r#"`from = "left.6000:1"` and `from = "right.6000:1"`, both with `to = "plc.5200:1"`"#,
    remedy: "Link each producer to an entry of its own.",

    "network/no-free-pdo" = NO_FREE_PDO, Error;
    summary: "a node has no PDO left for a link",
    checks: "The producer needs a TPDO and each consumer an RPDO for the link. No other link may use it, and the network file must not configure it itself.",
    why: "The entries are not sent or not received.",
    example: "links from five nodes to a node with four RPDOs",
    remedy: "Link fewer entries, or entries that fit into PDOs together: links with the same nodes and the same parameters share PDOs.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "network/moved-can-id" = MOVED_CAN_ID, Note;
    summary: "a PDO leaves its predefined CAN-ID",
    checks: "Reports the PDO of a link without a `can-id` if it leaves its CAN-ID of the predefined connection set. If a different PDO has this CAN-ID by `set` or `sdo`, the finding is a warning.",
    why: "Programs and tools that know the predefined CAN-IDs do not find the PDO, and its priority changes. A CAN-ID in `set` may be a typing error.",
    example: r#"a link of TPDO 1 of node 5, and `set = { "1800:1" = 0x185 }` in node 6"#,
    remedy: "Correct the other CAN-ID, or specify one with `can-id`.",
    source: "CiA 301 §7.3.5",

    "network/fixed-pdo" = FIXED_PDO, Error;
    summary: "the PDOs of a node cannot be configured as the network requires",
    checks: "One of the remaining PDOs must be able to carry the linked entries. Its mapping, its COB-ID and the parameters that the link sets must be writable or already have the required values. An RPDO also needs as many mapping entries, and `DummyUsage` must allow data types for its gaps. The help gives the reason for each PDO. A PDO that `unused-pdos` cannot switch off is a warning.",
    why: "A device rejects writing constant parameters (SDO abort 0601 0002h).",
    example: "a node with the constant mapping 6000h:01 in TPDO 1, and a link from 6000h:02",
    remedy: "Link the entries that the PDO carries, in the order of its mapping, and remove parameters that it does not have.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "network/invalid-setting" = INVALID_SETTING, Error;
    summary: "a setting does not match the node",
    checks: "Each setting of a node must match its object dictionary, as in the check of `objdict configure`.",
    why: "The node cannot be configured with it.",
    example: r#"`"1017" = "2 minutes"`"#,
    remedy: "Correct the setting as described in the help.",
    source: "objdict, docs/guides/dcf.md",

    "network/rpdo-without-sender" = RPDO_WITHOUT_SENDER, Warning;
    summary: "an RPDO waits for a CAN-ID that no node sends",
    checks: "A node of the network must send the CAN-ID of each valid RPDO that maps something. A manager without a description sends all remaining CAN-IDs. RPDOs that are unchanged from the description's defaults are one finding per node.",
    why: "The outputs of the node never change.",
    example: "an RPDO on 18Ch in a network without node 12",
    remedy: "Correct the CAN-ID, or switch the RPDO off. In a `network.toml`, `unused-pdos = \"off\"` switches off all PDOs that no link and no key uses.",

    "network/tpdo-without-receiver" = TPDO_WITHOUT_RECEIVER, Note;
    summary: "a TPDO is sent that no node receives",
    checks: "A node of the network must receive the CAN-ID of each valid TPDO that maps something. TPDOs that are unchanged from the description's defaults are one finding per node.",
    why: "The PDO uses bus capacity without any benefit.",
    example: "TPDO 2 of a node, which is valid by default",
    remedy: "Link the entries of the TPDO, or switch it off. In a `network.toml`, `unused-pdos = \"off\"` switches off all PDOs that no link and no key uses.",
}
