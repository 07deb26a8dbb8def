#!/usr/bin/env python3
"""No library includes what cmake/dependency_rules.txt does not allow, and COMPONENTS say the same as the rules."""
import re
import sys

import libraries

# Headers of the C++ standard library have neither a slash nor an extension.
STANDARD = re.compile(r"[a-z_0-9]+")


def check_includes(name, folder, rules):
    rule = rules[name]
    allowed = libraries.closure(rules, [name])
    cmake = (folder / "CMakeLists.txt").read_text()
    for_tests = libraries.closure(rules, libraries.cmake_argument(cmake, "TEST_COMPONENTS")) | allowed
    used, faults = set(), []
    for part in ("include", "src", "bench", "tests"):
        for path in libraries.sources(folder, part):
            for number, header, angled in libraries.includes(path.read_text()):
                where = f"{path.relative_to(libraries.ROOT)}:{number}"
                ours = re.match(r"isostretch/([a-z_0-9]+)/", header)
                if ours:
                    if part in ("include", "src"):
                        used.add(ours.group(1))
                    if ours.group(1) not in (for_tests if part in ("tests", "bench") else allowed):
                        faults.append(f"{where}: {name} may not include {header}")
                    if not angled:
                        faults.append(f'{where}: <{header}>, not "{header}": it is a public header')
                elif part in ("include", "src") and angled:
                    if header.startswith("Eigen/") or STANDARD.fullmatch(header):
                        continue
                    if header not in rule.headers:
                        faults.append(f"{where}: {name} may not include <{header}>")
                    elif part == "include" and header != "immintrin.h":
                        faults.append(f"{where}: <{header}> in a public header")
                elif part in ("include", "src") and ".." in header:
                    faults.append(f'{where}: "{header}" leaves its folder')
    for component in rule.components:
        if component not in used:
            faults.append(f"libs/{name}: no header of {component} is included, yet it is a direct dependency")
    return faults


def check_components(name, folder, rules):
    stated = libraries.cmake_argument((folder / "CMakeLists.txt").read_text(), "COMPONENTS")
    if sorted(stated) == sorted(rules[name].components):
        return []
    return [f"libs/{name}/CMakeLists.txt: COMPONENTS {' '.join(stated) or '(none)'}, but the rules say "
            f"{' '.join(rules[name].components) or '(none)'}"]


def check_rules(rules, folders):
    faults = [f"libs/{name} has no line in cmake/dependency_rules.txt" for name in folders if name not in rules]
    faults += [f"cmake/dependency_rules.txt: there is no libs/{name}" for name in rules if name not in folders]
    for name, rule in rules.items():
        faults += [f"cmake/dependency_rules.txt: {name} depends on {c}, which has no line"
                   for c in rule.components if c not in rules]
        if name in libraries.closure(rules, rule.components):
            faults.append(f"cmake/dependency_rules.txt: {name} depends on itself")
    return faults


def main():
    rules, folders = libraries.rules(), libraries.folders()
    faults = check_rules(rules, folders)
    if not faults:
        for name, folder in folders.items():
            faults += check_components(name, folder, rules) + check_includes(name, folder, rules)
    print("\n".join(faults) or f"{len(folders)} libraries keep to the rules")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
