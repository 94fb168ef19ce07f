//! What profiles that were loaded demand: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{
    misplaced_object, missing_entry, missing_object, undefined_sub_index, wrong_access, wrong_data_type,
    wrong_default, wrong_mapping, wrong_object_type, wrong_value,
};
use crate::rule::demands;

demands! {
    /// an object that a house profile has for other devices only
    ///
    /// ## What it checks
    /// Whether the condition holds that a loaded profile states with `only`.
    ///
    /// ## Why it matters
    /// The object means nothing in this device, or the device says something wrong of itself.
    ///
    /// ## Example
    /// `only = "if 1000h[16]"` in the profile, and a device whose device type has not that bit
    ///
    /// ## How to mend
    /// Leave the object out, or correct what the device says of itself.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/misplaced-object", Warning, Against(misplaced_object);

    /// an object that a house profile demands is missing
    ///
    /// ## What it checks
    /// Whether the device has the objects that a profile loaded with `--profile` or `profiles` in `objdict.toml` makes mandatory, always or under a condition that holds for the device. What a module may bring is not missed.
    ///
    /// ## Why it matters
    /// The software of the house counts on the object.
    ///
    /// ## Example
    /// `need = "mandatory"` in the profile, and no `[2000]` in the description
    ///
    /// ## How to mend
    /// Describe the object, and build it into the device; or correct the condition in the profile.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/missing-object", Error, Applied(missing_object);

    /// a sub-index that a house profile demands is missing
    ///
    /// ## What it checks
    /// Whether the objects of the device have the sub-indexes that a loaded profile makes mandatory, always or under a condition that holds for the device.
    ///
    /// ## Why it matters
    /// The software of the house counts on the sub-index.
    ///
    /// ## Example
    /// `{ sub = 3, need = "mandatory" }` in the profile, and no `[2000sub3]`
    ///
    /// ## How to mend
    /// Describe the sub-index, and build it into the device.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/missing-sub-index", Error, Against(missing_entry);

    /// an object has a sub-index that a house profile does not define
    ///
    /// ## What it checks
    /// Whether each sub-index of an object is one that the loaded profile lists. A profile that lists none leaves them free.
    ///
    /// ## Why it matters
    /// Tools of the house do not show it, and a later edition of the profile may give it another meaning.
    ///
    /// ## Example
    /// `[2000sub3]` where the profile ends with sub-index 2
    ///
    /// ## How to mend
    /// Put it into an object of its own, or into the profile.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/undefined-sub-index", Error, Against(undefined_sub_index);

    /// an entry has an access type that a house profile does not allow
    ///
    /// ## What it checks
    /// The access types of the entries that a loaded profile defines. `ro` and `const` stand for each other; `rwr` and `rww` count as `rw`.
    ///
    /// ## Why it matters
    /// What writes the entry is refused, or a constant can be changed.
    ///
    /// ## Example
    /// `AccessType=ro` where the profile says `rw`
    ///
    /// ## How to mend
    /// Use the access type of the profile, in the description and in the device.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-access", Error, Expected(wrong_access), fix Unsafe;

    /// an entry has another data type than a house profile gives it
    ///
    /// ## What it checks
    /// The data types of the entries that a loaded profile defines.
    ///
    /// ## Why it matters
    /// What writes the entry with the length of the profile is refused.
    ///
    /// ## Example
    /// `DataType=0x0005` where the profile says `UNSIGNED16`
    ///
    /// ## How to mend
    /// Use the data type of the profile, in the description and in the device.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;

    /// an entry has another default than a house profile gives it
    ///
    /// ## What it checks
    /// Whether the default of an entry is that of a loaded profile.
    ///
    /// ## Why it matters
    /// A node that nobody configured behaves in another way than the others.
    ///
    /// ## Example
    /// `DefaultValue=100` where the profile says `default = 50`
    ///
    /// ## How to mend
    /// Use the default of the profile, in the description and in the device.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-default", Warning, Expected(wrong_default), fix Unsafe;

    /// an entry that a house profile lets no PDO carry is marked as mappable
    ///
    /// ## What it checks
    /// Whether `PDOMapping` is set at an entry that a loaded profile gives `mapping = "no"`.
    ///
    /// ## Why it matters
    /// A configuration tool offers it for a PDO, and the device refuses the mapping.
    ///
    /// ## Example
    /// `PDOMapping=1` where the profile says `mapping = "no"`
    ///
    /// ## How to mend
    /// Write `PDOMapping=0`.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;

    /// an object has another object type than a house profile gives it
    ///
    /// ## What it checks
    /// The object types of the objects that a loaded profile defines. Where it accepts several, the first is the right one and the others are a warning.
    ///
    /// ## Why it matters
    /// A tool that knows the profile does not find the sub-indexes.
    ///
    /// ## Example
    /// `ObjectType=0x8` where the profile says `RECORD`
    ///
    /// ## How to mend
    /// Use the object type of the profile.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-object-type", Error, Against(wrong_object_type);

    /// an entry has a value that a house profile does not allow
    ///
    /// ## What it checks
    /// Whether the value of an entry, configured or default, is one of those that a loaded profile allows.
    ///
    /// ## Why it matters
    /// The device refuses the value, or does what nobody expects.
    ///
    /// ## Example
    /// `DefaultValue=300` where the profile says `values = [[0, 200]]`
    ///
    /// ## How to mend
    /// Use a value of the profile.
    ///
    /// ## Source
    /// the profile that was loaded
    "house/wrong-value", Error, Expected(wrong_value);
}
