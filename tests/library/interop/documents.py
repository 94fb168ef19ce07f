"""Validates documents against their schemas; prints the errors.

usage: documents.py FOLDER

FOLDER has NAME.schema.json for each document, and the documents themselves as NAME.….json or NAME/….json.
"""

import itertools
import json
import pathlib
import sys

import jsonschema_rs


def objects(value, path=()):
    """The objects in a document, without those that are data of any kind."""
    if isinstance(value, dict):
        yield path, value
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        if key not in ("losses", "value", "becomes") or isinstance(key, int):
            yield from objects(item, (*path, key))


def open_objects(validator, document):
    """Where a field that the schema does not know is accepted: nowhere."""
    for path, item in itertools.islice(objects(document), 40):
        item["undocumented"] = []
        if validator.is_valid(document):
            yield path
        del item["undocumented"]


folder = pathlib.Path(sys.argv[1])
for path in sorted(folder.glob("*.schema.json")):
    name = path.name.removesuffix(".schema.json")
    schema = json.loads(path.read_text("utf-8"))
    jsonschema_rs.meta.validate(schema)
    validator = jsonschema_rs.Draft202012Validator(schema)
    documents = [path for path in folder.glob(f"{name}.*.json") if not path.name.endswith(".schema.json")]
    documents = sorted([*documents, *folder.glob(f"{name}/*.json")])
    if documents:
        smallest = min(documents, key=lambda path: path.stat().st_size)
        for path in open_objects(validator, json.loads(smallest.read_text("utf-8"))):
            print(f"{name}: {path} accepts any field")
    else:
        print(f"{name}: no document")
    for each in documents:
        document = json.loads(each.read_text("utf-8"))
        for error in itertools.islice(validator.iter_errors(document), 3):
            place = "/".join(map(str, error.instance_path))
            print(f"{each.relative_to(folder)}: {place}: {error.message[:500]}")
    print(f"{name}: {len(documents)} valid", file=sys.stderr)
