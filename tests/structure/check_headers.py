#!/usr/bin/env python3
"""Every public header compiles on its own, and twice in one file.

check_headers.py --compiler c++ --jobs 2 --generated <build>/libs/core/include [--flag=-march=x86-64-v4 ...]
"""
import argparse
import concurrent.futures
import subprocess
import sys

import libraries


def compile_header(header, command):
    source = f"#include <{header}>\n#include <{header}>\n"
    result = subprocess.run(command + ["-x", "c++", "-"], input=source, capture_output=True, text=True)
    return header, result.returncode, result.stderr


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--generated", action="append", default=[], help="include directory made by the build")
    parser.add_argument("--system", action="append", default=[], help="include directory of a third party")
    parser.add_argument("--flag", action="append", default=[])
    arguments = parser.parse_args()

    include_dirs = [folder / "include" for folder in libraries.folders().values()]
    headers = sorted(str(path.relative_to(directory)) for directory in include_dirs
                     for path in directory.rglob("*.hpp"))
    command = [arguments.compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror"] + arguments.flag
    command += [f"-I{path}" for path in include_dirs + arguments.generated]
    for path in arguments.system:
        command += ["-isystem", path]

    failures = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for header, code, errors in pool.map(lambda h: compile_header(h, command), headers):
            if code:
                failures += 1
                print(f"{header} does not compile on its own:\n{errors}")
    print(f"{len(headers) - failures} of {len(headers)} public headers compile on their own")
    return 1 if failures or not headers else 0


if __name__ == "__main__":
    sys.exit(main())
