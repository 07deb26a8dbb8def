"""Small generated files under the made-up names that documents use: model.obj, body.msh, cat.png and so on."""
import importlib.util
import itertools
import math
import pathlib
import struct
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def make_obj():
    spec = importlib.util.spec_from_file_location("make_obj", ROOT / "tools" / "make_obj.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def disk(rings=8):
    """The bent cap of tools/make_obj.py with its boundary's vertices first: 0, 1, ... with the surface on the left."""
    vertices, triangles = make_obj().procedural(rings)
    count, boundary = len(vertices), 6 * rings
    return (vertices[-boundary:] + vertices[:-boundary],
            [[(i + boundary) % count for i in triangle] for triangle in triangles])


def closed(cells=8):
    """A closed surface with two bumps: the surface of a cube, brought to a sphere and pulled out."""
    index, vertices, triangles = {}, [], []

    def vertex(point):
        if point not in index:
            index[point] = len(vertices)
            direction = [2 * c / cells - 1 for c in point]
            length = math.sqrt(sum(c * c for c in direction))
            x, y, z = (c / length for c in direction)
            radius = 1 + 0.8 * max(0, x) ** 6 + 0.5 * max(0, z) ** 6
            vertices.append([radius * x, radius * y, radius * z])
        return index[point]

    for axis, side, i, j in itertools.product(range(3), (0, cells), range(cells), range(cells)):
        corners = []
        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
            point = [0, 0, 0]
            point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, i + a, j + b
            corners.append(vertex(tuple(point)))
        if side == 0:
            corners.reverse()
        triangles += [corners[:3], [corners[0], corners[2], corners[3]]]
    return vertices, triangles


def box(low, high, cells, place=lambda p: p):
    """A box of tets, six a cell, every vertex where `place` puts it."""
    counts = [n + 1 for n in cells]
    vertices = [place([l + (h - l) * c / n for l, h, c, n in zip(low, high, corner, cells)])
                for corner in itertools.product(*map(range, counts))]
    tets = []
    for cell in itertools.product(*map(range, cells)):
        for order in itertools.permutations(range(3)):
            corner, tet = list(cell), []
            for step in (None, *order):
                if step is not None:
                    corner[step] += 1
                tet.append((corner[0] * counts[1] + corner[1]) * counts[2] + corner[2])
            odd = sum(a > b for a, b in itertools.combinations(order, 2)) % 2
            tets.append([tet[1], tet[0], *tet[2:]] if odd else tet)
    return vertices, tets


def rows(items, shift=0, tail=""):
    return "".join(" ".join(repr(i + shift) for i in item) + tail + "\n" for item in items)


def obj(vertices, triangles):
    return "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices) + "".join(
        f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles)


def ply(vertices, triangles):
    return (f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
            + rows(vertices) + rows([[3, *t] for t in triangles]))


def msh(vertices, tets):
    nodes = "".join(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(vertices, 1))
    elements = "".join(f"{i} 4 2 0 1 {a + 1} {b + 1} {c + 1} {d + 1}\n" for i, (a, b, c, d) in enumerate(tets, 1))
    return (f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(vertices)}\n{nodes}$EndNodes\n"
            f"$Elements\n{len(tets)}\n{elements}$EndElements\n")


def medit(vertices, tets):
    return (f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(vertices)}\n{rows(vertices, tail=' 0')}"
            f"Tetrahedra\n{len(tets)}\n{rows(tets, shift=1, tail=' 0')}End\n")


def png(width=96, height=64):
    lines = b"".join(b"\0" + bytes(c for x in range(width) for c in (2 * x, 3 * y, 200 if (x // 8 + y // 8) % 2 else 60))
                     for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def bent(point):
    """A half turn of the upper end, about the y axis, and a bend."""
    x, y, z = point
    angle = 0.5 * math.pi * y
    return [x * math.cos(angle) + z * math.sin(angle) + 0.2 * y * y, y, z * math.cos(angle) - x * math.sin(angle)]


def body(place=lambda p: p):
    return box([0, 0, 0], [1, 1, 1], [6, 6, 6], place)


def hand(place=lambda p: p):
    return box([-0.5, -0.5, -0.1], [0.5, 0.8, 0.2], [6, 8, 2], place)


# What a document calls the file, what it is here, and how it is made.
FILES = {
    "model.obj": ("an open cap of 384 triangles", lambda: obj(*disk())),
    "face.obj": ("an open cap of 150 triangles", lambda: obj(*disk(5))),
    "hand.obj": ("an open cap of 216 triangles", lambda: obj(*disk(6))),
    "scan.ply": ("a closed surface of 768 triangles", lambda: ply(*closed())),
    "build/demo/bunny.obj": ("a closed surface of 768 triangles", lambda: obj(*closed())),
    "body.msh": ("a cube of 1,296 tets", lambda: msh(*body())),
    "hand.mesh": ("a box of 576 tets", lambda: medit(*hand())),
    "first.msh": ("a cube of 1,296 tets", lambda: msh(*body())),
    "second.msh": ("the cube turned and bent", lambda: msh(*body(bent))),
    "open.mesh": ("a box of 576 tets", lambda: medit(*hand())),
    "fist.mesh": ("the box turned and bent", lambda: medit(*hand(bent))),
    "me.png": ("a chequered picture of 96 x 64 pixels", png),
    "cat.png": ("a chequered picture of 96 x 64 pixels", png),
}


def write(folder, names):
    """Writes the files of these names into the folder, and says what they are."""
    for name in names:
        what, make = FILES[name]
        content = make()
        path = pathlib.Path(folder) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        print(f"input made for this test: {name}, {what}")
