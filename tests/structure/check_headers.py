#!/usr/bin/env python3
"""Every public header compiles on its own.

check_headers.py --compiler c++ --jobs 2 --generated <build>/libs/core/include [--flag=-march=x86-64-v4 ...]

Not every one is compiled by itself, which would take minutes. The header that another one includes before anything else
stands at the head of that file, so compiling the other one proves both. And Eigen is read once, by a precompiled header, for
the headers that reach it by their own #include lines: the others are compiled without it.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

import libraries

PRECOMPILED = ("Eigen/Dense", "Eigen/Core")  # the larger one first


def first_include(text):
    """The header that stands before all else in a file; None where it is none of ours, or something comes before it."""
    for line in libraries.without_comments_and_strings(text).splitlines():
        if not line.strip() or re.match(r"\s*#\s*pragma\s+once\b", line):
            continue
        match = re.match(r"\s*#\s*include\s*<(isostretch/[^>]+)>", line)
        return match.group(1) if match else None
    return None


def proven_by_others(texts):
    """Headers that stand first in another one."""
    return {first for text in texts.values() if (first := first_include(text)) in texts}


def reached(header, texts):
    """All that a header includes, directly and through headers of ours."""
    found, todo = set(), [header]
    while todo:
        for _, name, _ in libraries.includes(texts[todo.pop()]):
            if name not in found:
                found.add(name)
                if name in texts:
                    todo.append(name)
    return found


def precompiled_for(header, texts):
    names = reached(header, texts)
    return next((name for name in PRECOMPILED if name in names), None)


def precompile(name, folder, command):
    """Options that take the precompiled header."""
    file = folder / (name.replace("/", "_") + ".hpp")
    file.write_text(f"#include <{name}>\n")
    subprocess.run(command + ["-x", "c++-header", str(file), "-o", f"{file}.gch"], check=True)
    return ["-include", str(file)]


def compile_header(header, command):
    source = f"#include <{header}>\n#include <{header}>\n"
    result = subprocess.run(command + ["-fsyntax-only", "-x", "c++", "-"], input=source, capture_output=True, text=True)
    return header, result.returncode, result.stderr


def read_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--generated", action="append", default=[], help="include directory made by the build")
    parser.add_argument("--system", action="append", default=[], help="include directory of a third party")
    parser.add_argument("--flag", action="append", default=[])
    return parser.parse_args()


def main():
    arguments = read_arguments()
    include_dirs = [folder / "include" for folder in libraries.folders().values()]
    texts = {str(path.relative_to(directory)): path.read_text() for directory in include_dirs
             for path in directory.rglob("*.hpp")}
    command = [arguments.compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror"] + arguments.flag
    command += [f"-I{path}" for path in include_dirs + arguments.generated]
    for path in arguments.system:
        command += ["-isystem", path]

    compiled = sorted(set(texts) - proven_by_others(texts))
    failures = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        options = {None: []} | {name: precompile(name, pathlib.Path(folder), command) for name in PRECOMPILED}
        for header, code, errors in pool.map(
                lambda h: compile_header(h, command + options[precompiled_for(h, texts)]), compiled):
            if code:
                failures += 1
                print(f"{header} does not compile on its own:\n{errors}")
    print(f"{len(texts)} public headers, {len(compiled)} of them compiled by themselves: {failures} do not stand alone")
    return 1 if failures or not texts else 0


if __name__ == "__main__":
    sys.exit(main())
