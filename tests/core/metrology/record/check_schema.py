#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks records against the schema that is installed: check_schema.py SCHEMA [--strict] RECORD...

--strict: no object may have a member that the schema does not name, so that whatever this version
writes is described. Ends with 77 when python3-jsonschema is not installed."""
import json
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)


def close(schema):
    if isinstance(schema, dict):
        if schema.get("type") == "object" and "properties" in schema:
            schema["additionalProperties"] = False
        for part in schema.values():
            close(part)
    elif isinstance(schema, list):
        for part in schema:
            close(part)


def main():
    arguments = sys.argv[1:]
    is_strict = "--strict" in arguments
    path, *records = [argument for argument in arguments if argument != "--strict"]
    with open(path, encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    if is_strict:
        close(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults = 0
    for record in records:
        with open(record, encoding="utf-8") as file:
            for error in validator.iter_errors(json.load(file)):
                faults += 1
                print(f"{record}: {error.json_path}: {error.message}", file=sys.stderr)
    sys.exit(1 if faults else 0)


main()
