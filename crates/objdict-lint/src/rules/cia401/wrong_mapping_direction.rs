use crate::{demands, rule};

rule! {
    /// a PDO carries outputs to the network, or inputs from it
    ///
    /// ## What it checks
    /// Whether RPDOs carry no inputs (6000h to 6127h, 6400h to 6404h) and TPDOs no outputs (6200h to 6327h, 6410h to 6414h). It is silent where access type and mapping already say so, which is the matter of `cia301/wrong-mapping-direction`.
    ///
    /// ## Why it matters
    /// CiA 401 has outputs for RPDOs only. Some devices let a TPDO carry them, to report what is set; a master that knows the profile does not expect it.
    ///
    /// ## Example
    /// `[1A00sub1]` with `DefaultValue=0x62000108`
    ///
    /// ## How to mend
    /// Map inputs into TPDOs and outputs into RPDOs.
    ///
    /// ## Source
    /// CiA 401 (6200h, 6411h)
    "cia401/wrong-mapping-direction", Warning, Applied(demands::mapped_in_wrong_direction)
}
