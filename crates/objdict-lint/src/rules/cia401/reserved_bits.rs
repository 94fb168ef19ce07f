use crate::{demands, rule};

rule! {
    /// a reserved bit of the device type of an I/O module is set
    ///
    /// ## What it checks
    /// Whether only bits of 1000h are set that the profile defines: 16 to 19 for kinds of channels, 23 for a mapping of the manufacturer, 24 for a joystick. In a module of several logical devices those of 67FFh and each 800h behind it.
    ///
    /// ## Why it matters
    /// The bits name what a device can do; a later edition may give the bit a meaning.
    ///
    /// ## Example
    /// `[1000]` with `DefaultValue=0x00300191`
    ///
    /// ## How to mend
    /// Clear the bit.
    ///
    /// ## Source
    /// CiA 401 (1000h)
    "cia401/reserved-bits", Warning, Expected(demands::reserved_bits), fix Unsafe
}
