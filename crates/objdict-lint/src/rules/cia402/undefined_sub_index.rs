use crate::{demands, rule};

rule! {
    /// an object of a drive has a sub-index that CiA 402 does not define
    ///
    /// ## What it checks
    /// Whether the objects that CiA 402 defines have only its sub-indexes. Parameter sets that it leaves to the manufacturer (60F6h, 60F7h, 60F9h, 60FBh, 6410h, 6510h) may have any.
    ///
    /// ## Why it matters
    /// A later version may give the sub-index a meaning, and a master that counts on sub-index 0 reads one value too many.
    ///
    /// ## Example
    /// `[607Dsub3]`
    ///
    /// ## How to mend
    /// Put what is your own into an object from 2000h on.
    ///
    /// ## Source
    /// CiA 402-2, IEC 61800-7-201 §7 to §16
    "cia402/undefined-sub-index", Warning, Against(demands::undefined_sub_index)
}
