"""Hostile meshes: OFF, OBJ, STL, PLY and plain JSON."""

from __future__ import annotations

import struct

from hostile_file import JUDGED, SPACE, Hostile, Large, odd, sparse

MILLION = 10**6
OFF = "OFF\n4 4 6\n{} 0 0\n0 1 0\n1 0 0\n0 0 1/3\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n"
HEADER = "ply\nformat {} 1.0\nelement vertex {}\nproperty {} x\nproperty {} y\nproperty {} z\n"
LIST = "element face {}\nproperty list {} {} vertex_indices\nend_header\n"


def ply(
    format_: str = "ascii", vertices: str = "3", kind: str = "float", faces: str = "1",
    count: str = "uchar", index: str = "int", body: bytes = b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
) -> bytes:  # fmt: skip
    head = HEADER.format(format_, vertices, kind, kind, kind) + LIST.format(faces, count, index)
    return head.encode() + body


def stl(count: int, triangles: int, value: float = 1.0) -> bytes:
    one = struct.pack("<12fH", 0, 0, 0, value, 0, 0, 0, value, 0, 0, 0, value, 0)
    return bytes(80) + struct.pack("<I", count) + one * triangles


TEXTS: dict[str, tuple[str, str | bytes | Large]] = {
    **{f"OFF, {title}": ("number.off", OFF.format(spelling)) for title, spelling in {
        "an underscore": "1_0", "an exponent of a billion": "1e1_000_000_000",
        "Arabic digits": "\u0661", "a fraction by zero": "1/0", "not a number": "nan"}.items()},
    "OFF, counts of four billion": ("a.off", "OFF\n4294967295 4294967295 0\n"),
    "OFF, counts beyond every type": ("b.off", f"OFF\n{'9' * 40} 1 0\n0 0 0\n"),
    "OFF, counts below zero": ("c.off", "OFF\n-1 -1 0\n"),
    "OFF, a face of two billion vertices": ("d.off", "OFF\n1 1 0\n0 0 0\n2147483647 0 0 0\n"),
    "OFF, an index of 2^32": ("e.off", OFF.format(0).replace("3 0 1 2", "3 4294967296 1 2")),
    "OFF, an index below zero": ("f.off", OFF.format(0).replace("3 0 1 2", "3 -1 1 2")),
    "OFF, binary": ("g.off", b"OFF BINARY\n" + bytes(1000)),
    "OFF, in four dimensions": ("h.off", "4OFF\n1 0 0\n0 0 0 0\n"),
    "OFF, a comment of 50 MB": ("i.off", Large(lambda: b"OFF\n#" + b"x" * (50 << 20))),
    "OFF, a NUL": ("j.off", OFF.format("\0")),
    "OBJ, an index of zero": ("k.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"),
    "OBJ, an index far below zero": ("l.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -9999999999\n"),
    "OBJ, an index beyond every type": ("m.obj", f"v 0 0 0\nv 1 0 0\nf 1 2 {'9' * 30}\n"),
    "OBJ, slashes": ("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2// 3/1/1/1\n"),
    "OBJ, lines joined a million times": ("o.obj", Large(lambda: "v 0 0 \\\n" * MILLION)),
    "OBJ, an unknown word of a megabyte": ("p.obj", "x" * MILLION + " 1\n"),
    "OBJ, a weight of zero": ("q.obj", "v 0 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
    "OBJ, a file to be included": ("r.obj", "call /etc/passwd\nmtllib /etc/shadow\nv 0 0 0\n"),
    "PLY, two billion vertices": ("s.ply", ply(vertices="2147483648")),
    "PLY, a count below zero": ("t.ply", ply(vertices="-3")),
    "PLY, a count beyond every type": ("u.ply", ply(vertices="9" * 40)),
    "PLY, binary, two billion faces": ("v.ply", ply("binary_little_endian", faces="2000000000",
                                                   body=struct.pack("<9f", *range(9)))),
    "PLY, binary, a list of four billion": (
        "w.ply", ply("binary_little_endian", count="uint",
                     body=struct.pack("<9fI", *range(9), 0xFFFFFFFF))),
    "PLY, binary, a list shorter than none": (
        "x.ply", ply("binary_little_endian", count="int",
                     body=struct.pack("<9fi", *range(9), -1))),
    "PLY, binary, not a number": (
        "y.ply", ply("binary_big_endian", body=struct.pack(">9fB3i", float("nan"), *[0] * 8,
                                                           3, 0, 1, 2))),
    "PLY, an unknown type": ("z.ply", ply(kind="quad")),
    "PLY, a list whose count is a double": ("aa.ply", ply(count="double")),
    "PLY, indices that are floats": ("ab.ply", ply(index="float", body=b"0 0 0\n1 0 0\n0 1 0\n"
                                                   b"3 0.5 1 2\n")),
    "PLY, a header without end": ("ac.ply", "ply\nformat ascii 1.0\n" + "comment x\n" * MILLION),
    "PLY, a million elements": (
        "ad.ply", "ply\nformat ascii 1.0\n" + "".join(
            f"element e{k} 4000000000\nproperty list uint double p\n" for k in range(100_000))
        + "end_header\n"),
    "PLY, an element of no size, four billion times": (
        "ae.ply", "ply\nformat binary_little_endian 1.0\nelement nothing 4294967295\n"
        "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 0\nproperty list uchar int vertex_indices\nend_header\n"),
    "STL, a count that is not there": ("af.stl", stl(0xFFFFFFFF, 1)),
    "STL, a count of one of two": ("ag.stl", stl(1, 2)),
    "STL, not a number": ("ah.stl", stl(1, 1, float("nan"))),
    "STL, an end in the middle": ("ai.stl", stl(2, 2)[:-7]),
    "STL, ASCII, half a facet": ("aj.stl", "solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0\n"),
    "STL, ASCII, facets in facets": ("ak.stl", "solid x\n" + "facet normal 0 0 0\n" * MILLION),
    "JSON, an index that is a text": (
        "al.json", '{"vertices":[["0","0","0"]],"faces":[["0",0,0]]}'),
    "JSON, an index of 10^400": ("am.json", f'{{"vertices":[["0","0","0"]],"faces":[[1{"0" * 400},'
                                 '0,0]]}'),
    "JSON, an index that is a double": (
        "an.json", '{"vertices":[["0","0","0"]],"faces":[[0.0,1e0,0]]}'),
    "JSON, no faces": ("ao.json", '{"vertices":[["0","0","0"]]}'),
    "JSON, a face of a million times one vertex": (
        "ap.json", '{"vertices":[["0","0","0"]],"faces":[[' + "0," * MILLION + "0]]}"),
    "JSON, long denominators": (
        "aq.json", Large(lambda: '{"vertices":[' + ",".join(
            f'["1/{odd(10, 9000, k)}","{k}","1"]' for k in range(2000)) + '],"faces":[]}')),
}  # fmt: skip
FILES = [
    *(Hostile(title, name, data, SPACE) for title, (name, data) in TEXTS.items()),
    Hostile("STL, four gigabytes of zeros", "zeros.stl", sparse(1 << 32), SPACE),
    Hostile("STL, zeros that are triangles", "flat.stl", sparse(84 + 50 * 10**6), SPACE),
    Hostile(
        "OFF, a simplex of numbers of 9,000 digits",
        "long.off",
        OFF.format("0").replace("1/3", f"1/{'3' * 9000}"),
        SPACE,
        JUDGED,
    ),
]
