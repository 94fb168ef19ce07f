use crate::{demands, rule};

rule! {
    /// a communication object has another data type than CiA 301 gives it
    ///
    /// ## What it checks
    /// The data types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists, entry by entry. Where editions of CiA 301 differ, both types are accepted: 1022h is UNSIGNED8 or UNSIGNED16. Sub-index 0 is the matter of a rule of its own.
    ///
    /// ## Why it matters
    /// Managers write these objects with the length that CiA 301 gives them. A device with another length answers with an abort, and the boot-up ends there.
    ///
    /// ## Example
    /// `[1017]` with `DataType=0x0007`
    ///
    /// ## How to mend
    /// Use the data type of the standard, in the description and in the device.
    ///
    /// ## Source
    /// CiA 301 §7.5.2
    "cia301/wrong-data-type", Error, Expected(demands::wrong_data_type), fix Unsafe
}
