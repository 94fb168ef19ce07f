//! The requirements of CiA 401: one row per rule that uses a check of [`crate::demands`].

use crate::demands::{
    different_channel_count, mapped_in_wrong_direction, missing_entry, missing_object, reserved_bits,
    undefined_sub_index, wrong_access, wrong_data_type, wrong_default, wrong_mapping, wrong_object_type,
    wrong_value,
};
use crate::rule::rules;

rules! {
    source: "CiA 401, the object descriptions";

    "cia401/different-channel-count", Warning, Against(different_channel_count);
    summary: "a parameter array and its channels have different lengths",
    checks: "The parameters of channels (polarity, filter, interrupt masks, error mode and value, limits, scaling) must have as many elements as there are channels. The rule accepts the number of channels of any width.",
    why: "Channels without an element cannot be configured, and a tool that accesses them by index gets an SDO abort.",
    example: "`[6000sub0]` with `DefaultValue=2`, `[6002sub0]` with `DefaultValue=1`",
    remedy: "Describe an element for each channel.",

    "cia401/missing-object", Error, Demand(missing_object);
    summary: "an object that CiA 401 requires in an I/O module is missing",
    checks: "An I/O module must have the PDOs for the channels that 1000h indicates, unless bit 23 declares a manufacturer-specific mapping. It must have the objects that every master can read: 6000h if it has inputs of a different width, 6200h if it has such outputs, 6401h and 6411h if it has analogue channels of a different resolution. `device-type-without-channels` reports channels that have no object at all. Objects that a module of a modular device may add are not reported.",
    why: "A master that knows only CiA 401 accesses the channels through these objects and PDOs.",
    example: "`[6100]` without `[6000]`",
    remedy: "Describe the object and implement it in the device.",
    source: "CiA 401, general data objects and default PDOs",

    "cia401/missing-sub-index", Error, Against(missing_entry);
    summary: "an array of an I/O module has no elements",
    checks: "Each array of 6000h to 6450h must have its first element.",
    why: "An array without elements describes no channels.",
    example: "`[6200]` with `[6200sub0]` only",
    remedy: "Describe the elements or remove the object.",

    "cia401/reserved-bits", Warning, Expected(reserved_bits), fix Unsafe;
    summary: "a reserved bit of an I/O module's device type is set",
    checks: "1000h must set only bits that the profile defines: 16 to 19 for kinds of channels, 23 for a manufacturer-specific mapping, 24 for a joystick. In a device with several logical devices the rule checks 67FFh and each object 800h further.",
    why: "The bits indicate the functions of a device, and a later edition may define the bit.",
    example: "`[1000]` with `DefaultValue=0x00300191`",
    remedy: "Clear the bit.",
    source: "CiA 401 (1000h)",

    "cia401/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object of an I/O module has a sub-index that CiA 401 does not define",
    checks: "Reports sub-indexes of the objects 6000h to 6450h that the profile does not define. The range is 1 to 254, but 1 to 128 for single bits (such as 6020h to 6027h) and 1 to 8 for 6422h.",
    why: "Masters look for bit 129 at the next index.",
    example: "`[6020sub81]`; line 129 is 6021h sub-index 1",
    remedy: "Continue at the next index after 128 lines.",

    "cia401/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "a channel or parameter of an I/O module has the wrong access type",
    checks: "The rule compares the access types of 6000h to 6450h with CiA 401. Inputs must be `ro`, outputs `rww` or, as before version 4 of CiA 301, `rw`, and parameters `rw`.",
    why: "An output that is `ro` cannot be set. Tools offer a writable input for RPDOs.",
    example: "`[6200sub1]` with `AccessType=ro`",
    remedy: "Use the access type of the profile, in the description and in the device.",

    "cia401/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "a channel or parameter of an I/O module has the wrong data type",
    checks: "The rule compares the data types of 6000h to 6450h with CiA 401. The data type of 6404h and 6414h is manufacturer-specific.",
    why: "A master that knows the profile reads 6401h as INTEGER16. If the device uses UNSIGNED16, half of all voltages are wrong without any error.",
    example: "`[6401sub1]` with `DataType=0x0006`; it is an INTEGER16, `0x0003`",
    remedy: "Use the data type of the profile, in the description and in the device.",

    "cia401/wrong-default", Warning, Expected(wrong_default), fix Unsafe;
    summary: "the default of an I/O module's parameter differs from CiA 401",
    checks: "Interrupt masks, error modes and values, filters, limits and scaling must have the defaults of the profile: 6005h true, 6006h, 6206h and 6208h FFh, 6421h 07h, 6423h false, 6443h 1, scaling 1, all others 0. Limits are not checked because they depend on the sensor.",
    why: "After a module is replaced, the new one behaves differently until it is configured. In real files the vendor has mostly changed the trigger of analogue inputs. Outputs matter most: with an error mode of 0 they keep their state when the master fails.",
    example: "`[6206sub1]` with `DefaultValue=0x00`",
    remedy: "Use the default of the profile, in the description and in the device.",

    "cia401/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "a parameter of an I/O module is marked as mappable",
    checks: "Reports parameters with `PDOMapping` set: polarity, filters, masks, error modes and values, limits, scaling. Only channels are process data.",
    why: "A configuration tool offers the parameter for a PDO, and the device rejects the mapping.",
    example: "`[6202sub1]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`, unless the device can really map the parameter.",

    "cia401/wrong-mapping-direction", Warning, Demand(mapped_in_wrong_direction);
    summary: "a TPDO carries outputs or an RPDO carries inputs",
    checks: "RPDOs must not carry inputs (6000h to 6127h, 6400h to 6404h). TPDOs must not carry outputs (6200h to 6327h, 6410h to 6414h). If access type and mapping already forbid it, `cia301/wrong-mapping-direction` reports it instead.",
    why: "CiA 401 maps outputs into RPDOs only. Some devices let a TPDO carry them to report the current state; a master that knows the profile does not expect this.",
    example: "`[1A00sub1]` with `DefaultValue=0x62000108`",
    remedy: "Map inputs into TPDOs and outputs into RPDOs.",
    source: "CiA 401 (6200h, 6411h)",

    "cia401/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object of an I/O module has the wrong object type",
    checks: "The rule compares the object types of 6000h to 6450h with CiA 401: nearly all are ARRAYs, 6005h and 6423h are VARs. A RECORD instead of an ARRAY is a warning because all its entries remain accessible. Vendors who name each channel use RECORDs in every third file.",
    why: "A VAR has no sub-index 1, so a master that reads the first channel gets an SDO abort.",
    example: "`[6000]` with `ObjectType=0x7`",
    remedy: "Use the object type of the profile; a single channel is an ARRAY with one element.",

    "cia401/wrong-value", Error, Expected(wrong_value);
    summary: "a parameter of an I/O module has an undefined value",
    checks: "The trigger selection of an analogue input (6421h) must be 0 to 31, and the error mode of an analogue output (6443h) 0 or 1. An error reaction of 1029h must be 0 to 2 or manufacturer-specific (128 to 255).",
    why: "The device rejects the value, or the behaviour of the device is undefined.",
    example: "`[6421sub1]` with `DefaultValue=0x20`",
    remedy: "Write a value that the profile defines.",
    source: "CiA 401 (6421h, 6443h, 1029h)",
}
