"""Reads the entries of an ESI and compares them with those of the JSON that objdict writes of it: `esi.py drive.xml drive.json [DEVICE]`."""
import json, os, struct, sys
import xml.etree.ElementTree as ET

INTEGERS = {"BOOL": 1, "BIT": 1, "SINT": -8, "INT": -16, "INT24": -24, "DINT": -32, "INT40": -40, "INT48": -48, "INT56": -56, "LINT": -64,
            "USINT": 8, "BYTE": 8, "UINT": 16, "WORD": 16, "UINT24": 24, "UDINT": 32, "DWORD": 32, "UINT40": 40, "UINT48": 48,
            "UINT56": 56, "ULINT": 64, "LWORD": 64}
NAMES = {1: "BOOLEAN", **{bits: f"UNSIGNED{bits}" for bits in range(8, 65, 8)}, **{-bits: f"INTEGER{bits}" for bits in range(8, 65, 8)}}
OTHERS = ("VISIBLE_STRING", "OCTET_STRING", "UNICODE_STRING", "REAL32", "REAL64", *NAMES.values())


def text(of, path):
    found = of.findall(path)
    found = [one for one in found if one.get("LcId") in (None, "1033")] or found
    return " ".join((found[0].text or "").split()) if found else ""


def number(string):
    return int(string[2:], 16) if string.startswith("#x") else int(string)


def kind(types, name):
    """The type of a name in CANopen."""
    for _ in range(20):
        word = name.split("(")[0]
        if word in INTEGERS:
            return NAMES[INTEGERS[word]]
        if word in ("REAL", "LREAL", "STRING", "WSTRING"):
            return {"REAL": "REAL32", "LREAL": "REAL64", "STRING": "VISIBLE_STRING", "WSTRING": "UNICODE_STRING"}[word]
        if name.startswith("ARRAY"):
            return "UNICODE_STRING" if name.endswith(" UINT") else "OCTET_STRING"
        if word in OTHERS:
            return word
        base = text(types[name], "BaseType")
        if not base:
            bits = number(text(types[name], "BitSize"))
            return "BOOLEAN" if bits == 1 else NAMES.get((bits + 7) // 8 * 8, "OCTET_STRING")
        name = base


def value(parts, stem, of):
    """The value of an entry: what its object says, else its type."""
    for part in parts:
        for tag in (stem + "Data", stem + "Value", stem + "String"):
            found = part.find(tag) if part is not None else None
            if found is None:
                continue
            string = (found.text or "").strip()
            if tag.endswith("Data"):
                data = bytes.fromhex(string)
                if of == "VISIBLE_STRING":
                    return data.rstrip(b"\0").decode()
                if of == "OCTET_STRING":
                    return data.hex().upper()
                if of.startswith("REAL"):
                    return data.hex()
                return int.from_bytes(data, "little", signed=of.startswith("INTEGER"))
            if of.endswith("STRING"):
                return found.text or ""
            if of.startswith("REAL"):
                return real(of, string)
            found = number(string)
            bits = int("".join(filter(str.isdigit, of)) or 1)
            return found - (1 << bits) if of.startswith("INTEGER") and found >> (bits - 1) == 1 else found
    return None


def flag(item, obj, name, default):
    for of in (item, obj):
        found = text(of, "Flags/" + name)
        if found:
            return found.lower()
    return default


def entry(types, obj, item, type_name, name, info):
    of = kind(types, type_name)
    mapping = {"": "no", "r": "rpdo", "t": "tpdo", "rt": "optional", "tr": "optional"}[flag(item, obj, "PdoMapping", "")]
    access = flag(item, obj, "Access", "ro")
    access = {("rw", "rpdo"): "rww", ("rw", "tpdo"): "rwr"}.get((access, mapping), access)
    values = [value([info, item], stem, of) for stem in ("Default", "Min", "Max")]
    flags = [flag(item, obj, "Category", "o"), flag(item, obj, "Backup", "0") == "1"]
    return [name, of, access, mapping, *values, enumeration(types, type_name), *flags]


def enumeration(types, name):
    """The names of values of the nearest type that has some."""
    while name in types:
        if types[name].find("EnumInfo") is not None:
            return [(text(one, "Enum"), text(one, "Text")) for one in types[name].findall("EnumInfo")]
        name = text(types[name], "BaseType")
    return []


def dictionary(of):
    types = {text(one, "Name"): one for one in of.findall("DataTypes/DataType")}
    entries = {}
    for obj in of.findall("Objects/Object"):
        index, type_name = number(text(obj, "Index").lower()), text(obj, "Type")
        record = types.get(type_name)
        if record is None or record.find("SubItem") is None:
            entries[index, None] = entry(types, obj, obj, type_name, text(obj, "Name"), obj.find("Info"))
            continue
        members, sub = [], 0
        for item in record.findall("SubItem"):
            array = types.get(text(item, "Type"))
            if array is not None and array.find("ArrayInfo") is not None and not text(item, "Type").startswith("ARRAY"):
                first = max(number(text(array, "ArrayInfo/LBound")), sub, 1)
                first = number(text(item, "SubIdx") or str(first))
                sub = first + number(text(array, "ArrayInfo/Elements"))
                members += [(at, None, text(array, "BaseType"), item) for at in range(first, sub)]
            else:
                sub = number(text(item, "SubIdx") or str(sub))
                members.append((sub, text(item, "Name"), text(item, "Type"), item))
                sub += 1
        infos = obj.findall("Info/SubItem")
        by_name = {text(info, "Name").lower(): info for info in infos}
        for at, (sub, name, type_name, item) in enumerate(members):
            numbered = f"SubIndex {sub:03}"
            info = infos[at] if len(infos) == len(members) else by_name.get((name or numbered).lower())
            stated = text(info, "Name") if info is not None and name is None else numbered
            entries[index, sub] = entry(types, obj, item, type_name, name or stated, None if info is None else info.find("Info"))
    return entries


def pdos(device, entries):
    for pdo in [one for one in device if one.tag in ("RxPdo", "TxPdo")]:
        index = number(text(pdo, "Index").lower())
        mapped = [((number(text(one, "Index").lower()) << 16) | (number(text(one, "SubIndex") or "0") << 8) | number(text(one, "BitLen")),
                   text(one, "Name")) for one in pdo.findall("Entry")]
        values = {0: (len(mapped), "SubIndex 000"), **{at: one for at, one in enumerate(mapped, 1)}}
        is_new = not any(at == index for at, _ in entries)
        for sub, (stated, name) in values.items():
            if is_new:
                entries[index, sub] = [name, "UNSIGNED32" if sub else "UNSIGNED8", "ro", "no", stated, None, None, [], "o", False]
            elif (index, sub) in entries and entries[index, sub][4] is None:
                entries[index, sub][4] = stated


def real(of, string):
    """The bits of a REAL."""
    data = bytes.fromhex(string[2:])[::-1] if string.startswith("0x") else struct.pack("<f" if of == "REAL32" else "<d", float(string))
    return data.hex()


def plain(of):
    """The value of an entry in JSON."""
    if isinstance(of, dict) and list(of)[0].startswith("real"):
        return real(list(of)[0].upper(), str(list(of.values())[0]))
    return of["value"] if isinstance(of, dict) else of


def main(esi, written, number_of_device=1):
    device = ET.parse(esi).getroot().findall("Descriptions/Devices/Device")[int(number_of_device) - 1]
    expected = {}
    for of in device.findall("Profile/Dictionary"):
        expected.update(dictionary(of))
    for named in device.findall("Profile/DictionaryFile"):
        expected.update(dictionary(ET.parse(os.path.join(os.path.dirname(esi), named.text.strip())).getroot().find("Dictionary")))
    pdos(device, expected)
    found = {}
    for index, obj in json.load(open(written, encoding="utf-8"))["device"]["objects"].items():
        subs = obj.get("subs", {})
        for sub, of in subs.items() if subs else [(None, obj)]:
            at = int(index, 16), None if sub is None else int(sub, 16)
            keys = ("name", "data_type", "access", "pdo_mapping", "default", "low_limit", "high_limit")
            parameter = of.get("parameter", {})
            named = [(one["value"], one["labels"][0]["name"]["text"]) for one in parameter.get("allowed_values", {}).get("values", [])]
            flags = [parameter.get("support", "o")[0], parameter.get("persistent", False)]
            found[at] = [*(plain(of.get(key)) for key in keys), named, *flags]
    differences = [(at, expected.get(at), found.get(at)) for at in sorted(expected.keys() | found.keys(), key=str) if expected.get(at) != found.get(at)]
    for at, one, other in differences[:20]:
        print(at, "ESI:", one, "objdict:", other)
    print(f"{len(expected)} entries, {len(differences)} differences")


main(*sys.argv[1:])
