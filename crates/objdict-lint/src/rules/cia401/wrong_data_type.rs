use crate::{demands, rule};

rule! {
    /// a channel or parameter of an I/O module has another data type
    ///
    /// ## What it checks
    /// The data types of 6000h to 6450h. What 6404h and 6414h hold is up to the manufacturer.
    ///
    /// ## Why it matters
    /// A master that knows the profile reads 6401h as INTEGER16. As UNSIGNED16 half of all voltages come out wrong, without any error.
    ///
    /// ## Example
    /// `[6401sub1]` with `DataType=0x0006`; it is an INTEGER16, `0x0003`
    ///
    /// ## How to mend
    /// Use the data type of the profile, in the description and in the device.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/wrong-data-type", Error, Expected(demands::wrong_data_type), fix Unsafe
}
