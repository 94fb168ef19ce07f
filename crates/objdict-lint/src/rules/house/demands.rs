//! What profiles that were loaded demand: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{
    misplaced_object, missing_entry, missing_object, undefined_sub_index, wrong_access, wrong_data_type,
    wrong_default, wrong_mapping, wrong_object_type, wrong_value,
};
use crate::rule::demands;

demands! {
    "house/misplaced-object", Warning, Against(misplaced_object);
    summary: "an object that a house profile has for other devices only",
    checks: "Whether the condition holds that a loaded profile states with `only`.",
    why: "The object means nothing in this device, or the device says something wrong of itself.",
    example: r#"`only = "if 1000h[16]"` in the profile, and a device whose device type has not that bit"#,
    remedy: "Leave the object out, or correct what the device says of itself.",
    source: "the profile that was loaded",

    "house/missing-object", Error, Applied(missing_object);
    summary: "an object that a house profile demands is missing",
    checks: "Whether the device has the objects that a profile loaded with `--profile` or `profiles` in `objdict.toml` makes mandatory, always or under a condition that holds for the device. What a module may bring is not missed.",
    why: "The software of the house counts on the object.",
    example: r#"`need = "mandatory"` in the profile, and no `[2000]` in the description"#,
    remedy: "Describe the object, and build it into the device; or correct the condition in the profile.",
    source: "the profile that was loaded",

    "house/missing-sub-index", Error, Against(missing_entry);
    summary: "a sub-index that a house profile demands is missing",
    checks: "Whether the objects of the device have the sub-indexes that a loaded profile makes mandatory, always or under a condition that holds for the device.",
    why: "The software of the house counts on the sub-index.",
    example: r#"`{ sub = 3, need = "mandatory" }` in the profile, and no `[2000sub3]`"#,
    remedy: "Describe the sub-index, and build it into the device.",
    source: "the profile that was loaded",

    "house/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object has a sub-index that a house profile does not define",
    checks: "Whether each sub-index of an object is one that the loaded profile lists. A profile that lists none leaves them free.",
    why: "Tools of the house do not show it, and a later edition of the profile may give it another meaning.",
    example: "`[2000sub3]` where the profile ends with sub-index 2",
    remedy: "Put it into an object of its own, or into the profile.",
    source: "the profile that was loaded",

    "house/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "an entry has an access type that a house profile does not allow",
    checks: "The access types of the entries that a loaded profile defines. `ro` and `const` stand for each other; `rwr` and `rww` count as `rw`.",
    why: "What writes the entry is refused, or a constant can be changed.",
    example: "`AccessType=ro` where the profile says `rw`",
    remedy: "Use the access type of the profile, in the description and in the device.",
    source: "the profile that was loaded",

    "house/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "an entry has another data type than a house profile gives it",
    checks: "The data types of the entries that a loaded profile defines.",
    why: "What writes the entry with the length of the profile is refused.",
    example: "`DataType=0x0005` where the profile says `UNSIGNED16`",
    remedy: "Use the data type of the profile, in the description and in the device.",
    source: "the profile that was loaded",

    "house/wrong-default", Warning, Expected(wrong_default), fix Unsafe;
    summary: "an entry has another default than a house profile gives it",
    checks: "Whether the default of an entry is that of a loaded profile.",
    why: "A node that nobody configured behaves in another way than the others.",
    example: "`DefaultValue=100` where the profile says `default = 50`",
    remedy: "Use the default of the profile, in the description and in the device.",
    source: "the profile that was loaded",

    "house/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "an entry that a house profile lets no PDO carry is marked as mappable",
    checks: r#"Whether `PDOMapping` is set at an entry that a loaded profile gives `mapping = "no"`."#,
    why: "A configuration tool offers it for a PDO, and the device refuses the mapping.",
    example: r#"`PDOMapping=1` where the profile says `mapping = "no"`"#,
    remedy: "Write `PDOMapping=0`.",
    source: "the profile that was loaded",

    "house/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object has another object type than a house profile gives it",
    checks: "The object types of the objects that a loaded profile defines. Where it accepts several, the first is the right one and the others are a warning.",
    why: "A tool that knows the profile does not find the sub-indexes.",
    example: "`ObjectType=0x8` where the profile says `RECORD`",
    remedy: "Use the object type of the profile.",
    source: "the profile that was loaded",

    "house/wrong-value", Error, Expected(wrong_value);
    summary: "an entry has a value that a house profile does not allow",
    checks: "Whether the value of an entry, configured or default, is one of those that a loaded profile allows.",
    why: "The device refuses the value, or does what nobody expects.",
    example: "`DefaultValue=300` where the profile says `values = [[0, 200]]`",
    remedy: "Use a value of the profile.",
    source: "the profile that was loaded",
}
