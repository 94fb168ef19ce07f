use crate::{demands, rule};

rule! {
    /// an entry of a drive has a value that CiA 402 reserves
    ///
    /// ## What it checks
    /// Whether the value of an entry, configured or default, is one that CiA 402 defines or leaves to the manufacturer: option codes 6007h and 605Ah to 605Eh, modes 6060h and 6061h, profile types 6086h and 6088h, homing method 6098h, jerk use 60A3h, index of the interpolation time 60C2h, buffer organization 60C4h.
    ///
    /// ## Why it matters
    /// A drive refuses the value, or does what its maker thought of and nobody else knows: a quick stop that does not stop.
    ///
    /// ## Example
    /// `DefaultValue=9` in `[605A]`, where 8 is the last that is defined
    ///
    /// ## How to mend
    /// Use a defined value, or a negative one, which belongs to the manufacturer.
    ///
    /// ## Source
    /// CiA 402-2, IEC 61800-7-201 §7 to §16
    "cia402/wrong-value", Error, Expected(demands::wrong_value)
}
