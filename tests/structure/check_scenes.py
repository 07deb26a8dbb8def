#!/usr/bin/env python3
"""Every scene of the repository, those in documents among them, is valid by the published schema.

Scenes without "schema" are older ones, which programs bring up to it, and are left out.
"""
import json
import re
import sys

import libraries

SKIPPED = 77  # SKIP_RETURN_CODE

try:
    import jsonschema
except ImportError:
    print("the Python module jsonschema is not installed")
    sys.exit(SKIPPED)


def without_comments(text):
    """The text without // comments, which do not occur inside of its strings but in addresses."""
    return re.sub(r"(?<!:)//[^\n]*", "", text)


def scenes():
    for file in sorted((libraries.ROOT / "apps").glob("*/scenes/*.json")):
        yield str(file.relative_to(libraries.ROOT)), file.read_text()
    for file in sorted([*(libraries.ROOT / "docs").glob("**/*.md"), *(libraries.ROOT / "libs").glob("*/README.md"),
                        libraries.ROOT / "README.md"]):
        for number, block in enumerate(re.findall(r"```json\n(.*?)\n```", file.read_text(), re.DOTALL), start=1):
            yield f"{file.relative_to(libraries.ROOT)}, block {number}", block


def main():
    schema = json.loads((libraries.ROOT / "libs/scene/scene.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults, checked = [], 0
    for name, text in scenes():
        scene = json.loads(without_comments(text))
        if not isinstance(scene, dict) or "schema" not in scene:
            if name.startswith("apps/"):
                faults.append(f"{name}: has no \"schema\"")
            continue
        checked += 1
        faults += [f"{name}: {'.'.join(map(str, e.absolute_path))}: {e.message}" for e in validator.iter_errors(scene)]
    if not any(validator.iter_errors({"schema": 1, "newton": {"armijo": 0.7}})):
        faults.append("the schema takes an option that is out of its range")
    print("\n".join(faults) if faults else f"{checked} scenes are valid by the schema")
    return 1 if faults or checked < 16 else 0


if __name__ == "__main__":
    sys.exit(main())
