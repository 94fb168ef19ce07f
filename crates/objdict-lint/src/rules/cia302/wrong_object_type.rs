use crate::{demands, rule};

rule! {
    /// an object of CiA 302 is of another object type
    ///
    /// ## What it checks
    /// The object types of 1F00h to 1F91h. A RECORD in place of an ARRAY is a warning, for all its entries can be reached.
    ///
    /// ## Why it matters
    /// A VAR has no entry for a node, so the manager finds nothing there.
    ///
    /// ## Example
    /// `[1F22]` with `ObjectType=0x7`
    ///
    /// ## How to mend
    /// Use the object type of the document; a list of nodes is an ARRAY.
    ///
    /// ## Source
    /// CiA 302-2, the object descriptions
    "cia302/wrong-object-type", Error, Against(demands::wrong_object_type)
}
