use crate::{demands, rule};

rule! {
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
    "house/wrong-access", Error, Expected(demands::wrong_access), fix Unsafe
}
