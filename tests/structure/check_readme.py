#!/usr/bin/env python3
"""C++ of documents is that of a snippet that tests compile and run."""
import re
import sys
import textwrap

import libraries

# A document and the source that has its snippet, between "// snippet: <document>" and "// end of snippet".
SNIPPETS = [("libs/parameterization/README.md", "tests/consumers/project/parameterization.cpp"),
            ("libs/deformation/README.md", "tests/consumers/project/deformation.cpp"),
            ("libs/scene/README.md", "tests/consumers/project/scene.cpp"),
            ("libs/inspection/README.md", "tests/consumers/project/inspection.cpp"),
            ("libs/reports/README.md", "tests/consumers/project/reports.cpp"),
            ("README.md", "tests/consumers/project/newton.cpp"), ("README.md", "tests/apps/log_sink_test.cpp"),
            ("docs/tutorials/energies.md", "tests/consumers/project/testing.cpp")]


def shows(document, source):
    text = (libraries.ROOT / source).read_text()
    snippet = re.search(rf"// snippet: {re.escape(document)}\n(.*?)\n *// end of snippet", text, re.DOTALL).group(1)
    snippet = textwrap.dedent(snippet)
    blocks = re.findall(r"```cpp\n(.*?)\n```", (libraries.ROOT / document).read_text(), re.DOTALL)
    if snippet in blocks:
        print(f"{document} shows the {len(snippet.splitlines())} lines of {source}")
        return True
    print(f"{document} has no C++ block equal to the snippet in {source}:\n{snippet}")
    return False


def main():
    return 0 if all([shows(*pair) for pair in SNIPPETS]) else 1


if __name__ == "__main__":
    sys.exit(main())
