"""Validates networks and patches against the schema of their format; prints the names of those that it rejects.

usage: validate.py BUS.json NETWORK.json PATCH.json FILE...
"""

import json
import sys
import tomllib

import jsonschema_rs
import yaml


def keyed(value):
    """JSON has texts as keys only."""
    if isinstance(value, dict):
        return {str(key): keyed(item) for key, item in value.items()}
    return [keyed(item) for item in value] if isinstance(value, list) else value


schemas = [json.load(open(name)) for name in sys.argv[1:4]]
for schema in schemas:
    jsonschema_rs.meta.validate(schema)
bus, network, patch = map(jsonschema_rs.Draft202012Validator, schemas)
for name in sys.argv[4:]:
    is_toml = name.endswith(".toml")
    with open(name, "rb") as file:
        value = tomllib.load(file) if is_toml else yaml.safe_load(file)
    is_patch = name.endswith(".patch.toml") or "/rules/patch/" in name
    validator = patch if is_patch else network if is_toml else bus
    if not validator.is_valid(keyed(value)):
        print(name)
