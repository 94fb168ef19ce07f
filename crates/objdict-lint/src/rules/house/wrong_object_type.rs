use crate::{demands, rule};

rule! {
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
    "house/wrong-object-type", Error, Against(demands::wrong_object_type)
}
