#!/usr/bin/env python3
"""The C++ of the top-level README is the snippet that tests/consumers compiles and runs."""
import re
import sys

import libraries


def main():
    source = (libraries.ROOT / "tests/consumers/project/newton.cpp").read_text()
    snippet = re.search(r"// snippet: README\n(.*?)\n *// end of snippet", source, re.DOTALL).group(1)
    lines = [line[2:] for line in snippet.splitlines()]
    readme = (libraries.ROOT / "README.md").read_text()
    blocks = re.findall(r"```cpp\n(.*?)\n```", readme, re.DOTALL)
    if "\n".join(lines) in blocks:
        print(f"README.md shows the {len(lines)} lines of tests/consumers/project/newton.cpp")
        return 0
    print("README.md has no C++ block equal to the snippet in tests/consumers/project/newton.cpp:\n" + "\n".join(lines))
    return 1


if __name__ == "__main__":
    sys.exit(main())
