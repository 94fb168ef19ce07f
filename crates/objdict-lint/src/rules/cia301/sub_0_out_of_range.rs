use crate::{demands, rule};

rule! {
    /// sub-index 0 of a communication object states an impossible highest sub-index
    ///
    /// ## What it checks
    /// Whether the value of sub-index 0 lies in the range that CiA 301 gives it: 1 to 4 for 1018h, 1 to 127 for 1010h, 1011h, 1016h and 1028h, 2 to 6 for PDO communication parameters, 3 for SDO clients. It is silent where another rule has it: sub-indexes that are missing or too many, or a highest one that is not described. What a PDO mapping states is the matter of another rule.
    ///
    /// ## Why it matters
    /// Managers read sub-index 0 before the others and stop at what it says.
    ///
    /// ## Example
    /// `[1016]` with `[1016sub0]` only, and `DefaultValue=0` there
    ///
    /// ## How to mend
    /// Describe the entries, or leave out an object that has none.
    ///
    /// ## Source
    /// CiA 301 §7.4.7.2, §7.5.2
    "cia301/sub-0-out-of-range", Warning, Against(demands::sub_0_out_of_range)
}
