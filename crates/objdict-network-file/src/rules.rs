//! The rules about the text of a network file.

use objdict_model::diagnostic::text_rules;

text_rules! {
    "network/unknown-type" = UNKNOWN_TYPE, Error;
    summary: "a node uses a type that is not in the file",
    checks: "Whether the type that a node or another type names with `use` is a table below `type`, and no type uses itself.",
    why: "The node has none of the keys of its type.",
    example: "`use = \"drvie\"` beside `[type.drive]`",
    remedy: "Correct the name, or add the type.",
    source: "objdict, docs/guides/network.md",

    "network/overridden-key" = OVERRIDDEN_KEY, Warning;
    summary: "a key of `defaults` overrides that of a node",
    checks: "Whether a node has a key with another value than `defaults` has for it.",
    why: "ros2_canopen replaces the keys of each node by those of `defaults`, so the node cannot deviate.",
    example: "`period: 10` in `defaults`, and `period: 20` in a node",
    remedy: "Move the key from `defaults` to the nodes.",
    source: "ros2_canopen, cogen",

    "network/invalid-node-list" = INVALID_NODE_LIST, Error;
    summary: "the node list cannot be read",
    checks: "Whether the text is an INI file with numbers where CiA 306-3 demands them.",
    why: "Nothing is known of the network.",
    example: "`Nodes=many`",
    remedy: "Correct the line that the message names.",
    source: "CiA 306-3",

    "network/node-count" = NODE_COUNT, Warning;
    summary: "a node list states another number of nodes than it has",
    checks: "Whether `Nodes` is the number of nodes with `NodeXPresent=1`.",
    why: "A tool that trusts the number leaves nodes out.",
    example: "`Nodes=0x03` and two nodes that are present",
    remedy: "Correct the number.",
    source: "CiA 306-3",

    "network/invalid-configuration" = INVALID_CONFIGURATION, Error;
    summary: "the manager holds a configuration that is not valid",
    checks: "Whether 1F20h in the description of the manager has DCFs, and 1F22h concise DCFs, each for a node of the network.",
    why: "The manager cannot configure the node.",
    example: "a concise DCF that states 9 downloads and has 8",
    remedy: "Write the DCF of the manager anew.",
    source: "CiA 302-3, 1F20h, 1F22h",

    "network/unreadable-node" = UNREADABLE_NODE, Error;
    summary: "the description of a node cannot be read",
    checks: "Whether the file of each node exists and is an EDS, a DCF, an XDD, an XDC or a device as JSON.",
    why: "Without it nothing is known of the node.",
    example: "`dcf: drive.eds`, which is in another folder",
    remedy: "Correct the path. It is relative to the network file, else to the working directory.",
    source: "objdict, docs/guides/network.md",
}
