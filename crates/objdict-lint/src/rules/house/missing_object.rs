use crate::{demands, rule};

rule! {
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
    "house/missing-object", Error, Applied(demands::missing_object)
}
