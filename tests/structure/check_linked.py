#!/usr/bin/env python3
"""No app loads rival solvers at its start: Ipopt and NLopt are modules that are loaded when one of their solvers is asked
for. Takes the paths of the apps."""
import re
import subprocess
import sys

RIVALS = re.compile(r"ipopt|nlopt|libcoin|dmumps", re.I)


def rivals_in(listing):
    """Shared libraries of rivals among the lines of ldd."""
    return sorted({word for word in re.findall(r"^\s*(\S+)", listing, re.M) if RIVALS.search(word)})


def main():
    faults = []
    for app in sys.argv[1:]:
        listing = subprocess.run(["ldd", app], capture_output=True, text=True, check=True).stdout
        faults += [f"{app} loads {name} at its start" for name in rivals_in(listing)]
    print("\n".join(faults) or f"none of {len(sys.argv) - 1} apps loads a rival's library at its start")
    return 1 if faults or len(sys.argv) < 2 else 0


if __name__ == "__main__":
    sys.exit(main())
