#!/usr/bin/env python3
"""Golden records of every energy that golden_2d.json and golden_3d.json lack.

    python3 tests/golden/generate.py [--check FILE]   # Debian: python3-mpmath, python3-gmpy2

Writes registry_2d.json and registry_3d.json beside this file, for the deformation gradients of the files that came with
the project. psi is a function of the signed singular values; derivatives are differences of psi in the entries of F, at
220 digits and steps of 1e-40, which leaves 60 correct digits or more: no formula of the library is used. --check compares
the records of energies that the given file has, too.
"""
import argparse
import json
import pathlib
import random

import mpmath as mp

mp.mp.dps = 220
STEP = mp.mpf(10) ** -40
HERE = pathlib.Path(__file__).parent


def invariants(s):
    total = sum(x * x for x in s)
    product = mp.mpf(1)
    for x in s:
        product *= x
    return sum(s), total, product


def isochoric(s):
    _, I2, J = invariants(s)
    return I2 / mp.root(J, len(s)) ** 2


def arruda_boyce(s, mu, N, K):
    y, d, J = isochoric(s), len(s), invariants(s)[2]
    c = [mp.mpf(1) / 2, mp.mpf(1) / 20, mp.mpf(11) / 1050, mp.mpf(19) / 7000, mp.mpf(519) / 673750]
    series = sum(c[k] / N ** k * (y ** (k + 1) - mp.mpf(d) ** (k + 1)) for k in range(5))
    return mu * series + K / 2 * (J - 1) ** 2


def fung(s, mu, b, K):
    return mu / (2 * b) * mp.expm1(b * (isochoric(s) - len(s))) + K / 2 * (invariants(s)[2] - 1) ** 2


def mooney_rivlin_3d(s, c10, c01, K):
    J = invariants(s)[2]
    v = mp.cbrt(J) ** -2
    cofactor = (s[0] * s[1]) ** 2 + (s[1] * s[2]) ** 2 + (s[2] * s[0]) ** 2
    return c10 * (v * invariants(s)[1] - 3) + c01 * (v * v * cofactor - 3) + K / 2 * (J - 1) ** 2


def mips_3d(s):
    return (invariants(s)[1] * sum(1 / (x * x) for x in s) - 1) / 8


def exponential_amips(s, sharpness, alpha):
    _, I2, J = invariants(s)
    conformal = I2 / (2 * J) if len(s) == 2 else mips_3d(s)
    return mp.exp(sharpness * (alpha * conformal + (1 - alpha) * (J + 1 / J) / 2))


def hencky(s, mu, **rest):
    logs = [mp.log(x) for x in s]
    return mu * sum(x * x for x in logs) + rest["lambda"] / 2 * sum(logs) ** 2


def lim_barrier(s, mu, weight, epsilon, width):
    _, I2, J = invariants(s)
    xi = (J - epsilon) / width
    barrier = 0 if xi >= 1 else 1 / (xi ** 3 - 3 * xi ** 2 + 3 * xi) - 1
    return mu / 2 * I2 + weight * barrier


def log_barrier(s, weight):
    return -weight * mp.log(invariants(s)[2])


def stable_neo_hookean_log(s, mu, **rest):
    d, (_, I2, J) = len(s), invariants(s)
    alpha = 1 + mu / rest["lambda"] * d / (d + 1)
    return mu / 2 * (I2 - d) + rest["lambda"] / 2 * (J - alpha) ** 2 - mu / 2 * mp.log(I2 + 1)


def symmetric_gradient(s):
    return invariants(s)[1] / 2 - mp.log(invariants(s)[2])


def volume_quadratic(s, weight):
    return weight * (invariants(s)[2] - 1) ** 2


def volume_symmetric(s, weight):
    J = invariants(s)[2]
    return weight / 2 * (J + 1 / J - 2)


# Of energies that the given files have: what --check compares.
def neo_hookean_log(s, mu, **rest):
    _, I2, J = invariants(s)
    return mu / 2 * (I2 - len(s)) - mu * mp.log(J) + rest["lambda"] / 2 * mp.log(J) ** 2


def dirichlet(s):
    return invariants(s)[1] / 2


# name: (psi, parameters exact in double, dimensions, det F must exceed)
ENERGIES = {
    "arruda_boyce": (arruda_boyce, {"mu": 1.0, "N": 8.0, "K": 2.5}, (2, 3), 0),
    "fung": (fung, {"mu": 1.5, "b": 0.75, "K": 2.5}, (2, 3), 0),
    "mooney_rivlin_3d": (mooney_rivlin_3d, {"c10": 0.5, "c01": 0.125, "K": 2.5}, (3,), 0),
    "mips_3d": (mips_3d, {}, (3,), 0),
    "exponential_amips": (exponential_amips, {"sharpness": 2.0, "alpha": 0.25}, (2, 3), 0),
    "hencky": (hencky, {"mu": 1.0, "lambda": 2.5}, (2, 3), 0),
    "lim_barrier": (lim_barrier, {"mu": 1.0, "weight": 0.5, "epsilon": 2.0 ** -12, "width": 0.75}, (2, 3), 2.0 ** -12),
    "log_barrier": (log_barrier, {"weight": 1.5}, (2, 3), 0),
    "stable_neo_hookean_log": (stable_neo_hookean_log, {"mu": 1.0, "lambda": 2.5}, (2, 3), None),
    "symmetric_gradient": (symmetric_gradient, {}, (2, 3), 0),
    "volume_quadratic": (volume_quadratic, {"weight": 1.5}, (2, 3), None),
    "volume_symmetric": (volume_symmetric, {"weight": 1.5}, (2, 3), 0),
}
CHECKED = {"nh_log": (neo_hookean_log, {"mu": 1.0, "lambda": 2.5}, 0), "dirichlet": (dirichlet, {}, None)}


def determinant(F, d):
    if d == 2:
        return F[0] * F[3] - F[2] * F[1]
    return (F[0] * (F[4] * F[8] - F[7] * F[5]) - F[3] * (F[1] * F[8] - F[7] * F[2])
            + F[6] * (F[1] * F[5] - F[4] * F[2]))


def stretches(F, d):
    """Signed singular values of F, column by column."""
    C = mp.matrix(d, d)
    for i in range(d):
        for j in range(d):
            C[i, j] = sum(F[d * i + r] * F[d * j + r] for r in range(d))
    squares = sorted((mp.mpf(x) for x in mp.eigsy(C, eigvals_only=True)), reverse=True)
    s = [mp.sqrt(abs(x)) for x in squares]
    # The smallest one from the determinant: its square may have lost every digit.
    J = determinant(F, d)
    rest = mp.mpf(1)
    for x in s[:-1]:
        rest *= x
    if rest != 0:
        s[-1] = J / rest
    return s


class Point:
    """The stretches around one F, shared by all energies."""

    def __init__(self, F, d):
        self.F, self.d, self.n = [mp.mpf(x) for x in F], d, d * d
        self.scale = max(abs(x) for x in self.F)
        self.h = STEP * self.scale
        self.cache = {}

    def at(self, *moves):
        if moves not in self.cache:
            F = list(self.F)
            for index, sign in moves:
                F[index] += sign * self.h
            self.cache[moves] = stretches(F, self.d)
        return self.cache[moves]


def derivatives(psi, point):
    value, n, h = psi(point.at()), point.n, point.h
    plus = [psi(point.at((i, 1))) for i in range(n)]
    minus = [psi(point.at((i, -1))) for i in range(n)]
    grad = [(plus[i] - minus[i]) / (2 * h) for i in range(n)]
    H = mp.matrix(n, n)
    for i in range(n):
        H[i, i] = (plus[i] - 2 * value + minus[i]) / (h * h)
        for j in range(i):
            corners = [psi(point.at((j, a), (i, b))) for a, b in ((1, 1), (1, -1), (-1, 1), (-1, -1))]
            H[i, j] = H[j, i] = (corners[0] - corners[1] - corners[2] + corners[3]) / (4 * h * h)
    return value, grad, H


def projected(H):
    values, vectors = mp.eigsy(H)
    n = H.rows
    HP = mp.matrix(n, n)
    for k in range(n):
        if values[k] > 0:
            for i in range(n):
                for j in range(n):
                    HP[i, j] += values[k] * vectors[i, k] * vectors[j, k]
    return values, HP


def number(x, scale):
    return 0.0 if abs(x) < mp.mpf(10) ** -55 * scale else float(x)


def norm(values):
    return mp.sqrt(sum(x * x for x in values))


def upper(M):
    return [M[i, j] for i in range(M.rows) for j in range(i, M.rows)]


def whole(M):
    return [M[i, j] for i in range(M.rows) for j in range(M.rows)]


def in_domain(J, bound):
    return bound is None or J > bound


def sensitivity(psi, bound, F, d, value, grad, H, HP, rng):
    """The largest change under six random perturbations of every entry by half a unit in the last place of |F|."""
    eps = mp.mpf(2) ** -53 * norm([mp.mpf(x) for x in F])
    worst = {"psi": mp.mpf(0), "grad": mp.mpf(0), "H": mp.mpf(0), "HP": mp.mpf(0)}
    for _ in range(6):
        moved = [mp.mpf(x) + (1 if rng.random() < 0.5 else -1) * eps for x in F]
        if not in_domain(determinant(moved, d), bound):
            return None
        value2, grad2, H2 = derivatives(psi, Point(moved, d))
        HP2 = projected(H2)[1]
        worst["psi"] = max(worst["psi"], abs(value2 - value))
        worst["grad"] = max(worst["grad"], norm([a - b for a, b in zip(grad2, grad)]))
        worst["H"] = max(worst["H"], norm([a - b for a, b in zip(whole(H2), whole(H))]))
        worst["HP"] = max(worst["HP"], norm([a - b for a, b in zip(whole(HP2), whole(HP))]))
    return {name: float(x) for name, x in worst.items()}


def record(psi, bound, F, d, point, rng):
    value, grad, H = derivatives(psi, point)
    if abs(value) > mp.mpf(10) ** 290:
        return None
    values, HP = projected(H)
    size = norm(whole(H))
    length = norm(point.F)
    if all(x >= -mp.mpf(10) ** -55 * size for x in values):
        HP = H
    return {"status": "ok", "psi": number(value, size * length * length), "grad": [number(x, size * length) for x in grad],
            "H": [number(x, size) for x in upper(H)], "HP": [number(x, size) for x in upper(HP)],
            "sens": sensitivity(psi, bound, F, d, value, grad, H, HP, rng)}


def bind(function, parameters):
    exact = {name: mp.mpf(x) for name, x in parameters.items()}
    return lambda s: function(s, **exact)


# The others say nothing of energies that are smooth wherever they are finite.
SKIPPED = {"inverted_exact_cancel", "singular_rank1", "singular_zero"}


def differ(mine, given):
    worst = 0.0
    for name in ("psi", "grad", "H", "HP"):
        a, b = (mine[name], given[name]) if name != "psi" else ([mine[name]], [given[name]])
        scale = max(abs(x) for x in (b if name != "HP" else given["H"])) or 1.0
        worst = max(worst, max(abs(x - y) for x, y in zip(a, b)) / scale)
    return worst


def generate(d, check):
    given = json.loads((HERE / f"golden_{d}d.json").read_text())
    energies = {name: e for name, e in ENERGIES.items() if d in e[2]}
    cases, worst = [], 0.0
    for case in given["cases"]:
        if case["category"] in SKIPPED:
            continue
        rng = random.Random(case["id"])
        point, J = Point(case["F"], d), determinant([mp.mpf(x) for x in case["F"]], d)
        results = {}
        for name, (function, parameters, _, bound) in energies.items():
            if in_domain(J, bound):
                made = record(bind(function, parameters), bound, case["F"], d, point, rng)
                if made:
                    results[name] = made
        for name, (function, parameters, bound) in CHECKED.items() if check else ():
            theirs = case["results"].get(name)
            if theirs and theirs["status"] == "ok":
                mine = record(bind(function, parameters), bound, case["F"], d, point, rng)
                worst = max(worst, differ(mine, theirs))
        cases.append({"id": case["id"], "category": case["category"], "F": case["F"], "results": results})
        print(f"{d}D {case['id']}: {len(results)} records", flush=True)
    if check:
        print(f"{d}D: largest relative difference from the records given: {worst:.2g}")
    meta = {"dim": d, "energies": {name: e[1] for name, e in energies.items()}}
    text = ",\n".join(json.dumps(c, separators=(",", ":")) for c in cases)
    (HERE / f"registry_{d}d.json").write_text(
        f'{{"meta":{json.dumps(meta)},\n"cases":[\n{text}\n]}}\n')


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--dim", type=int, choices=(2, 3), action="append")
    parser.add_argument("--check", action="store_true", help="compare with records that were given")
    arguments = parser.parse_args()
    for dim in arguments.dim or (2, 3):
        generate(dim, arguments.check)
