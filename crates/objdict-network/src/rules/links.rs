//! The rules about links, settings and described managers, which `network.toml` has.

use crate::diagnostic::text_rules;

text_rules! {
    source: "CiA 301 §7.2.2";

    "network/unknown-node" = UNKNOWN_NODE, Error;
    summary: "a node is named that is not in the network",
    checks: "Whether both ends of each link begin with the name of a node that has a description, or are the name of a manager without one, and whether `watches` and `manager` name nodes.",
    why: "The link has no entries, so no PDO is configured for it; nothing is monitored; the node that is meant does not become the manager.",
    example: r#"`from = "lefft.6000:1-5"` in a network with the nodes `left` and `plc`"#,
    remedy: "Write the name of the node, or describe the node. A manager without a description is written without entries.",
    source: "objdict",

    "network/unknown-entry" = UNKNOWN_ENTRY, Error;
    summary: "a link names an entry that the node does not have",
    checks: "Whether a link names entries of each node with a description; whether the object, and each sub-index of a range, is in the description of the node, and whether a name means one object or entry.",
    why: "The node refuses to map the entry (SDO abort 0602 0000h or 0609 0011h).",
    example: r#"`from = "left.6000:1-9"` where 6000h has eight inputs"#,
    remedy: "Name entries of the description; `objdict show` lists them.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "network/link-direction" = LINK_DIRECTION, Error;
    summary: "a node cannot send or receive a linked entry",
    checks: "Whether a TPDO of the producer and an RPDO of another node can carry each entry: by `PDOMapping`, by its access, and by its data type.",
    why: "The node refuses to map the entry (SDO abort 0604 0041h).",
    example: r#"`from = "left.6200:1"`, an output with the access `rww`"#,
    remedy: "Exchange `from` and `to`, or link another entry.",
    source: "CiA 301 §7.4.7.1; CiA 306-1 §4.6.3",

    "network/link-mismatch" = LINK_MISMATCH, Error;
    summary: "the ends of a link have different numbers of entries or bits",
    checks: "Whether both ends name as many entries, and whether each entry has as many bits as the one that receives it.",
    why: "PDOs have no types: bits are received by position, so the first difference shifts all entries behind it.",
    example: r#"`from = "left.6000:1-5"`, `to = "plc.5200:1-4"`"#,
    remedy: "Name as many entries of the same length at both ends.",
    source: "CiA 301 §7.4.7.1",

    "network/link-type" = LINK_TYPE, Warning;
    summary: "linked entries have data types with different meanings",
    checks: "Whether linked entries are both signed, both unsigned or both of the same other type. Their length is the matter of `network/link-mismatch`.",
    why: "The consumer takes the bits as they are: -1 becomes 65535, and a REAL32 a meaningless integer.",
    example: "an INTEGER16 to an UNSIGNED16",
    remedy: "Link an entry of the same type, or convert the value in the consumer.",
    source: "CiA 301 §7.1.4",

    "network/link-too-long" = LINK_TOO_LONG, Error;
    summary: "the entries of a link with a CAN-ID need more than one PDO",
    checks: "Whether the linked entries for which a CAN-ID is given have at most 64 bits, and one consumer if a manager without a description sends them.",
    why: "A CAN-ID has one sender and one layout. Without a CAN-ID, the entries are divided.",
    example: r#"`from = "left.6000:1-9"` with `can-id = 0x18B`"#,
    remedy: "Leave the CAN-ID out, or divide the link into several ones.",

    "network/two-producers" = TWO_PRODUCERS, Error;
    summary: "two links write one entry",
    checks: "Whether each entry of a consumer receives one entry of one producer. The same link twice is a warning.",
    why: "The entry has the value of the PDO that came last.",
    example: r#"`from = "left.6000:1"` and `from = "right.6000:1"`, both with `to = "plc.5200:1"`"#,
    remedy: "Link each producer to an entry of its own.",

    "network/no-free-pdo" = NO_FREE_PDO, Error;
    summary: "a node has no PDO left for a link",
    checks: "Whether the producer has a TPDO, and each consumer an RPDO, that neither another link uses nor the network file configures itself.",
    why: "The entries are not sent or not received.",
    example: "links from five nodes to a node with four RPDOs",
    remedy: "Link fewer entries, or entries that fit into PDOs together: links with the same nodes and the same parameters share PDOs.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "network/moved-can-id" = MOVED_CAN_ID, Note;
    summary: "a PDO leaves its predefined CAN-ID",
    checks: "Whether the PDO of each link without a `can-id` keeps its CAN-ID of the predefined connection set. Another PDO that has it by `set` or `sdo` is a warning.",
    why: "Programs and tools that know the predefined CAN-IDs do not find the PDO, and its priority changes. A CAN-ID in `set` may be a typing error.",
    example: r#"a link of TPDO 1 of node 5, and `set = { "1800:1" = 0x185 }` in node 6"#,
    remedy: "Correct the other CAN-ID, or state one with `can-id`.",
    source: "CiA 301 §7.3.5",

    "network/fixed-pdo" = FIXED_PDO, Error;
    summary: "the PDOs of a node cannot be configured as the network needs it",
    checks: "Whether one of the PDOs that are left can carry the linked entries: its mapping, its COB-ID and the parameters that the link sets can be written or are as needed already. An RPDO also needs as many mapping entries, and data types for the gaps that `DummyUsage` allows. The help says what is against each PDO. A PDO that `unused-pdos` cannot switch off is a warning.",
    why: "A device refuses to write constant parameters (SDO abort 0601 0002h).",
    example: "a node with the constant mapping 6000h:01 in TPDO 1, and a link from 6000h:02",
    remedy: "Link the entries that the PDO carries, in the order of its mapping, and remove parameters that it does not have.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "network/invalid-setting" = INVALID_SETTING, Error;
    summary: "a setting does not fit the node",
    checks: "Whether each setting of a node fits its dictionary, as `objdict configure` checks it.",
    why: "The node cannot be configured with it.",
    example: r#"`"1017" = "2 minutes"`"#,
    remedy: "Correct the setting as the help says.",
    source: "objdict, docs/guides/dcf.md",

    "network/rpdo-without-sender" = RPDO_WITHOUT_SENDER, Warning;
    summary: "no node sends what another one receives",
    checks: "Whether the CAN-ID of each valid RPDO that maps something is sent by a node of the network. A manager without a description sends all that remains. RPDOs that are as the description has them by default are one finding for each node.",
    why: "The outputs of the node never change.",
    example: "an RPDO on 18Ch in a network without node 12",
    remedy: "Correct the CAN-ID, or switch the RPDO off. `unused-pdos = \"off\"` of a `network.toml` switches off all PDOs that no link and no key uses.",

    "network/tpdo-without-receiver" = TPDO_WITHOUT_RECEIVER, Note;
    summary: "no node receives what another one sends",
    checks: "Whether the CAN-ID of each valid TPDO that maps something is received by a node of the network. TPDOs that are as the description has them by default are one finding for each node.",
    why: "The PDO takes a part of the bus for nothing.",
    example: "TPDO 2 of a node, which is valid by default",
    remedy: "Link the entries of the TPDO, or switch it off. `unused-pdos = \"off\"` of a `network.toml` switches off all PDOs that no link and no key uses.",
}
