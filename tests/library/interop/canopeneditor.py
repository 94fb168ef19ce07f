"""Reads projects of CANopenEditor with protobuf, and writes them again as it does: without default values.

usage: canopeneditor.py FOLDER

The description of the message is made here. FOLDER holds projects; `a.again.json` is written next to each `a.json`. Prints the number
of objects and sub-objects of each; a file that protobuf refuses is an exception.
"""

import pathlib
import sys

from google.protobuf import descriptor_pb2, descriptor_pool, json_format, message_factory
from google.protobuf import timestamp_pb2

FIELD = descriptor_pb2.FieldDescriptorProto
KINDS = {"string": FIELD.TYPE_STRING, "bool": FIELD.TYPE_BOOL, "uint32": FIELD.TYPE_UINT32}
BAUD_RATES = zip((10, 20, 50, 125, 250, 500, 800, 1000, "Auto"), range(100, 109))
TYPES = "UNSPECIFIED BOOLEAN INTEGER8 INTEGER16 INTEGER32 UNSIGNED8 UNSIGNED16 UNSIGNED32 REAL32 VISIBLE_STRING OCTET_STRING"
TYPES += " UNICODE_STRING TIME_OF_DAY TIME_DIFFERENCE - DOMAIN INTEGER24 REAL64 INTEGER40 INTEGER48 INTEGER56 INTEGER64 UNSIGNED24"
TYPES += " - UNSIGNED40 UNSIGNED48 UNSIGNED56 UNSIGNED64"
ENUMS = {
    "DataType": list(enumerate(TYPES.split())),
    "AccessSDO": list(enumerate(f"ACCESS_SDO_{word}" for word in ("NO", "RO", "WO", "RW"))),
    "AccessPDO": list(enumerate(f"ACCESS_PDO_{word}" for word in ("NO", "T", "R", "TR"))),
    "AccessSRDO": list(enumerate(f"ACCESS_SRDO_{word}" for word in ("NO", "TX", "RX", "TRX"))),
    "ObjectType": [(0, "OBJECT_TYPE_UNSPECIFIED")]
    + [(7 + at, f"OBJECT_TYPE_{word}") for at, word in enumerate(("VAR", "ARRAY", "RECORD"))],
}
TIME = ".google.protobuf.Timestamp"
MESSAGES = {
    "FileInfo": [("string", "fileVersion", 1), ("string", "description", 2), (TIME, "creationTime", 3),
                 ("string", "createdBy", 4), (TIME, "modificationTime", 5), ("string", "modifiedBy", 6)],
    "DeviceInfo": [("string", "vendorName", 1), ("string", "productName", 3),
                   *(("bool", f"baudRate{rate}", number) for rate, number in BAUD_RATES),
                   ("bool", "lssSlave", 150), ("bool", "lssMaster", 151)],
    "DeviceCommissioning": [("uint32", "nodeId", 1), ("string", "nodeName", 2), ("uint32", "baudrate", 3)],
    "OdSubObject": [("string", "name", 1), ("string", "alias", 2), ("DataType", "dataType", 3), ("AccessSDO", "sdo", 4),
                    ("AccessPDO", "pdo", 5), ("AccessSRDO", "srdo", 6), ("string", "defaultValue", 7),
                    ("string", "actualValue", 8), ("string", "lowLimit", 9), ("string", "highLimit", 10),
                    ("uint32", "stringLengthMin", 101)],
    "OdObject": [("bool", "disabled", 1), ("string", "name", 2), ("string", "alias", 3), ("string", "description", 4),
                 ("ObjectType", "objectType", 5), ("string", "countLabel", 101), ("string", "storageGroup", 102),
                 ("bool", "flagsPDO", 103), ("map OdSubObject", "subObjects", 200)],
    "CanOpenDevice": [(".project.FileInfo", "fileInfo", 1), (".project.DeviceInfo", "deviceInfo", 2),
                      (".project.DeviceCommissioning", "deviceCommissioning", 3), ("map OdObject", "objects", 200)],
}


def message_class():
    """The class of the message."""
    file = descriptor_pb2.FileDescriptorProto(name="project.proto", package="project", syntax="proto3")
    file.dependency.append(timestamp_pb2.DESCRIPTOR.name)
    for name, values in ENUMS.items():
        enum = file.enum_type.add(name=name)
        for number, word in values:
            if word != "-":
                enum.value.add(name=word, number=number)
    for name, fields in MESSAGES.items():
        message = file.message_type.add(name=name)
        for kind, field_name, number in fields:
            field = message.field.add(name=field_name, number=number, label=FIELD.LABEL_OPTIONAL)
            if kind in KINDS:
                field.type = KINDS[kind]
            elif kind in ENUMS:
                field.type, field.type_name = FIELD.TYPE_ENUM, f".project.{kind}"
            elif kind.startswith("map "):
                entry_name = field_name[0].upper() + field_name[1:] + "Entry"
                entry = message.nested_type.add(name=entry_name)
                entry.options.map_entry = True
                entry.field.add(name="key", number=1, label=FIELD.LABEL_OPTIONAL, type=FIELD.TYPE_STRING)
                entry.field.add(name="value", number=2, label=FIELD.LABEL_OPTIONAL, type=FIELD.TYPE_MESSAGE,
                                type_name=f".project.{kind[4:]}")
                field.label, field.type = FIELD.LABEL_REPEATED, FIELD.TYPE_MESSAGE
                field.type_name = f".project.{name}.{entry_name}"
            else:
                field.type, field.type_name = FIELD.TYPE_MESSAGE, kind
    pool = descriptor_pool.DescriptorPool()
    pool.AddSerializedFile(timestamp_pb2.DESCRIPTOR.serialized_pb)
    pool.Add(file)
    return message_factory.GetMessageClass(pool.FindMessageTypeByName("project.CanOpenDevice"))


def main():
    device_class = message_class()
    for path in sorted(pathlib.Path(sys.argv[1]).glob("*.json")):
        if path.name.endswith(".again.json"):
            continue
        device = json_format.Parse(path.read_text(encoding="utf-8"), device_class())
        # as bytes, in which nothing but the message is
        device = device_class.FromString(device.SerializeToString())
        path.with_suffix(".again.json").write_text(json_format.MessageToJson(device), encoding="utf-8")
        subs = sum(len(item.subObjects) for item in device.objects.values())
        print(path.name, len(device.objects), subs)


main()
