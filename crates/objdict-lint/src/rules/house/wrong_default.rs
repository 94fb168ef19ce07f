use crate::{demands, rule};

rule! {
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
    "house/wrong-default", Warning, Expected(demands::wrong_default), fix Unsafe
}
