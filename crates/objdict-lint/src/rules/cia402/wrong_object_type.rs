use crate::{demands, rule};

rule! {
    /// an object of a drive has another object type than CiA 402 gives it
    ///
    /// ## What it checks
    /// The object types of the objects that CiA 402 defines. A RECORD in the place of an ARRAY, which many drives have for pairs such as 6099h, is a warning: it is found by the same sub-indexes.
    ///
    /// ## Why it matters
    /// A VAR in the place of an ARRAY has its value at another sub-index than a master asks for.
    ///
    /// ## Example
    /// `ObjectType=0x7` in `[607D]`
    ///
    /// ## How to mend
    /// Give the object the type that CiA 402 says.
    ///
    /// ## Source
    /// CiA 402-2, IEC 61800-7-201 §7 to §16
    "cia402/wrong-object-type", Error, Against(demands::wrong_object_type)
}
