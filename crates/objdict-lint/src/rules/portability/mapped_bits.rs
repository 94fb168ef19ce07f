use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    /// a PDO carries single bits
    ///
    /// ## What it checks
    /// Whether the default mapping has entries whose length is no multiple of eight bits.
    ///
    /// ## Why it matters
    /// CANopenNode maps whole bytes, unless it is configured for bits (`CO_CONFIG_PDO_BITWISE_MAPPING`); the PDO is not valid then.
    ///
    /// ## Example
    /// `0x20000001` in 1A00h
    ///
    /// ## How to mend
    /// Map entries of whole bytes, or configure the stack for bits.
    ///
    /// ## Source
    /// PDOconfigMap of CANopenNode 4
    "portability/mapped-bits", Warning, Device(check)
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Bits, device, findings);
}
