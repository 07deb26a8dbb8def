#!/usr/bin/env python3
"""Files hold one idea and apps stay small: no source file is longer than 400 lines, and apps hold what their limits say."""
import sys

import libraries

FILE_LINES = 400
APP_LINES = {"common": 1500, "isostretch-compare": 1000}
OTHER_APP_LINES = 600
SUFFIXES = (".cpp", ".hpp", ".inc", ".py", ".sh")


def line_count(path):
    return len(path.read_text().splitlines())


def long_files(root):
    files = [path for part in ("libs", "apps", "tests", "tools") for path in sorted((root / part).rglob("*"))
             if path.is_file() and path.suffix in SUFFIXES]
    faults = [f"{path.relative_to(root)} has {line_count(path)} lines, more than {FILE_LINES}"
              for path in files if line_count(path) > FILE_LINES]
    return faults, len(files)


def large_apps(root):
    faults = []
    for folder in sorted(path for path in (root / "apps").iterdir() if path.is_dir()):
        lines = sum(line_count(path) for path in folder.glob("*.?pp"))
        limit = APP_LINES.get(folder.name, OTHER_APP_LINES)
        if lines > limit:
            faults.append(f"apps/{folder.name} has {lines} lines of its own, more than {limit}: move algorithms, "
                          "reports and pictures to libraries")
    return faults


def main():
    faults, count = long_files(libraries.ROOT)
    faults += large_apps(libraries.ROOT)
    print("\n".join(faults) or f"{count} files and all apps are within their limits")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
