//! The rules about the text of a network file.

use objdict_model::diagnostic::text_rules;

text_rules! {
    "network/unknown-type" = UNKNOWN_TYPE, Error;
    summary: "a node uses a type that is not in the file",
    checks: "The type that a node or a different type names with `use` must be a table below `type`. No type may use itself.",
    why: "The node has none of the keys of its type.",
    example: "`use = \"drvie\"` beside `[type.drive]`",
    remedy: "Correct the name, or add the type.",
    source: "objdict, docs/guides/network.md",

    "network/overridden-key" = OVERRIDDEN_KEY, Warning;
    summary: "a key of `defaults` overrides a node's key",
    checks: "Reports a key of a node whose value differs from the same key in `defaults`.",
    why: "ros2_canopen replaces the keys of each node with the keys of `defaults`, so the node cannot deviate.",
    example: "`period: 10` in `defaults`, and `period: 20` in a node",
    remedy: "Move the key from `defaults` to the nodes.",
    source: "ros2_canopen, cogen",

    "network/invalid-node-list" = INVALID_NODE_LIST, Error;
    summary: "the node list cannot be read",
    checks: "The text must be an INI file with numbers where CiA 306-3 requires them.",
    why: "The network cannot be read at all.",
    example: "`Nodes=many`",
    remedy: "Correct the line that the message names.",
    source: "CiA 306-3",

    "network/node-count" = NODE_COUNT, Warning;
    summary: "the number of nodes in a node list is wrong",
    checks: "`Nodes` must be the number of nodes with `NodeXPresent=1`.",
    why: "A tool that trusts the number omits nodes.",
    example: "`Nodes=0x03` and two nodes that are present",
    remedy: "Correct the number.",
    source: "CiA 306-3",

    "network/invalid-configuration" = INVALID_CONFIGURATION, Error;
    summary: "the manager holds a configuration that is not valid",
    checks: "In the manager's description, 1F20h must contain DCFs and 1F22h concise DCFs, each for a node of the network.",
    why: "The manager cannot configure the node.",
    example: "a concise DCF that states 9 downloads and has 8",
    remedy: "Write the manager's DCF again.",
    source: "CiA 302-3, 1F20h, 1F22h",

    "network/unreadable-node" = UNREADABLE_NODE, Error;
    summary: "the description of a node cannot be read",
    checks: "The file of each node must exist and be an EDS, a DCF, an XDD, an XDC or a device as JSON.",
    why: "Without it, the node's objects are unknown.",
    example: "`dcf: drive.eds`, which is in another folder",
    remedy: "Correct the path. It is relative to the network file, otherwise to the working directory.",
    source: "objdict, docs/guides/network.md",
}
