//! The rules about files that people write as keys and values.

use objdict_model::diagnostic::text_rules;

text_rules! {
    source: "dcf-tools 2.4.2; objdict, docs/guides/network.md";

    "keys/invalid-toml" = INVALID_TOML, Error;
    summary: "the file is not valid TOML",
    checks: "Whether the text can be read as TOML. If it cannot, nothing else of it is checked.",
    why: "Nothing of what the file describes is known.",
    example: "`file = left.eds` without quotes",
    remedy: "Correct the reported line.",
    source: "TOML 1.0",

    "network/invalid-yaml" = INVALID_YAML, Error;
    summary: "the network file is not valid YAML",
    checks: "Whether the text can be read as YAML and is one document. If not, nothing else of it is checked.",
    why: "dcfgen and the launch files of ROS refuse the file too, with a message about the parser.",
    example: "`dcf_path: @BUS_CONFIG_PATH@`: a text that begins with `@` must be quoted",
    remedy: "Correct the reported line.",
    source: "YAML 1.1",

    "keys/key-defined-twice" = DUPLICATE_KEY, Error;
    summary: "a key is defined twice",
    checks: "Whether a key is there more than once in a table: a node, a PDO, an object or a setting.",
    why: "It is unclear which of the two is meant. dcfgen takes the last one without a word, so a node that was copied and not renamed is lost.",
    example: "two nodes that are both called `drive_1`",
    remedy: "Remove one of the two, or give it another name.",
    source: "TOML 1.0; YAML 1.1 §3.2.1.3",

    "keys/unknown-key" = UNKNOWN_KEY, Error;
    summary: "an unknown key",
    checks: "Whether each key is one that objdict reads there: in a `bus.yml`, one that dcfgen or the launch files of ROS know. Other programs may have keys in a `bus.yml`, so there an unknown key is a warning, unless it differs in one or two letters from one that dcfgen reads.",
    why: "The key is misspelled or in the wrong table. Without an error its setting would be lost; dcfgen passes over it, so the node keeps its default.",
    example: "`heartbeat_produce: 500`",
    remedy: "Correct the name or remove the key.",

    "keys/former-key" = FORMER_KEY, Warning;
    summary: "a key under its present and its former name",
    checks: "Whether a table has a parameter only once where it had another name in an earlier version: `event-timer` and `event` in a `device.toml`, `transmission` and `type` in a `network.toml`. The former name alone is not a finding; the JSON Schemas mark it as deprecated.",
    why: "One of the two values is not used: the first one.",
    example: "`tpdo.1 = { type = \"sync/1\", transmission = \"event\" }`",
    remedy: "Remove one of the two.",
    source: "objdict, docs/reference/device.md and docs/guides/network.md",

    "keys/wrong-type" = WRONG_TYPE, Error,
        explains Around ["missing-key"];
    summary: "a value of the wrong type",
    checks: "Whether each value is a number, a text, true or false, a list or a table as its key demands. A decimal number in quotes is a warning; so is, in a `bus.yml`, a number with a fraction where a whole one belongs, because dcfgen cuts off the fraction.",
    why: "The value cannot be used. dcfgen stops with a traceback, or takes something else: a quoted `\"false\"` is true.",
    example: "`cob_id: \"0x205\"`, `mandatory: \"no\"`",
    remedy: "Write the value as the message says.",

    "keys/out-of-range" = OUT_OF_RANGE, Error;
    summary: "a number out of its range",
    checks: "Whether each number fits the object of the dictionary that it goes into.",
    why: "The object cannot hold the value. dcfgen stops with a traceback, or writes a value that the manager does not load.",
    example: "`node_id: 200`, `sync_period: -1`",
    remedy: "Write a number in the range that the message states.",
    source: "CiA 301; CiA 302-2",

    "keys/missing-key" = MISSING_KEY, Error;
    summary: "a required key is missing",
    checks: "Whether each table has the keys that it cannot do without: a network its manager, a node the file with its description.",
    why: "Nothing can be built without it.",
    example: "a node without `dcf`",
    remedy: "Add the key.",

    "keys/unknown-profile" = UNKNOWN_PROFILE, Error,
        explains File ["missing-mandatory-object", "missing-section", "missing-key"];
    summary: "a device of a profile that objdict does not have",
    checks: "Whether the `profile` of a `device.toml` is one of the profiles with which devices can be started, in a version of its data that objdict has.",
    why: "All objects that the profile brings are missing, the mandatory ones of CiA 301 too.",
    example: "`profile = \"401@2\"`",
    remedy: "Write a profile that `objdict new --help` lists, with the version that the message names.",
    source: "objdict, docs/reference/device.md",

    "keys/shared-product-code" = SHARED_PRODUCT_CODE, Warning;
    summary: "two variants with one product code",
    checks: "Whether each variant of a `device.toml` has a product code of its own: `product-number` in its table `device`, or the default of 1018h:02.",
    why: "A manager knows a device by vendor-ID and product code (1F85h, 1F86h). With one product code it takes one variant for the other and configures entries that are not there.",
    example: "`[variant.io8]` without `device.product-number`",
    remedy: "Give each variant a `device.product-number` of its own.",
    source: "CiA 301 §7.5.2.19; CiA 302-2; objdict, docs/reference/device.md",
}
