use crate::{demands, rule};

rule! {
    /// an object of an I/O module is of another object type
    ///
    /// ## What it checks
    /// The object types of 6000h to 6450h: nearly all are ARRAYs, 6005h and 6423h are VARs. A RECORD in place of an ARRAY is a warning, for all its entries can be reached; makers with a name for each channel have that in every third file.
    ///
    /// ## Why it matters
    /// A VAR has no sub-index 1, so a master that reads the first channel is answered with an abort.
    ///
    /// ## Example
    /// `[6000]` with `ObjectType=0x7`
    ///
    /// ## How to mend
    /// Use the object type of the profile; a single channel is an ARRAY with one element.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/wrong-object-type", Error, Against(demands::wrong_object_type)
}
