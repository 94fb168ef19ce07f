use crate::{demands, rule};

rule! {
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
    "house/misplaced-object", Warning, Against(demands::misplaced_object)
}
