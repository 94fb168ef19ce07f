//! What CiA 406 demands: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{
    different_channel_count, misplaced_object, missing_entry, missing_object, reserved_bits,
    undefined_field_value, undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping,
    wrong_object_type,
};
use crate::rule::demands;

demands! {
    "cia406/different-channel-count", Warning, Against(different_channel_count);
    summary: "an object of an encoder has not as many elements as there are sensors or channels",
    checks: "Whether 6010h and 650Ch have as many elements as 6020h, 6301h and 6302h as many as 6300h, 6401h and 6402h as many as 6400h.",
    why: "A sensor without an element has no preset, a work area without a limit no end.",
    example: "`[6020sub0]` with `DefaultValue=2`, `[6010sub0]` with `DefaultValue=1`",
    remedy: "Describe an element for each sensor or channel.",
    source: "CiA 406, the object descriptions",

    "cia406/misplaced-object", Warning, Against(misplaced_object);
    summary: "an encoder that turns has an object of linear ones, or the other way round",
    checks: "Whether 6001h (measuring units per revolution) and 6502h (number of revolutions) are there for encoders that turn only, and 6005h (measuring steps) for linear ones only, as the type in 1000h says.",
    why: "The object means nothing in this device, or the type is wrong, and with it the meaning of all values.",
    example: "`[6005]` in an encoder with `[1000]` `DefaultValue=0x00020196`",
    remedy: "Leave the object out, or correct the type.",
    source: "CiA 406, the object descriptions",

    "cia406/missing-object", Error, Applied(missing_object);
    summary: "an object that CiA 406 demands of an encoder is missing",
    checks: "Whether an encoder has what each class has: 6000h, 6500h and 6501h; 6004h, or 6020h for several sensors; 6502h when it turns; and its two TPDOs, 1800h and 1801h with their mappings (1802h in place of 1801h, as in editions before 3). What depends on the type of the encoder is not missed where 1000h does not state it.",
    why: "The position is where a master looks for it, TPDO 1 sends it, and resolution and number of revolutions say what it means.",
    example: "no `[6502]` in an encoder with `[1000]` `DefaultValue=0x00020196`",
    remedy: "Describe the object, and build it into the device.",
    source: "CiA 406, class C1",

    "cia406/missing-sub-index", Error, Against(missing_entry);
    summary: "an object of an encoder has no sub-index that CiA 406 demands",
    checks: "Whether each array of 6005h to 650Ch has its first element, and 6005h and 650Ah what they always have.",
    why: "An array without elements describes what is not there.",
    example: "`[6030]` with `[6030sub0]` only",
    remedy: "Describe the sub-index, or leave the object out.",
    source: "CiA 406, the object descriptions",

    "cia406/reserved-bits", Warning, Expected(reserved_bits), fix Unsafe;
    summary: "a reserved bit of an encoder parameter is set",
    checks: "Whether only bits are set that the profile defines: 0 to 3 and 12 to 15 of 6000h and 6500h, 0, 1 and 12 to 15 of alarms (6503h, 6504h), 0 to 5 and 12 to 15 of warnings (6505h, 6506h).",
    why: "A later edition may give the bit a meaning. What is your own belongs into bits 12 to 15. Bit 0 of 6000h, the code sequence, is a trap of its own: with encoders of most manufacturers 0 means that the position rises clockwise, some texts have it the other way round, so state it in the manual.",
    example: "`[6000]` with `DefaultValue=0x0010`",
    remedy: "Clear the bit.",
    source: "CiA 406 (6000h, 6500h, 6503h to 6506h)",

    "cia406/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object of an encoder has a sub-index that CiA 406 does not define",
    checks: "Whether each sub-index of 6005h to 650Ch is one that the profile has.",
    why: "A later edition may give it another meaning, and tools that know the profile do not show it.",
    example: "`[650Asub4]`",
    remedy: "Put what is your own into 2000h to 5FFFh.",
    source: "CiA 406, the object descriptions",

    "cia406/unknown-encoder-type", Error, Expected(undefined_field_value);
    summary: "the device type names an encoder that CiA 406 does not know",
    checks: "Whether the high word of 1000h is one of the types 1 to 10. In a module of several logical devices that of 67FFh and each 800h behind it.",
    why: "The type says whether the encoder turns or is linear, and with it which objects it has and what their values mean.",
    example: "`[1000]` with `DefaultValue=0x00000196`",
    remedy: "Write the type: 1 single-turn, 2 multi-turn, 8 absolute linear, and so on.",
    source: "CiA 406 (1000h)",

    "cia406/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "an entry of an encoder has another access type",
    checks: "The access types of 6000h to 6510h: what the encoder measures or states is `ro`, among it the operating status 6500h, and what configures it is `rw`. Some databases give 6020h and 6502h as `rw`, which is a mistake.",
    why: "A position that can be written is no position; a preset that cannot be is none.",
    example: "`[6500]` with `AccessType=rw`",
    remedy: "Use the access type of the profile, in the description and in the device.",
    source: "CiA 406, the object descriptions",

    "cia406/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "an entry of an encoder has another data type",
    checks: "The data types of 6000h to 6510h. Positions and presets are UNSIGNED32 or, as later editions have them for linear encoders, INTEGER32.",
    why: "A position of another length does not fit the mapping of TPDO 1, and a preset of another length is refused.",
    example: "`[6004]` with `DataType=0x0006`; a position has 32 bits",
    remedy: "Use the data type of the profile, in the description and in the device.",
    source: "CiA 406, the object descriptions",

    "cia406/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "a parameter of an encoder is marked as mappable",
    checks: "Whether `PDOMapping` is set at a parameter or a constant: 6000h to 6003h, 6200h, 6500h to 6502h and the like. Positions, speeds, alarms, warnings and CAM states are what PDOs carry.",
    why: "A configuration tool offers it for a PDO, and the device refuses the mapping.",
    example: "`[6502]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`, unless the device does let PDOs carry it.",
    source: "CiA 406, the object descriptions",

    "cia406/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object of an encoder is of another object type",
    checks: "The object types of 6000h to 6510h. A RECORD in place of an ARRAY is a warning, for all its entries can be reached.",
    why: "A position at sub-index 1 is not found by a master that reads 6004h, and the mapping 60040020h does not fit.",
    example: "`[6004]` with `ObjectType=0x8`",
    remedy: "Use the object type of the profile: 6004h is a VAR, what exists for each sensor or channel is an ARRAY.",
    source: "CiA 406, the object descriptions",
}
