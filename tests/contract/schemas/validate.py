"""validate.py SCHEMA FILE...: says where files break a JSON Schema of draft 7, one line a fault.

Ends with 0 when every file follows it, 1 when one does not, 77 when this Python has no jsonschema.
"""

import json
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)


def refuse(word):
    raise ValueError(word + " is no JSON")


def faults(validator, path):
    with open(path, encoding="utf-8") as file:
        contents = json.load(file, parse_constant=refuse)
    for error in validator.iter_errors(contents):
        place = "/".join(str(step) for step in error.absolute_path)
        yield f"{path}: /{place}: {error.message[:200]}"


def main(schema_path, *paths):
    with open(schema_path, encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    found = [fault for path in paths for fault in faults(validator, path)]
    print("\n".join(found))
    return 1 if found else 0


sys.exit(main(*sys.argv[1:]))
