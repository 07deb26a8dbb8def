#!/usr/bin/env python3
"""No library owns an Eigen matrix whose memory depends on -march.

Functions that resize, copy or free Eigen's ordinary dynamic matrices are inline, hence weak symbols, of which the linker
keeps one copy: perhaps that of a consumer compiled with -march=native, which allocates and aligns otherwise than the
library. What libraries own is `Vector` or the matrices of mesh/types.hpp, with DontAlign. Optimised builds inline most of
these functions away; the sanitizer build, which does not, tells more.

check_owned_vectors.py <build folder>
"""
import pathlib
import re
import sys

from check_kernel_symbols import demangled_symbols

# Matrix<scalar, rows, columns, options, most rows, most columns> of dynamic size whose options lack DontAlign (2), and the
# storage of such. With limits to its size it takes no memory from the heap (Eigen's stableNorm has one of up to 4096 rows).
ALIGNED_OWNER = re.compile(
    r"(?<!\w)Eigen::(PlainObjectBase<Eigen::(Matrix|Array)<[\w ]+, -1, -?\d+, [01], (-1, -?\d+|-?\d+, -1)"
    r"|PlainObjectBase<Eigen::(Matrix|Array)<[\w ]+, \d+, -1, [01], \d+, -1"
    r"|DenseStorage<[\w ]+, -1, -?\d+, -?\d+, [01]>)")


def faults_in(symbols):
    return [name for kind, name in symbols if kind in "WVu" and ALIGNED_OWNER.search(name)]


def main():
    folder = pathlib.Path(sys.argv[1]) / "libs"
    libraries = sorted(path for pattern in ("*.a", "*.so") for path in folder.rglob("libisostretch_" + pattern))
    faults = [f"{path.name}: {name}" for path in libraries for name in faults_in(demangled_symbols(path))]
    print("\n".join(faults) or f"{len(libraries)} libraries own no matrix that depends on -march")
    if not libraries:
        print("no library found: nothing was checked")
    return 1 if faults or not libraries else 0


if __name__ == "__main__":
    sys.exit(main())
