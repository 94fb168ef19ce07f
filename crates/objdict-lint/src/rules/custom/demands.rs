//! The requirements of custom profiles: one row per rule that uses a check of [`crate::demands`].

use crate::demands::{
    misplaced_object, missing_entry, missing_object, undefined_sub_index, wrong_access, wrong_data_type,
    wrong_default, wrong_mapping, wrong_object_type, wrong_value,
};
use crate::rule::rules;

rules! {
    source: "the loaded profile";

    "custom/misplaced-object", Warning, Against(misplaced_object);
    summary: "a custom profile defines the object for other devices only",
    checks: "If a loaded profile restricts an object with `only`, the condition in `only` must be true.",
    why: "The object is meaningless in this device, or the description of the device is wrong.",
    example: r#"`only = "if 1000h[16]"` in the profile, and a device type with bit 16 clear"#,
    remedy: "Remove the object, or correct the values that the condition depends on.",

    "custom/missing-object", Error, Demand(missing_object);
    summary: "an object that a custom profile requires is missing",
    checks: "The device must have the objects that a profile loaded with `--profile` or `profiles` in `objdict.toml` makes mandatory, always or under a condition that holds for the device. Objects that a module of a modular device may add are not reported.",
    why: "Project software relies on the object.",
    example: r#"`need = "mandatory"` in the profile, and no `[2000]` in the description"#,
    remedy: "Describe the object and implement it in the device, or correct the condition in the profile.",

    "custom/missing-sub-index", Error, Against(missing_entry);
    summary: "a sub-index that a custom profile requires is missing",
    checks: "The objects of the device must have the sub-indexes that a loaded profile makes mandatory, always or under a condition that holds for the device.",
    why: "Project software relies on the sub-index.",
    example: r#"`{ sub = 3, need = "mandatory" }` in the profile, and no `[2000sub3]`"#,
    remedy: "Describe the sub-index and implement it in the device.",

    "custom/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object has a sub-index that a custom profile does not define",
    checks: "Reports sub-indexes that a loaded profile does not list. If the profile lists none for an object, any sub-index is allowed.",
    why: "Project tools do not show the sub-index. A later edition of the profile may define it differently.",
    example: "`[2000sub3]` where the profile ends with sub-index 2",
    remedy: "Move it to a separate object, or add it to the profile.",

    "custom/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "an entry has an access type that a custom profile does not allow",
    checks: "The rule compares access types with a loaded profile for the entries that it defines. `ro` and `const` are equivalent; `rwr` and `rww` are treated as `rw`.",
    why: "The device rejects a write that the profile allows, or a constant can be changed.",
    example: "`AccessType=ro` where the profile has `rw`",
    remedy: "Use the access type of the profile, in the description and in the device.",

    "custom/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "the data type of an entry differs from a custom profile",
    checks: "The rule compares data types with a loaded profile for the entries that it defines.",
    why: "The device rejects a write with the length of the profile.",
    example: "`DataType=0x0005` where the profile has `UNSIGNED16`",
    remedy: "Use the data type of the profile, in the description and in the device.",

    "custom/wrong-default", Warning, Expected(wrong_default), fix Unsafe;
    summary: "the default of an entry differs from a custom profile",
    checks: "The default of an entry must equal the default in a loaded profile.",
    why: "An unconfigured node behaves differently from the others.",
    example: "`DefaultValue=100` where the profile has `default = 50`",
    remedy: "Use the default of the profile, in the description and in the device.",

    "custom/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "an entry is marked as mappable, although a custom profile keeps it out of PDOs",
    checks: r#"Reports `PDOMapping` set for an entry with `mapping = "no"` in a loaded profile."#,
    why: "A configuration tool offers the entry for a PDO, and the device rejects the mapping.",
    example: r#"`PDOMapping=1` where the profile has `mapping = "no"`"#,
    remedy: "Write `PDOMapping=0`.",

    "custom/wrong-object-type", Error, Against(wrong_object_type);
    summary: "the object type of an object differs from a custom profile",
    checks: "The rule compares object types with a loaded profile for the objects that it defines. If the profile accepts several, any but the first is a warning.",
    why: "A tool that knows the profile does not find the sub-indexes.",
    example: "`ObjectType=0x8` where the profile has `RECORD`",
    remedy: "Use the object type of the profile.",

    "custom/wrong-value", Error, Expected(wrong_value);
    summary: "an entry has a value that a custom profile does not allow",
    checks: "Reports configured or default values that a loaded profile does not allow.",
    why: "The device rejects the value, or the behaviour of the device is undefined.",
    example: "`DefaultValue=300` where the profile has `values = [[0, 200]]`",
    remedy: "Use a value of the profile.",
}
