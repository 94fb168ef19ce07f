//! The rules about files that people write as keys and values.

use objdict_model::diagnostic::text_rules;

text_rules! {
    source: "dcf-tools 2.4.2; objdict, docs/guides/network.md";

    "keys/invalid-toml" = INVALID_TOML, Error;
    summary: "the file is not valid TOML",
    checks: "The text must be valid TOML. Otherwise nothing else in it is checked.",
    why: "The content of the file is unknown.",
    example: "`file = left.eds` without quotes",
    remedy: "Correct the reported line.",
    source: "TOML 1.0",

    "network/invalid-yaml" = INVALID_YAML, Error;
    summary: "the network file is not valid YAML",
    checks: "The text must be valid YAML and a single document. Otherwise nothing else in it is checked.",
    why: "dcfgen and the launch files of ROS also reject the file, with a parser message.",
    example: "`dcf_path: @BUS_CONFIG_PATH@`: a text that begins with `@` must be quoted",
    remedy: "Correct the reported line.",
    source: "YAML 1.1",

    "keys/key-defined-twice" = DUPLICATE_KEY, Error;
    summary: "a key is defined twice",
    checks: "Reports a key that occurs more than once in a table: a node, a PDO, an object or a setting.",
    why: "It is unclear which of the two is meant. dcfgen silently uses the last one, so a node that was copied and not renamed is lost.",
    example: "two nodes that are both called `drive_1`",
    remedy: "Remove one of the two, or give it a different name.",
    source: "TOML 1.0; YAML 1.1 §3.2.1.3",

    "keys/unknown-key" = UNKNOWN_KEY, Error;
    summary: "a key is unknown",
    checks: "Reports a key that objdict does not know in this place. In a `bus.yml`, these are keys that neither dcfgen nor the launch files of ROS know. Other programs may have keys in a `bus.yml`, so an unknown key there is a warning. It is an error if it differs in one or two letters from one that dcfgen reads.",
    why: "The key is misspelled or in the wrong table. Without an error its setting would be lost; dcfgen ignores it, so the node keeps its default.",
    example: "`heartbeat_produce: 500`",
    remedy: "Correct the name or remove the key.",

    "keys/former-key" = FORMER_KEY, Warning;
    summary: "a key occurs under its current and its former name",
    checks: "A parameter that had a different name in an earlier version may occur only once in a table: `event-timer` and `event` in a `device.toml`, `transmission` and `type` in a `network.toml`. The former name by itself is not a finding; the JSON Schemas mark it as deprecated.",
    why: "One of the two values is not used: the first one.",
    example: "`tpdo.1 = { type = \"sync/1\", transmission = \"event\" }`",
    remedy: "Remove one of the two.",
    source: "objdict, docs/reference/device.md and docs/guides/network.md",

    "keys/wrong-type" = WRONG_TYPE, Error,
        explains Around ["missing-key"];
    summary: "a value has the wrong type",
    checks: "Each value must be a number, a string, true or false, a list or a table, as its key requires. A decimal number in quotes is a warning. In a `bus.yml`, so is a number with a fraction instead of a whole number, because dcfgen cuts off the fraction.",
    why: "The value cannot be used. dcfgen stops with a traceback or uses a different value: a quoted `\"false\"` is true.",
    example: "`cob_id: \"0x205\"`, `mandatory: \"no\"`",
    remedy: "Write the value as described in the message.",

    "keys/out-of-range" = OUT_OF_RANGE, Error;
    summary: "a number is out of range",
    checks: "Each number must be in range for the object that stores it.",
    why: "The object cannot hold the value. dcfgen stops with a traceback or writes a value that the manager does not load.",
    example: "`node_id: 200`, `sync_period: -1`",
    remedy: "Write a number in the range that the message states.",
    source: "CiA 301; CiA 302-2",

    "keys/missing-key" = MISSING_KEY, Error;
    summary: "a required key is missing",
    checks: "Each table must have its mandatory keys: a network its manager, a node the file with its description.",
    why: "Nothing can be built without it.",
    example: "a node without `dcf`",
    remedy: "Add the key.",

    "keys/unknown-profile" = UNKNOWN_PROFILE, Error,
        explains File ["missing-mandatory-object", "missing-section", "missing-key"];
    summary: "objdict does not have the profile of a device",
    checks: "The `profile` of a `device.toml` must be a profile that objdict can start devices with. objdict must also have this version of its data.",
    why: "All objects of the profile are missing, including the mandatory ones of CiA 301.",
    example: "`profile = \"401@2\"`",
    remedy: "Write a profile that `objdict new --help` lists, with the version that the message names.",
    source: "objdict, docs/reference/device.md",

    "keys/shared-product-code" = SHARED_PRODUCT_CODE, Warning;
    summary: "two variants have the same product code",
    checks: "Each variant of a `device.toml` needs a product code of its own: `product-number` in its table `device`, or the default of 1018h:02.",
    why: "A manager identifies a device by vendor-ID and product code (1F85h, 1F86h). If two variants share a product code, it mistakes one for the other and configures missing entries.",
    example: "`[variant.io8]` without `device.product-number`",
    remedy: "Give each variant a `device.product-number` of its own.",
    source: "CiA 301 §7.5.2.19; CiA 302-2; objdict, docs/reference/device.md",
}
