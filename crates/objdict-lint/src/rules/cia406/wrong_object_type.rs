use crate::{demands, rule};

rule! {
    /// an object of an encoder is of another object type
    ///
    /// ## What it checks
    /// The object types of 6000h to 6510h. A RECORD in place of an ARRAY is a warning, for all its entries can be reached.
    ///
    /// ## Why it matters
    /// A position at sub-index 1 is not found by a master that reads 6004h, and the mapping 60040020h does not fit.
    ///
    /// ## Example
    /// `[6004]` with `ObjectType=0x8`
    ///
    /// ## How to mend
    /// Use the object type of the profile: 6004h is a VAR, what exists for each sensor or channel is an ARRAY.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/wrong-object-type", Error, Against(demands::wrong_object_type)
}
