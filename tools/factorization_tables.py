"""Markdown of what tools/factorizations has measured."""
import statistics

import studies

NAMES = {"multifrontal": "ours", "cholmod_supernodal": "CHOLMOD", "mumps": "MUMPS", "eigen_ldlt": "Eigen LDLT"}
OURS = "multifrontal"


class Machine:
    """The peaks of the machine, and what the program was built with."""

    def __init__(self, lines):
        arithmetic = [line for line in lines if "operations_per_second" in line]
        self.compiler = next(" ".join(line["compiler"].split()) for line in lines if "compiler" in line)
        self.solvers = next(line["solvers"] for line in lines if "solvers" in line).split(", ")
        self.levels = list(dict.fromkeys(line["level"] for line in arithmetic))
        self.threads = sorted({line["threads"] for line in arithmetic})
        self.operations, self.bandwidth = {}, {}
        for line in lines:
            for rates, name, key in ((self.operations, "operations_per_second", (line.get("level"), line.get("threads"))),
                                     (self.bandwidth, "bytes_per_second", line.get("threads"))):
                if name in line:
                    rates[key] = max(rates.get(key, 0), line[name])

    def table(self):
        head = ["at best"] + [f"{n} thread{'s' if n > 1 else ''}" for n in self.threads]
        rows = [[f"{level}, GFlop/s"] + [f"{1e-9 * self.operations[level, n]:.1f}" for n in self.threads]
                for level in self.levels]
        rows.append(["triad, GB/s"] + [f"{1e-9 * self.bandwidth[n]:.1f}" for n in self.threads])
        return studies.table(head, rows)


class Measurement:
    """The medians over the rounds of one configuration."""

    def __init__(self, rows):
        self.key = rows[0]["key"]
        self.error = next((row["error"] for row in rows if "error" in row), None)
        good = [row for row in rows if "error" not in row]
        self.rounds = len(good)
        self.value = {name: statistics.median(row[name] for row in good) for name, value in (good[0] if good else {}).items()
                      if isinstance(value, (int, float))}
        self.blas = good[0]["blas_kernels"] if good else ""

    def milliseconds(self, phase):
        return 1e3 * self.value[phase + "_seconds"] if self.value else None

    def megabytes(self, name):
        return self.value[name] / 1e6 if self.value.get(name) else None

    def solver(self):
        name, kernels = NAMES[self.key["solver"]], self.key["kernels"]
        blas = f", {self.blas}" if self.blas and kernels != "none" else ""
        return name + blas + ("" if kernels in ("none", "own") else " as set")


def matrix_name(matrix):
    kind, count = matrix.split("=")
    count = int(count)
    return (f"{count / 1e6:g}M " if count >= 1e6 else f"{count / 1e3:g}k ") + kind


def number(value):
    """Three digits, as people write them."""
    if value is None:
        return "–"
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def line(row):
    """One measurement as a line for the terminal."""
    one, key = Measurement([row]), row["key"]
    start = f"{matrix_name(key['matrix']):16} {key['ordering']:5} {one.solver():24} {key['level']:4} {key['threads']} "
    if one.error:
        return start + one.error
    times = [f"{phase} {number(one.milliseconds(phase)):>5} ms  " for phase in ("factorization", "solve", "analysis")]
    return start + "".join(times) + f"peak {number(one.megabytes('peak_bytes')):>5} MB"


def measurements(rows):
    groups = {}
    for row in rows:
        if "matrix" in row["key"]:
            key = {name: value for name, value in row["key"].items() if name != "round"}
            groups.setdefault(tuple(key.items()), []).append(row)
    return [Measurement(group) for group in groups.values()]


def problems(found):
    """Measurements by matrix and ordering, with the operations that our analysis counts: all have the same order."""
    result = {}
    for one in found:
        result.setdefault((one.key["matrix"], one.key["ordering"]), []).append(one)
    for (matrix, ordering), group in result.items():
        operations = next((one.value["operations"] for one in group if one.key["solver"] == OURS and one.value), None)
        yield matrix_name(matrix), ordering.upper(), operations, group


def rate(one, operations):
    return operations / one.value["factorization_seconds"] if operations and one.value else None


def share(one, operations, machine):
    peak = machine.operations.get((one.key["level"], one.key["threads"]))
    done = rate(one, operations)
    return f"{100 * done / peak:.0f} %" if done and peak else "–"


def fastest(group, solver, wanted=lambda one: True):
    timed = [one for one in group if one.key["solver"] == solver and one.value and wanted(one)]
    return min(timed, key=lambda one: one.value["factorization_seconds"], default=None)


def overview(found, machine):
    top = machine.levels[-1]
    rows = []
    for matrix, ordering, operations, group in problems(found):
        others = [fastest(group, solver) for solver in NAMES if solver != OURS]
        one = fastest(group, OURS, lambda m: m.key["level"] == top and m.key["threads"] == 1)
        best = fastest(group, OURS, lambda m: m.key["level"] == top)
        two = fastest(group, OURS, lambda m: m.key["level"] == top and m.key["threads"] > 1)
        rival = min((other.milliseconds("factorization") for other in others if other), default=None)
        rows.append([matrix, ordering, f"{operations:.1e}" if operations else "–"]
                    + [number(other and other.milliseconds("factorization")) for other in others + [one, two]]
                    + [f"{rival / best.milliseconds('factorization'):.1f}" if rival and best else "–",
                       number(best and operations and 1e-9 * rate(best, operations)),
                       share(one, operations, machine) if one else "–",
                       " / ".join(number(m and m.milliseconds("solve")) for m in (others[0], one)),
                       " / ".join(number(m and m.megabytes("peak_bytes")) for m in (others[0], one))])
    head = ["matrix", "order", "operations"] + [NAMES[solver] for solver in NAMES if solver != OURS]
    head += ["ours, 1 thread", "ours, 2 threads", "gain", "GFlop/s at best", "share of the peak, 1 thread",
             "solve, ms: CHOLMOD / ours", "peak, MB: CHOLMOD / ours"]
    return studies.table(head, rows)


def phases(found, machine):
    rows = []
    for matrix, ordering, operations, group in problems(found):
        for one in group:
            if one.key["level"] != machine.levels[-1]:
                continue
            start = [matrix, ordering, one.solver(), str(one.key["threads"])]
            if not one.value:
                rows.append(start + [one.error] + ["–"] * 10)
                continue
            read = 16e-9 * one.value["factor_entries"] / one.value["solve_seconds"]
            rows.append(start + [number(one.milliseconds(phase)) for phase in
                                 ("ordering", "analysis", "first_factorization", "factorization", "solve", "eight_solves")]
                        + [share(one, operations, machine), number(read), number(one.megabytes("solver_bytes")),
                           number(one.megabytes("peak_bytes")), f"{one.value['residual']:.0e}"])
    return studies.table(["matrix", "order", "solver", "threads", "ordering", "analysis", "first", "factorization", "solve",
                          "8 solves", "share of the peak", "solve, GB/s", "solver, MB", "peak, MB", "residual"], rows)


def levels(found, machine):
    rows = []
    for matrix, ordering, operations, group in problems(found):
        cells = [fastest(group, OURS, lambda m, level=level: m.key["level"] == level and m.key["threads"] == 1)
                 for level in machine.levels]
        if sum(cell is not None for cell in cells) > 1:
            rows.append([matrix, ordering] + [f"{number(m.milliseconds('factorization'))} ({share(m, operations, machine)})"
                                              if m else "–" for m in cells])
    return studies.table(["matrix", "order"] + machine.levels, rows)


def tables(rows, machine):
    """The lines of the report after its head."""
    found = measurements(rows)
    rounds = max((one.rounds for one in found), default=0)
    return ["## Machine", "", machine.table(), "",
            "Multiplications and additions of registers, and STREAM's triad: the best that was met.", "",
            "## Overview", "",
            f"Milliseconds of a factorization after the first, medians over {rounds} rounds at most; of other solvers the "
            "fastest of their kernels and threads, and the gain is over the fastest of them. Operations are those of the order of "
            "elimination, which is the same for all; the gain and the rate are of our best number of threads.", "", overview(found, machine), "",
            "## Phases", "",
            "Milliseconds. Analysis without ordering; a solve reads the entries of L twice. The peak is that of the process, the "
            "matrix included; bytes of the solver are those that it says.", "", phases(found, machine), "",
            "## Instruction-set levels", "", "Ours with one thread: milliseconds, and the share of the level's peak.", "",
            levels(found, machine)]
