#!/usr/bin/env python3
"""The API reference has every public symbol: Doxygen makes it of the headers without a warning.

check_reference.py DOXYGEN DOXYFILE     DOXYGEN may be empty or end in NOTFOUND: the check is skipped
"""
import pathlib
import re
import subprocess
import sys

import libraries

SKIPPED = 77
PAGES = libraries.ROOT / "docs" / "reference" / "pages.dox"
WARNING = re.compile(r"^(/[^:]+|<[^>]+>):(\d+): (?:warning|error): (.*)$")
# First words that do not stand alone: tools show one symbol at a time.
FRAGMENT = re.compile(r"^\s*///<? +((?:what|of|likewise|the same|as above|and back)\b.*)", re.IGNORECASE)


def relative(path):
    root = str(libraries.ROOT) + "/"
    return path[len(root):] if path.startswith(root) else path


def read_warnings(text):
    """Lines of Doxygen's log, paths from the root of the project."""
    return [f"{relative(match.group(1))}:{match.group(2)}: {match.group(3)}" if (match := WARNING.match(line)) else line
            for line in text.splitlines()]


def fragments(text):
    """(line number, comment) of comments whose first words do not stand alone; only the first line of a block counts."""
    found, lines = [], text.splitlines()
    for number, line in enumerate(lines, 1):
        match = FRAGMENT.match(line) or FRAGMENT.match(re.sub(r"^.*;\s*(///< )", r"\1", line))
        begins = "///<" in line or number == 1 or not lines[number - 2].strip().startswith("///")
        if match and begins:
            found.append((number, match.group(1)))
    return found


def undocumented_namespaces(headers, pages):
    """Doxygen says nothing of what is in a namespace that nobody documents."""
    opened = {name for text in headers for name in re.findall(r"^namespace (isostretch[\w:]*) \{", text, re.MULTILINE)}
    return sorted(name for name in opened - set(re.findall(r"@namespace ([\w:]+)", pages)) if "ISOSTRETCH" not in name)


def run_doxygen(doxygen, doxyfile):
    output = subprocess.run([doxygen, str(doxyfile)], capture_output=True, text=True, cwd=libraries.ROOT)
    if output.returncode != 0:
        sys.exit(f"{doxygen} failed:\n{output.stdout}{output.stderr}")
    return (doxyfile.parent / "warnings.txt").read_text()


def main():
    doxygen, doxyfile = sys.argv[1], pathlib.Path(sys.argv[2])
    if not doxygen or doxygen.endswith("NOTFOUND"):
        print("doxygen is not installed (tools/setup installs it): skipped")
        return SKIPPED
    headers = {str(path.relative_to(libraries.ROOT)): path.read_text() for folder in libraries.folders().values()
               for path in libraries.sources(folder, "include")}
    faults = [f"docs/reference/pages.dox: @namespace {name} is missing, so nothing in it is looked at"
              for name in undocumented_namespaces(headers.values(), PAGES.read_text())]
    faults += [f'{path}:{number}: "{comment}" does not stand alone'
               for path, text in headers.items() for number, comment in fragments(text)]
    faults += read_warnings(run_doxygen(doxygen, doxyfile))
    print("\n".join(faults) or f"{len(headers)} public headers are in the reference without a warning")
    return 1 if faults or not headers else 0


if __name__ == "__main__":
    sys.exit(main())
