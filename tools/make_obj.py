#!/usr/bin/env python3
"""Writes an OBJ file.

make_obj.py index.js out.obj    from a JavaScript module with exports.positions=[[x,y,z],...] and exports.cells=[[a,b,c],...]
make_obj.py out.obj             a procedural model: a bent cap with ridges, a topological disk of 15 000 triangles
"""
import json
import math
import re
import sys


def read_module(path):
    with open(path) as file:
        text = file.read()
    arrays = []
    for name in ("positions", "cells"):
        match = re.search(r"exports\." + name + r"\s*=\s*", text)
        if not match:
            sys.exit(f"{path}: no exports.{name}")
        arrays.append(json.JSONDecoder().raw_decode(text, match.end())[0])
    return arrays


def used_only(vertices, triangles):
    """Without vertices that no triangle uses."""
    used = sorted({index for triangle in triangles for index in triangle})
    new_index = {old: new for new, old in enumerate(used)}
    return [vertices[i] for i in used], [[new_index[i] for i in triangle] for triangle in triangles]


def procedural(rings=50):
    """`rings` rings around a pole, ring r of 6 r vertices, on a sphere with bumps, well beyond the hemisphere."""
    vertices, triangles, start = [], [], [0]
    for ring in range(rings + 1):
        count = max(1, 6 * ring)
        start.append(start[-1] + count)
        for k in range(count):
            latitude, longitude = 2.2 * ring / rings, 2 * math.pi * k / count
            radius = 1 + 0.15 * math.sin(latitude) ** 2 * math.cos(5 * longitude) + 0.08 * math.cos(6 * latitude)
            vertices.append([radius * math.sin(latitude) * math.cos(longitude),
                             radius * math.sin(latitude) * math.sin(longitude), radius * math.cos(latitude)])
    for ring in range(rings):
        inner, outer = max(1, 6 * ring), 6 * (ring + 1)
        for sector in range(6):
            for k in range(ring + 1):
                a = start[ring] + (sector * ring + k) % inner
                b = start[ring + 1] + (sector * (ring + 1) + k) % outer
                c = start[ring + 1] + (sector * (ring + 1) + k + 1) % outer
                triangles.append([a, b, c])
                if k < ring:
                    triangles.append([a, c, start[ring] + (sector * ring + k + 1) % inner])
    return vertices, triangles


def main():
    arguments = sys.argv[1:]
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    vertices, triangles = used_only(*read_module(arguments[0])) if len(arguments) == 2 else procedural()
    with open(arguments[-1], "w") as file:
        for x, y, z in vertices:
            file.write(f"v {x!r} {y!r} {z!r}\n")
        for a, b, c in triangles:
            file.write(f"f {a + 1} {b + 1} {c + 1}\n")


if __name__ == "__main__":
    main()
