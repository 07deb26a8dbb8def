#!/usr/bin/env python3
"""No library prints or ends the program: results are return values, Error and the log sink."""
import re
import sys

import libraries

FORBIDDEN = [
    (re.compile(r"\bstd::(cout|cerr|clog|print|println)\b"), "prints"),
    (re.compile(r"(?<![\w.>])(std::)?(printf|vprintf|puts|putchar|perror)\s*\("), "prints"),
    (re.compile(r"(?<![\w.>])(std::)?v?fprintf\s*\(\s*(stdout|stderr)\b"), "prints"),
    (re.compile(r"(?<![\w.>])(std::)?f(puts|putc|write)\s*\([^;]*\b(stdout|stderr)\b"), "prints"),
    (re.compile(r"(?<![\w.>])(std::)?(exit|_exit|_Exit|quick_exit|abort|terminate|raise)\s*\("), "ends the program"),
    (re.compile(r"(?<![\w.>])assert\s*\("), "asserts: throw Error, or leave it to a test"),
    (re.compile(r"#\s*include\s*<iostream>"), "includes <iostream>"),
]


def faults_in(text):
    """(line number, fault) of every forbidden line."""
    found = []
    for number, line in enumerate(libraries.without_comments_and_strings(text).splitlines(), 1):
        found += [(number, what) for pattern, what in FORBIDDEN if pattern.search(line)]
    return found


def main():
    faults, count = [], 0
    for folder in libraries.folders().values():
        for path in libraries.sources(folder, "include", "src"):
            count += 1
            faults += [f"{path.relative_to(libraries.ROOT)}:{number}: {what}"
                       for number, what in faults_in(path.read_text())]
    print("\n".join(faults) or f"{count} library files print nothing and end nothing")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
