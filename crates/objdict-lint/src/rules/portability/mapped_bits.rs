use crate::canopennode::Cause;
use crate::diagnostic::Findings;
use crate::model::Device;
use crate::{rule, stack};

rule! {
    "portability/mapped-bits", Warning, Device(check);
    summary: "a PDO maps single bits",
    checks: "Whether the default mapping has entries whose length is not a multiple of eight bits.",
    why: "CANopenNode maps whole bytes unless configured for bits (`CO_CONFIG_PDO_BITWISE_MAPPING`); otherwise the PDO is not valid.",
    example: "`0x20000001` in 1A00h",
    remedy: "Map entries of whole bytes, or configure the stack for bits.",
    source: "PDOconfigMap of CANopenNode 4",
}

fn check(device: &Device, findings: &mut Findings) {
    stack::unmet(&RULE.info, Cause::Bits, device, findings);
}
