use crate::{demands, rule};

rule! {
    /// an object that CiA 401 demands of an I/O module is missing
    ///
    /// ## What it checks
    /// Whether an I/O module has the PDOs of the channels that 1000h names, unless bit 23 says that the manufacturer maps them, and the form that each master can read: 6000h beside inputs of another width, 6200h beside such outputs, 6401h and 6411h beside analogue channels of another resolution. Channels for which there is no object at all are the matter of `device-type-without-channels`. What a module may bring is not missed.
    ///
    /// ## Why it matters
    /// A master that knows CiA 401 and nothing else of the device finds its channels there, and in those PDOs.
    ///
    /// ## Example
    /// `[6100]` and no `[6000]`
    ///
    /// ## How to mend
    /// Describe the object, and build it into the device.
    ///
    /// ## Source
    /// CiA 401, general data objects and default PDOs
    "cia401/missing-object", Error, Applied(demands::missing_object)
}
