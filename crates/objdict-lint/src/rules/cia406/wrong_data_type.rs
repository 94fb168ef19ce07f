use crate::{demands, rule};

rule! {
    /// an entry of an encoder has another data type
    ///
    /// ## What it checks
    /// The data types of 6000h to 6510h. Positions and presets are UNSIGNED32 or, as later editions have them for linear encoders, INTEGER32.
    ///
    /// ## Why it matters
    /// A position of another length does not fit the mapping of TPDO 1, and a preset of another length is refused.
    ///
    /// ## Example
    /// `[6004]` with `DataType=0x0006`; a position has 32 bits
    ///
    /// ## How to mend
    /// Use the data type of the profile, in the description and in the device.
    ///
    /// ## Source
    /// CiA 406, the object descriptions
    "cia406/wrong-data-type", Error, Expected(demands::wrong_data_type), fix Unsafe
}
