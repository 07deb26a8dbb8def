#!/usr/bin/env python3
"""Kernel objects compiled for an instruction-set level define nothing outside a namespace of that level.

An inline function that a kernel file shares with plain code would be a weak symbol in both, and the linker keeps one
copy for everybody: the AVX-512 one, perhaps, on a machine without AVX-512. Every weak or global symbol defined in
kernels/<file>.<level>.cpp.o must therefore carry the level in its demangled name: a namespace `v4` or `kernels_v4`.

check_kernel_symbols.py <build folder>
"""
import pathlib
import re
import subprocess
import sys

LEVELS = ("v2", "v3", "v4")
# Defined for other objects: text, data, read-only, bss and common symbols, weak ones, unique ones. Lower case is local.
SHARED = "TDRBCSVWuvw"


def demangled_symbols(path):
    output = subprocess.run(["nm", "-C", "--defined-only", str(path)], capture_output=True, text=True, check=True).stdout
    symbols = []
    for line in output.splitlines():
        match = re.match(r"[0-9a-f]*\s+([A-Za-z])\s+(.*)", line)
        if match and match.group(1) in SHARED:
            symbols.append((match.group(1), match.group(2)))
    return symbols


def belongs_to(level, name):
    """Whether the function or object itself, not just one of its argument types, lives in the level's namespace or is
    a template over something of that level: either makes the symbol the level's own."""
    return re.search(rf"\b(kernels_)?{level}::", name) is not None


def main():
    objects = [path for path in sorted(pathlib.Path(sys.argv[1]).rglob("*.o")) if path.parent.name == "kernels"]
    checked, faults = 0, []
    for path in objects:
        level = re.search(r"\.(base|v2|v3|v4)\.cpp\.o$", path.name)
        if not level or level.group(1) not in LEVELS:
            continue
        checked += 1
        faults += [f"{path.name}: {kind} {name}" for kind, name in demangled_symbols(path)
                   if not belongs_to(level.group(1), name)]
    print("\n".join(faults) or f"{checked} kernel objects define only symbols of their level")
    if checked == 0:
        print("no kernel object of a level found: nothing was checked")
    return 1 if faults or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
