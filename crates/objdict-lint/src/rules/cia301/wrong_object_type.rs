use crate::{demands, rule};

rule! {
    /// a communication object has another object type than CiA 301 gives it
    ///
    /// ## What it checks
    /// The object types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists. An ARRAY where CiA 301 has a RECORD of alike members, or the reverse, is a warning: the sub-indexes are the same, and devices of well-known makers have an identity object of object type ARRAY.
    ///
    /// ## Why it matters
    /// A tool that knows the object takes the sub-indexes of the standard for granted and does not find them.
    ///
    /// ## Example
    /// `[1017]` with `ObjectType=0x9`
    ///
    /// ## How to mend
    /// Use the object type of the standard.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/wrong-object-type", Error, Against(demands::wrong_object_type)
}
