#!/usr/bin/env python3
"""Runs an app once on a tiny input: it must end well and write its summary. What sanitizers see of an app in few seconds.

smoke.py <app, without "isostretch-"> <its program>
"""
import json
import pathlib
import subprocess
import sys
import tempfile

CELLS = 4


def write_grid(path, place):
    """A square of triangles, its corners where `place` puts the points of [0, 1]^2."""
    lines = []
    for i in range(CELLS + 1):
        for j in range(CELLS + 1):
            lines.append("v %r %r %r" % place(i / CELLS, j / CELLS))
    for i in range(CELLS):
        for j in range(CELLS):
            a = 1 + i * (CELLS + 1) + j
            b = a + CELLS + 1
            lines += [f"f {a} {b} {b + 1}", f"f {a} {b + 1} {a + 1}"]
    path.write_text("\n".join(lines) + "\n")
    return str(path)


def command_of(app, folder):
    """Returns the arguments, but for the folder of results."""
    def flat():
        return write_grid(folder / "flat.obj", lambda x, y: (x, y, 0.0))

    def curved():
        return write_grid(folder / "curved.obj", lambda x, y: (x, y, 0.6 * x * (1 - x) + 0.4 * y * y))

    handles = ["--handle", "slab:x,min,0.1", "--handle", "slab:x,max,0.1;translate=0.2,0.3;rotate=40"]
    return {
        "parameterize": lambda: [curved()],
        "deform": lambda: [flat(), *handles, "--frames", "2"],
        "interpolate": lambda: [flat(), write_grid(folder / "sheared.obj", lambda x, y: (x + 0.7 * y, 1.2 * y, 0.0)),
                                "--frames", "3"],
        "manipulate": lambda: [flat(), *handles],
        "compare": lambda: [curved(), "--energy", "symmetric_dirichlet", "--method", "isostretch", "--repetitions", "1"],
        "energy": lambda: ["arap"],
    }[app]()


def main():
    app, program = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="isostretch-smoke-") as name:
        folder = pathlib.Path(name)
        run = subprocess.run([program, *command_of(app, folder), "--out", str(folder / "out")], capture_output=True, text=True)
        sys.stdout.write(run.stdout)
        sys.stderr.write(run.stderr)
        if run.returncode != 0:
            sys.exit(f"{app} ended with {run.returncode}")
        summaries = [path for path in (folder / "out").rglob("*.json") if json.loads(path.read_text())]
        if not summaries:
            sys.exit(f"{app} wrote no summary")


if __name__ == "__main__":
    main()
