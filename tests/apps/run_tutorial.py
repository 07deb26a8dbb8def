#!/usr/bin/env python3
"""Runs a tutorial as its reader would, in a folder of its own: first writes its files, ```json blocks whose first line
is // and the file's name, then runs all of its commands, ``` blocks without a language, in one shell that ends at the
first command that fails. Lines of ```text blocks must be among what they print. The apps are in the PATH."""
import pathlib
import re
import subprocess
import sys
import tempfile


def blocks(text, language):
    fences = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    return [content for name, content in fences if name == language]


def main(tutorial):
    text = pathlib.Path(tutorial).read_text()
    commands = "".join(blocks(text, ""))
    if not commands:
        print(f"{tutorial} has no commands")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        for content in blocks(text, "json"):
            head, rest = content.split("\n", 1)
            (pathlib.Path(folder) / head.removeprefix("// ")).write_text(rest)
        run = subprocess.run(["bash", "-eux", "-c", commands], cwd=folder, stdout=subprocess.PIPE, text=True)
    print(run.stdout)
    missing = [line for content in blocks(text, "text") for line in content.splitlines()
               if line not in run.stdout.splitlines() + [""]]
    for line in missing:
        print(f"not printed: {line}")
    return run.returncode or len(missing) > 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
