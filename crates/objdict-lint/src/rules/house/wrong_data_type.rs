use crate::{demands, rule};

rule! {
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
    "house/wrong-data-type", Error, Expected(demands::wrong_data_type), fix Unsafe
}
