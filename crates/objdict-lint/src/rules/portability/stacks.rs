//! Services that CANopenNode and other stacks do not support.

use crate::diagnostic::Findings;
use crate::model::Device;
use crate::rule::rules;
use crate::stack;
use objdict_model::canopennode::Cause;

rules! {
    source: "CANopen.c of CANopenNode 4";

    "portability/mapped-bits" = MAPPED_BITS, Warning, Device(mapped_bits);
    summary: "a PDO maps single bits",
    checks: "Whether the default mapping has entries whose length is not a multiple of eight bits.",
    why: "CANopenNode maps whole bytes unless configured for bits (`CO_CONFIG_PDO_BITWISE_MAPPING`); otherwise the PDO is not valid.",
    example: "`0x20000001` in 1A00h",
    remedy: "Map entries of whole bytes, or configure the stack for bits.",
    source: "PDOconfigMap of CANopenNode 4",

    "portability/no-error-history" = NO_ERROR_HISTORY, Error, Device(no_error_history);
    summary: "a stack needs 1003h, error history",
    checks: "Whether the device has 1003h.",
    why: "CANopenNode keeps an error history unless configured otherwise (`CO_CONFIG_EM` without `CO_CONFIG_EM_HISTORY`). Without 1003h its start fails, without error information.",
    example: "no `[1003]`",
    remedy: "Describe 1003h as an ARRAY with at least one element, or configure the stack without the history.",
    source: "CO_EM_init of CANopenNode 4",

    "portability/service-count" = SERVICE_COUNT, Error, Device(service_count);
    summary: "a stack does not support this number of objects",
    checks: "Whether the number of objects per service is within the limits of CANopenNode, which counts objects by index or count label (`CO_countLabel`): one for most services, 64 SRDOs, 128 SDO servers and 128 SDO clients, 255 RPDOs and 255 TPDOs. 1016h has 1 to 127 elements.",
    why: "CANopenNode does not compile; PDOs above 255 are ignored because the count is a byte.",
    example: "1016h with 128 elements",
    remedy: "Describe fewer objects, or use the count label for one object only.",

    "portability/service-gap" = SERVICE_GAP, Warning, Device(service_gap);
    summary: "the objects of a service are not consecutive",
    checks: "Whether SDO servers and clients, RPDOs and TPDOs are numbered from the first one without a gap, and each PDO has its mapping.",
    why: "CANopenNode takes consecutive entries of its object list, starting at the first. After a gap it uses the wrong objects; without the first one it does not compile.",
    example: "1800h and 1802h without 1801h",
    remedy: "Number the PDOs without a gap. Set bit 31 of the COB-ID of unused PDOs (not valid).",

    "portability/service-object-missing" = SERVICE_OBJECT_MISSING, Error, Device(service_object_missing);
    summary: "an object required by a stack is missing",
    checks: "Whether the device has 1000h, 1001h, 1014h and 1017h, and also 1006h if it has 1005h, counted by the count labels of the description (`CO_countLabel`) too.",
    why: "CANopenNode is compiled with the objects of its services and does not compile if one of them is missing, although most of them are optional in CiA 301.",
    example: "no `[1017]`",
    remedy: "Describe the object. A producer heartbeat time of 0 and an EMCY COB-ID with bit 31 set (not valid) disable the services.",
}

fn mapped_bits(device: &Device, findings: &mut Findings) {
    stack::unmet(&MAPPED_BITS.info, Cause::Bits, device, findings);
}

fn no_error_history(device: &Device, findings: &mut Findings) {
    stack::unmet(&NO_ERROR_HISTORY.info, Cause::NoHistory, device, findings);
}

fn service_count(device: &Device, findings: &mut Findings) {
    stack::unmet(&SERVICE_COUNT.info, Cause::Count, device, findings);
}

fn service_gap(device: &Device, findings: &mut Findings) {
    stack::unmet(&SERVICE_GAP.info, Cause::Gap, device, findings);
}

fn service_object_missing(device: &Device, findings: &mut Findings) {
    stack::unmet(&SERVICE_OBJECT_MISSING.info, Cause::Missing, device, findings);
}
