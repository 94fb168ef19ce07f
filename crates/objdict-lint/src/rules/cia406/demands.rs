//! The requirements of CiA 406: one row per rule that uses a check of [`crate::demands`].

use crate::demands::{
    different_channel_count, misplaced_object, missing_entry, missing_object, reserved_bits,
    undefined_field_value, undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping,
    wrong_object_type,
};
use crate::rule::rules;

rules! {
    source: "CiA 406, the object descriptions";

    "cia406/different-channel-count", Warning, Against(different_channel_count);
    summary: "the elements of an encoder's object do not match its sensors or channels",
    checks: "6010h and 650Ch must have as many elements as 6020h, 6301h and 6302h as many as 6300h, 6401h and 6402h as many as 6400h.",
    why: "A sensor without an element has no preset, and a work area without an element has no limit.",
    example: "`[6020sub0]` with `DefaultValue=2`, `[6010sub0]` with `DefaultValue=1`",
    remedy: "Describe one element per sensor or channel.",

    "cia406/misplaced-object", Warning, Against(misplaced_object);
    summary: "a rotary encoder has an object of linear encoders, or vice versa",
    checks: "Only rotary encoders may have 6001h (measuring units per revolution) and 6502h (number of revolutions). Only linear encoders may have 6005h (measuring steps). The type is in 1000h.",
    why: "The object is meaningless in this device, or the type in 1000h is wrong, and so is the meaning of all values.",
    example: "`[6005]` in an encoder with `[1000]` `DefaultValue=0x00020196`",
    remedy: "Remove the object or correct the type.",

    "cia406/missing-object", Error, Demand(missing_object);
    summary: "an object that CiA 406 requires in an encoder is missing",
    checks: "An encoder must have the objects of every class: 6000h, 6500h and 6501h; 6004h, or 6020h for several sensors; 6502h for rotary encoders. It must also have its two TPDOs, 1800h and 1801h with their mappings (1802h instead of 1801h, as in editions before 3). Objects that depend on the encoder type are not checked if 1000h does not indicate the type.",
    why: "Masters read the position from this object or from TPDO 1 and need resolution and number of revolutions to interpret it.",
    example: "no `[6502]` in an encoder with `[1000]` `DefaultValue=0x00020196`",
    remedy: "Describe the object and implement it in the device.",
    source: "CiA 406, class C1",

    "cia406/missing-sub-index", Error, Against(missing_entry);
    summary: "a sub-index that CiA 406 requires is missing from an encoder's object",
    checks: "Each array of 6005h to 650Ch must have its first element. 6005h and 650Ah must have their mandatory sub-indexes.",
    why: "An array without elements is useless.",
    example: "`[6030]` with `[6030sub0]` only",
    remedy: "Describe the sub-index or remove the object.",

    "cia406/reserved-bits", Warning, Expected(reserved_bits), fix Unsafe;
    summary: "a reserved bit of an encoder parameter is set",
    checks: "Only bits that the profile defines may be set: 0 to 3 and 12 to 15 of 6000h and 6500h, 0, 1 and 12 to 15 of alarms (6503h, 6504h), 0 to 5 and 12 to 15 of warnings (6505h, 6506h).",
    why: "A later edition may define the bit. Bits 12 to 15 are manufacturer-specific. Note bit 0 of 6000h, the code sequence: with encoders of most vendors, 0 means that the position increases clockwise. Some texts define the opposite, so specify it in the manual.",
    example: "`[6000]` with `DefaultValue=0x0010`",
    remedy: "Clear the bit.",
    source: "CiA 406 (6000h, 6500h, 6503h to 6506h)",

    "cia406/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object of an encoder has a sub-index that CiA 406 does not define",
    checks: "Reports sub-indexes of the objects 6005h to 650Ch that the profile does not define.",
    why: "A later edition may define the sub-index differently. Tools that know the profile do not show it.",
    example: "`[650Asub4]`",
    remedy: "Move manufacturer-specific values to 2000h to 5FFFh.",

    "cia406/unknown-encoder-type", Error, Expected(undefined_field_value);
    summary: "the device type contains an encoder type that CiA 406 does not define",
    checks: "The high word of 1000h must be one of the types 1 to 10. In a device with several logical devices the rule checks 67FFh and each object 800h further.",
    why: "The type distinguishes rotary and linear encoders. It determines the objects of the encoder and the meaning of their values.",
    example: "`[1000]` with `DefaultValue=0x00000196`",
    remedy: "Write the type: 1 single-turn, 2 multi-turn, 8 absolute linear, and so on.",
    source: "CiA 406 (1000h)",

    "cia406/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "an entry of an encoder has the wrong access type",
    checks: "The rule compares the access types of 6000h to 6510h with CiA 406. Measured and status values, including the operating status 6500h, must be `ro`; configuration parameters must be `rw`. Some databases list 6020h and 6502h as `rw` by mistake.",
    why: "Tools offer to write a position that is not `ro`, and a preset that is `ro` cannot be set.",
    example: "`[6500]` with `AccessType=rw`",
    remedy: "Use the access type of the profile, in the description and in the device.",

    "cia406/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "an entry of an encoder has the wrong data type",
    checks: "The rule compares the data types of 6000h to 6510h with CiA 406. Positions and presets are UNSIGNED32 or, in later editions for linear encoders, INTEGER32.",
    why: "A position of a different length does not fit the mapping of TPDO 1. The device rejects a preset of a different length.",
    example: "`[6004]` with `DataType=0x0006`; a position has 32 bits",
    remedy: "Use the data type of the profile, in the description and in the device.",

    "cia406/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "a parameter of an encoder is marked as mappable",
    checks: "Reports parameters and constants with `PDOMapping` set, such as 6000h to 6003h, 6200h, 6500h to 6502h. PDOs carry positions, speeds, alarms, warnings and CAM states.",
    why: "A configuration tool offers the parameter for a PDO, and the device rejects the mapping.",
    example: "`[6502]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`, unless the device can really map the parameter.",

    "cia406/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object of an encoder has the wrong object type",
    checks: "The rule compares the object types of 6000h to 6510h with CiA 406. A RECORD instead of an ARRAY is a warning because all its entries remain accessible.",
    why: "A master that reads 6004h does not find a position at sub-index 1, and the mapping 60040020h does not fit.",
    example: "`[6004]` with `ObjectType=0x8`",
    remedy: "Use the object type of the profile: 6004h is a VAR, objects per sensor or channel are ARRAYs.",
}
