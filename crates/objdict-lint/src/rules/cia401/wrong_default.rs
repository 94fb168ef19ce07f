use crate::{demands, rule};

rule! {
    /// a parameter of an I/O module has another default than CiA 401 gives it
    ///
    /// ## What it checks
    /// Whether interrupt masks, error modes and values, filters, limits and scaling start as the profile says: 6005h true, 6006h, 6206h and 6208h FFh, 6421h 07h, 6423h false, 6443h 1, scaling 1, all others 0. Limits, which fit the sensor, are left out.
    ///
    /// ## Why it matters
    /// A module that replaces another one behaves in another way until somebody configures it. In real files it is mostly the trigger of analogue inputs that the maker has chosen. Outputs are what matters: with an error mode of 0 they keep their state when the master is gone.
    ///
    /// ## Example
    /// `[6206sub1]` with `DefaultValue=0x00`
    ///
    /// ## How to mend
    /// Use the default of the profile, in the description and in the device.
    ///
    /// ## Source
    /// CiA 401, the object descriptions
    "cia401/wrong-default", Warning, Expected(demands::wrong_default), fix Unsafe
}
