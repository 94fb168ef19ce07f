//! Changes of PDOs as a whole, and of other CAN-IDs.

use super::changes;

changes! {
    source: "CiA 301 §7.5.2.35, §7.5.2.37";

    "change/pdo-added" = PDO_ADDED {
        Configurations: Compatible, "a stored configuration does not write its parameters";
        PdoConsumers: Compatible, "the frames of other PDOs are unchanged; an additional CAN-ID may be in use";
        SdoClients: Compatible, "clients that do not know its parameters do not access them";
        Firmware: Compatible, "generated code has additional names";
    }
    summary: "a PDO is added",
    checks: "The new description has a PDO that the old one does not have, either described or implied by `CompactPDO`.",
    example: "`[1801]` and `[1A01]` are only in the new description",
    remedy: "Check that its CAN-ID is free if it is valid by default.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "change/pdo-removed" = PDO_REMOVED {
        Configurations: Breaking, "the device rejects the download of its parameters with abort code 06020000h";
        PdoConsumers: Breaking, "the frame is no longer sent or received";
        SdoClients: Breaking, "each access to its parameters is rejected with abort code 06020000h";
        Firmware: Breaking, "the PDO's names are missing from generated code";
    }
    summary: "a PDO is removed",
    checks: "A PDO of the old description, described or implied by `CompactPDO`, is missing in the new one.",
    example: "`[1801]` and `[1A01]` are only in the old description",
    remedy: "Keep the PDO, or bump the major revision number.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "change/pdo-mapping-changed" = PDO_MAPPING_CHANGED {
        Configurations: Risky, "a stored configuration that contains only differences from the defaults does not overwrite the new mapping";
        PdoConsumers: Breaking, "the frame has different data or a different length";
        SdoClients: Compatible, "the mapped entries are accessed in the same way";
        Firmware: Risky, "generated structures of the PDO have different members";
    }
    summary: "a PDO has a different mapping",
    checks: "After configuration, the mapped entries, their lengths or their order differ. A mapped object that moved is still the same object.",
    example: "TPDO 1: Statusword (16 bits) → Statusword, Position actual value (48 bits)",
    remedy: "Keep the mapping and map new entries to a different PDO.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "change/pdo-cob-id-changed" = PDO_COB_ID_CHANGED {
        Configurations: Risky, "a stored configuration that contains only differences from the defaults does not overwrite the new CAN-ID";
        PdoConsumers: Breaking, "consumers and producers use different CAN-IDs";
        SdoClients: Compatible, "the parameter is accessed in the same way";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "a PDO has a different CAN-ID",
    checks: "The CAN-ID of a PDO that is valid in the old description changes, after configuration.",
    example: "`DefaultValue=$NODEID+0x180`, then `DefaultValue=$NODEID+0x1C0`",
    remedy: "Keep the CAN-ID.",

    "change/pdo-disabled" = PDO_DISABLED {
        Configurations: Risky, "a stored configuration that does not write the COB-ID leaves the PDO not valid";
        PdoConsumers: Breaking, "the frame is not sent or not received until a manager makes the PDO valid";
        SdoClients: Compatible, "the parameter is accessed in the same way";
    }
    summary: "a PDO is no longer valid",
    checks: "Bit 31 of the COB-ID is clear in the old description and set in the new one, after configuration.",
    example: "`DefaultValue=$NODEID+0x180`, then `DefaultValue=$NODEID+0x80000180`",
    remedy: "Keep the PDO valid.",

    "change/pdo-enabled" = PDO_ENABLED {
        Configurations: Risky, "a stored configuration that does not write the COB-ID leaves the PDO valid";
        PdoConsumers: Risky, "the device uses a CAN-ID that it did not use before";
        SdoClients: Compatible, "the parameter is accessed in the same way";
    }
    summary: "a PDO that was not valid becomes valid",
    checks: "Bit 31 of the COB-ID is set in the old description and clear in the new one, after configuration.",
    example: "`DefaultValue=$NODEID+0x80000180`, then `DefaultValue=$NODEID+0x180`",
    remedy: "Check that the CAN-ID is free in existing networks and that the bus has capacity for the frames.",

    "change/pdo-transmission-changed" = PDO_TRANSMISSION_CHANGED {
        Configurations: Risky, "a stored configuration that contains only differences from the defaults does not overwrite the new transmission parameters";
        PdoConsumers: Risky, "the frame is sent at other times";
        SdoClients: Compatible, "the parameter is accessed in the same way";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "a PDO is sent at other times",
    checks: "The transmission type, inhibit time, event timer, SYNC start value or RTR permission changes, after configuration.",
    example: "transmission type 254, then 1",
    remedy: "Keep the transmission parameters.",

    "change/cob-id-changed" = COB_ID_CHANGED {
        Configurations: Risky, "a stored configuration that contains only differences from the defaults does not overwrite the new CAN-ID";
        PdoConsumers: Compatible, "PDOs have their own CAN-IDs";
        SdoClients: Breaking, "SYNC, EMCY, TIME, SDO or SRDO frames have a different CAN-ID";
        Firmware: Compatible, "names and types are unchanged";
    }
    summary: "a service has a different CAN-ID",
    checks: "After configuration, the value of 1005h, 1012h or 1014h differs, or a COB-ID of an SDO (1200h to 12FFh) or SRDO (1301h to 1340h).",
    example: "`DefaultValue=$NODEID+0x80` of 1014h, then `DefaultValue=$NODEID+0x90`",
    remedy: "Keep the CAN-ID.",
    source: "CiA 301 §7.3.5",
}
