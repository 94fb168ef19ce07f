//! Changes of PDOs as wholes, and of other CAN-IDs.

use super::changes;

changes! {
    source: "CiA 301 §7.5.2.35, §7.5.2.37";

    "change/pdo-added" = PDO_ADDED {
        Configurations: Compatible, "a stored configuration does not write its parameters";
        PdoConsumers: Compatible, "the frames of other PDOs stay; another CAN-ID may be in use";
        SdoClients: Compatible, "clients that do not know its parameters do not access them";
        Firmware: Compatible, "generated code has more names";
    }
    summary: "a PDO is added",
    checks: "Whether the new description has a PDO, described or implied by `CompactPDO`, that the old one does not have.",
    example: "`[1801]` and `[1A01]` are only in the new description",
    remedy: "Check that its CAN-ID is free if it is valid by default.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "change/pdo-removed" = PDO_REMOVED {
        Configurations: Breaking, "the device refuses the download of its parameters with abort code 06020000h";
        PdoConsumers: Breaking, "the frame is not sent or not received any more";
        SdoClients: Breaking, "each access to its parameters is refused with abort code 06020000h";
        Firmware: Breaking, "the names of the PDO are gone from generated code";
    }
    summary: "a PDO is removed",
    checks: "Whether a PDO of the old description, described or implied by `CompactPDO`, is missing in the new one.",
    example: "`[1801]` and `[1A01]` are only in the old description",
    remedy: "Keep the PDO, or raise the major part of the revision number.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",

    "change/pdo-mapping-changed" = PDO_MAPPING_CHANGED {
        Configurations: Risky, "a stored configuration that has only what differs from the defaults leaves the new mapping";
        PdoConsumers: Breaking, "the frame has other data, or another length";
        SdoClients: Compatible, "the mapped entries are accessed in the same way";
        Firmware: Risky, "generated structures of the PDO have other members";
    }
    summary: "a PDO has another mapping",
    checks: "Whether other entries, other lengths or another order are mapped, after configuration. A mapped object that moved is the same one.",
    example: "TPDO 1: Statusword (16 bits) → Statusword, Position actual value (48 bits)",
    remedy: "Keep the mapping, and map new entries to another PDO.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "change/pdo-cob-id-changed" = PDO_COB_ID_CHANGED {
        Configurations: Risky, "a stored configuration that has only what differs from the defaults leaves the new CAN-ID";
        PdoConsumers: Breaking, "consumers and producers use another CAN-ID";
        SdoClients: Compatible, "the parameter is accessed in the same way";
        Firmware: Compatible, "names and types stay";
    }
    summary: "a PDO has another CAN-ID",
    checks: "Whether the CAN-ID of a PDO that is valid in the old description is another one, after configuration.",
    example: "`DefaultValue=$NODEID+0x180`, then `DefaultValue=$NODEID+0x1C0`",
    remedy: "Keep the CAN-ID.",

    "change/pdo-disabled" = PDO_DISABLED {
        Configurations: Risky, "a stored configuration that does not write the COB-ID leaves the PDO not valid";
        PdoConsumers: Breaking, "the frame is not sent or not received until a manager makes the PDO valid";
        SdoClients: Compatible, "the parameter is accessed in the same way";
    }
    summary: "a PDO is not valid any more",
    checks: "Whether bit 31 of the COB-ID is clear in the old description and set in the new one, after configuration.",
    example: "`DefaultValue=$NODEID+0x180`, then `DefaultValue=$NODEID+0x80000180`",
    remedy: "Keep the PDO valid.",

    "change/pdo-enabled" = PDO_ENABLED {
        Configurations: Risky, "a stored configuration that does not write the COB-ID leaves the PDO valid";
        PdoConsumers: Risky, "the device uses a CAN-ID that it did not use";
        SdoClients: Compatible, "the parameter is accessed in the same way";
    }
    summary: "a PDO is valid that was not",
    checks: "Whether bit 31 of the COB-ID is set in the old description and clear in the new one, after configuration.",
    example: "`DefaultValue=$NODEID+0x80000180`, then `DefaultValue=$NODEID+0x180`",
    remedy: "Check that the CAN-ID is free in existing networks, and that the bus has room for the frames.",

    "change/pdo-transmission-changed" = PDO_TRANSMISSION_CHANGED {
        Configurations: Risky, "a stored configuration that has only what differs from the defaults leaves the new transmission";
        PdoConsumers: Risky, "the frame comes at other times";
        SdoClients: Compatible, "the parameter is accessed in the same way";
        Firmware: Compatible, "names and types stay";
    }
    summary: "a PDO is sent at other times",
    checks: "Whether the transmission type, inhibit time, event timer, SYNC start value or the permission of RTR is another one, after configuration.",
    example: "transmission type 254, then 1",
    remedy: "Keep the transmission parameters.",

    "change/cob-id-changed" = COB_ID_CHANGED {
        Configurations: Risky, "a stored configuration that has only what differs from the defaults leaves the new CAN-ID";
        PdoConsumers: Compatible, "PDOs have their own CAN-IDs";
        SdoClients: Breaking, "SYNC, EMCY, TIME, SDO or SRDO frames have another CAN-ID";
        Firmware: Compatible, "names and types stay";
    }
    summary: "a service has another CAN-ID",
    checks: "Whether the value of 1005h, 1012h or 1014h, of a COB-ID of an SDO (1200h to 12FFh) or of an SRDO (1301h to 1340h) is another one, after configuration.",
    example: "`DefaultValue=$NODEID+0x80` of 1014h, then `DefaultValue=$NODEID+0x90`",
    remedy: "Keep the CAN-ID.",
    source: "CiA 301 §7.3.5",
}
