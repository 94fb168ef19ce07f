use crate::{demands, rule};

rule! {
    /// a communication object has a sub-index that CiA 301 does not define
    ///
    /// ## What it checks
    /// Whether each sub-index of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists is one that the standard defines. FFh, which describes the object itself, may always be there.
    ///
    /// ## Why it matters
    /// The meaning of these objects belongs to CiA; a later edition may give the sub-index another one. Tools that know the object do not show it.
    ///
    /// ## Example
    /// `[1018sub5]`
    ///
    /// ## How to mend
    /// Put what is your own into 2000h to 5FFFh.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/undefined-sub-index", Error, Against(demands::undefined_sub_index)
}
