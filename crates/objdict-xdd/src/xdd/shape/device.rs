//! What the device profile says of indicators, module interfaces and functions.

use crate::model::{
    Characteristic, CharacteristicsList, CombinedState, Compliance, ConnectedModule, DeviceFunction,
    DeviceManager, Dictionary, Led, LedState, ModuleInterface, ModuleType, OwnInterface, Picture,
};

shape! {
    DeviceManager [] {
        "indicatorList" => { "LEDList" => { "LED" => leds, "combinedState" => combined_states } },
        "moduleManagement" => {
            "moduleInterfaceList" => { "interface" => module_interfaces },
            "moduleInterface" => own_interface,
        },
    }

    Led ["LEDcolors" = colors, "LEDtype" = kind] { _ => labels, "LEDstate" => states }

    LedState [
        "uniqueID" = unique_id, "state" = state, "LEDcolor" = color, "flashingPeriod" = flashing_period,
        "impulsWidth" = impulse_width, "numberOfImpulses" = impulses,
    ] { _ => labels }

    CombinedState [] { _ => labels, "LEDstateRef" @ "stateIDRef" => states }

    ModuleInterface [
        "uniqueID" = unique_id, "maxChilds" = max_modules, "unusedSlots" = unused_slots, "multipleChilds" = multiple,
    ] {
        _ => labels,
        "fileList" => [ "file" @ "URI" => files ],
        "moduleTypeList" => [ "moduleType" => module_types ],
        "connectedModuleList" => { "connectedModule" => connected },
    }

    ModuleType ["uniqueID" = unique_id, "type" = kind] {}

    ConnectedModule ["childIDRef" = child, "position" = position, "address" = address] {}

    OwnInterface ["childID" = child_id, "type" = kind, "maxCount" = max_count] {}

    DeviceFunction [] {
        "capabilities" => [
            "characteristicsList" => characteristics,
            "standardComplianceList" => { "compliantWith" => compliance },
        ],
        "picturesList" => { "picture" => pictures },
        "dictionaryList" => { "dictionary" => dictionaries },
    }

    CharacteristicsList [] { "category" => category, "characteristic" => characteristics }

    Characteristic [] { "characteristicName" => name, "characteristicContent" => contents }

    Compliance ["name" = name, "range" = range] { _ => labels }

    Picture ["URI" = uri, "number" = number] { _ => labels }

    Dictionary ["lang" = lang, "dictID" = id] { "file" @ "URI" => uri }
}
