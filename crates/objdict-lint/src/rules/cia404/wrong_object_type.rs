use crate::{demands, rule};

rule! {
    /// an object of a measuring device has another object type than CiA 404 gives it
    ///
    /// ## What it checks
    /// The object types of the objects that CiA 404 defines. A RECORD in the place of an ARRAY is a warning: its channels are found by the same sub-indexes.
    ///
    /// ## Why it matters
    /// A VAR in the place of an ARRAY has its value at another sub-index than a master asks for.
    ///
    /// ## Example
    /// `ObjectType=0x7` in `[7130]`
    ///
    /// ## How to mend
    /// Make it an ARRAY with a sub-index for each channel, also where there is one channel only.
    ///
    /// ## Source
    /// CiA 404-1, the object descriptions
    "cia404/wrong-object-type", Error, Against(demands::wrong_object_type)
}
