//! Where the objects of modules lie (`moduleManagement` of `ApplicationLayers`).

use crate::model::{ModuleObjects, ModuleRange, ModuleRanges, OwnAddressing};

shape! {
    ModuleObjects [] { "interfaceList" => { "interface" => interfaces }, "moduleInterface" => own }

    ModuleRanges ["uniqueIDRef" = interface, "addressing" = addressing] {
        "rangeList" => [ "range" => ranges ],
    }

    ModuleRange [
        "name" = name, "moduleType" = module_type, "baseIndex" = base_index, "maxIndex" = max_index,
        "maxSubIndex" = max_sub_index, "sortMode" = sort_mode, "sortNumber" = sort_number, "sortStep" = sort_step,
    ] {}

    OwnAddressing [
        "childIDRef" = child, "addressMin" = address_min, "addressMax" = address_max, "addressing" = addressing,
    ] {}
}
