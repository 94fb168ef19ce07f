//! What CiA 401 demands: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{
    different_channel_count, mapped_in_wrong_direction, missing_entry, missing_object, reserved_bits,
    undefined_sub_index, wrong_access, wrong_data_type, wrong_default, wrong_mapping, wrong_object_type,
    wrong_value,
};
use crate::rule::demands;

demands! {
    "cia401/different-channel-count", Warning, Against(different_channel_count);
    summary: "a parameter has not as many elements as there are channels",
    checks: "Whether the parameters of channels (polarity, filter, interrupt masks, error mode and value, limits, scaling) have as many elements as the channels. It is silent when any of the forms of the channels has that number.",
    why: "The channels without an element cannot be configured, and a tool that goes through them together is answered with an abort.",
    example: "`[6000sub0]` with `DefaultValue=2`, `[6002sub0]` with `DefaultValue=1`",
    remedy: "Describe an element for each channel.",
    source: "CiA 401, the object descriptions",

    "cia401/missing-object", Error, Applied(missing_object);
    summary: "an object that CiA 401 demands of an I/O module is missing",
    checks: "Whether an I/O module has the PDOs of the channels that 1000h names, unless bit 23 says that the manufacturer maps them, and the form that each master can read: 6000h beside inputs of another width, 6200h beside such outputs, 6401h and 6411h beside analogue channels of another resolution. Channels for which there is no object at all are the matter of `device-type-without-channels`. What a module may bring is not missed.",
    why: "A master that knows CiA 401 and nothing else of the device finds its channels there, and in those PDOs.",
    example: "`[6100]` and no `[6000]`",
    remedy: "Describe the object, and build it into the device.",
    source: "CiA 401, general data objects and default PDOs",

    "cia401/missing-sub-index", Error, Against(missing_entry);
    summary: "an array of an I/O module has no element",
    checks: "Whether each array of 6000h to 6450h has its first element.",
    why: "An array without elements describes channels that are not there.",
    example: "`[6200]` with `[6200sub0]` only",
    remedy: "Describe the elements, or leave the object out.",
    source: "CiA 401, the object descriptions",

    "cia401/reserved-bits", Warning, Expected(reserved_bits), fix Unsafe;
    summary: "a reserved bit of the device type of an I/O module is set",
    checks: "Whether only bits of 1000h are set that the profile defines: 16 to 19 for kinds of channels, 23 for a mapping of the manufacturer, 24 for a joystick. In a module of several logical devices those of 67FFh and each 800h behind it.",
    why: "The bits name what a device can do; a later edition may give the bit a meaning.",
    example: "`[1000]` with `DefaultValue=0x00300191`",
    remedy: "Clear the bit.",
    source: "CiA 401 (1000h)",

    "cia401/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object of an I/O module has a sub-index that CiA 401 does not define",
    checks: "Whether each sub-index of an object of 6000h to 6450h is one that the profile has: 1 to 254, 1 to 128 for single bits (6020h to 6027h and the like), 1 to 8 for 6422h.",
    why: "Bit 129 has an index of its own, the next one, and that is where masters look for it.",
    example: "`[6020sub81]`; line 129 is 6021h sub-index 1",
    remedy: "Go on with the next index after 128 lines.",
    source: "CiA 401, the object descriptions",

    "cia401/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "a channel or parameter of an I/O module has another access type",
    checks: "The access types of 6000h to 6450h. Inputs are `ro`, outputs `rww`, or `rw` as before version 4 of CiA 301; parameters are `rw`.",
    why: "An output that is `ro` cannot be set. An input that can be written is no input, and a tool offers it for RPDOs.",
    example: "`[6200sub1]` with `AccessType=ro`",
    remedy: "Use the access type of the profile, in the description and in the device.",
    source: "CiA 401, the object descriptions",

    "cia401/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "a channel or parameter of an I/O module has another data type",
    checks: "The data types of 6000h to 6450h. What 6404h and 6414h hold is up to the manufacturer.",
    why: "A master that knows the profile reads 6401h as INTEGER16. As UNSIGNED16 half of all voltages come out wrong, without any error.",
    example: "`[6401sub1]` with `DataType=0x0006`; it is an INTEGER16, `0x0003`",
    remedy: "Use the data type of the profile, in the description and in the device.",
    source: "CiA 401, the object descriptions",

    "cia401/wrong-default", Warning, Expected(wrong_default), fix Unsafe;
    summary: "a parameter of an I/O module has another default than CiA 401 gives it",
    checks: "Whether interrupt masks, error modes and values, filters, limits and scaling start as the profile says: 6005h true, 6006h, 6206h and 6208h FFh, 6421h 07h, 6423h false, 6443h 1, scaling 1, all others 0. Limits, which fit the sensor, are left out.",
    why: "A module that replaces another one behaves in another way until somebody configures it. In real files it is mostly the trigger of analogue inputs that the maker has chosen. Outputs are what matters: with an error mode of 0 they keep their state when the master is gone.",
    example: "`[6206sub1]` with `DefaultValue=0x00`",
    remedy: "Use the default of the profile, in the description and in the device.",
    source: "CiA 401, the object descriptions",

    "cia401/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "a parameter of an I/O module is marked as mappable",
    checks: "Whether `PDOMapping` is set at a parameter: polarity, filters, masks, error modes and values, limits, scaling. Only channels are process data.",
    why: "A configuration tool offers it for a PDO, and the device refuses the mapping.",
    example: "`[6202sub1]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`, unless the device does let PDOs carry it.",
    source: "CiA 401, the object descriptions",

    "cia401/wrong-mapping-direction", Warning, Applied(mapped_in_wrong_direction);
    summary: "a PDO carries outputs to the network, or inputs from it",
    checks: "Whether RPDOs carry no inputs (6000h to 6127h, 6400h to 6404h) and TPDOs no outputs (6200h to 6327h, 6410h to 6414h). It is silent where access type and mapping already say so, which is the matter of `cia301/wrong-mapping-direction`.",
    why: "CiA 401 has outputs for RPDOs only. Some devices let a TPDO carry them, to report what is set; a master that knows the profile does not expect it.",
    example: "`[1A00sub1]` with `DefaultValue=0x62000108`",
    remedy: "Map inputs into TPDOs and outputs into RPDOs.",
    source: "CiA 401 (6200h, 6411h)",

    "cia401/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object of an I/O module is of another object type",
    checks: "The object types of 6000h to 6450h: nearly all are ARRAYs, 6005h and 6423h are VARs. A RECORD in place of an ARRAY is a warning, for all its entries can be reached; makers with a name for each channel have that in every third file.",
    why: "A VAR has no sub-index 1, so a master that reads the first channel is answered with an abort.",
    example: "`[6000]` with `ObjectType=0x7`",
    remedy: "Use the object type of the profile; a single channel is an ARRAY with one element.",
    source: "CiA 401, the object descriptions",

    "cia401/wrong-value", Error, Expected(wrong_value);
    summary: "a parameter of an I/O module has a value that means nothing",
    checks: "Whether the trigger selection of an analogue input, 6421h, is 0 to 31, the error mode of an analogue output, 6443h, 0 or 1, and an error reaction of 1029h 0 to 2 or one of the manufacturer (128 to 255).",
    why: "The device refuses the value, or does what nobody knows.",
    example: "`[6421sub1]` with `DefaultValue=0x20`",
    remedy: "Write a value that the profile defines.",
    source: "CiA 401 (6421h, 6443h, 1029h)",
}
