"""Bad meshes through the command line: refused with a place and a mend, nothing written."""

from __future__ import annotations

import math
import struct
import time

from minkref import _core
from minkref.reports.evidence.framework.bad_input import Bad, refuse_all
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.4, 0.8)

CORNERS = ["0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1"]
CUBE = ["0 3 2 1", "4 5 6 7", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7"]
PLACE = ("face", "vert", "(")
BOTH = ("face", "and face")


def _off(corners: list[str], faces: list[str]) -> str:
    rows = [f"{len(face.split())} {face}" for face in faces]
    return "\n".join(["OFF", f"{len(corners)} {len(faces)} 0", *corners, *rows]) + "\n"


def _cube(corners: dict[int, str] | None = None, faces: dict[int, str | None] | None = None,
          more_corners: tuple[str, ...] = (), more_faces: tuple[str, ...] = ()) -> str:  # fmt: skip
    """A cube with corners and faces replaced, left out (None) and added."""
    points = [(corners or {}).get(k, corner) for k, corner in enumerate(CORNERS)]
    rings = [(faces or {}).get(k, face) for k, face in enumerate(CUBE)]
    return _off([*points, *more_corners], [*(ring for ring in rings if ring), *more_faces])


def _moved(shift: int, scale: int = 1) -> tuple[list[str], list[str]]:
    """Corners and faces of another cube, numbered from 8 on."""
    points = [" ".join(str(int(c) * scale + shift) for c in corner.split()) for corner in CORNERS]
    return points, [" ".join(str(int(k) + 8) for k in face.split()) for face in CUBE]


OTHER, OTHER_FACES = _moved(5)
LARGE, LARGE_FACES = _moved(-4, 9)
HALF = [f"{x}/2 {y}/2 {z}/2" for x, y, z in (c.split() for c in _moved(1, 2)[0])]
ABOVE = [f"{x} {y} {int(z) + 1}" for x, y, z in (c.split() for c in CORNERS)]
TURNED = {k: " ".join(reversed(face.split())) for k, face in enumerate(CUBE)}


def _stl(numbers: tuple[float, ...]) -> bytes:
    return b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12fH", 0, 0, 0, *numbers, 0)


BAD = [
    Bad(title, file, text, codes, places, beside="gs3",
        command="convolution" if codes == ("not-convex",) else "sum")  # which takes any shape
    for title, file, text, codes, places in (
        ("open mesh", "a.off", _cube(faces={5: None}), ("open-mesh",), PLACE),
        ("an edge of three faces", "b.off",
         _cube(more_corners=("0 0 -5",), more_faces=("0 1 8",)), ("non-manifold-edge",), PLACE),
        ("two cones that share their apex", "c.off",
         _off(["0 0 0", "1 0 0", "0 1 0", "0 0 1", "-1 0 0", "0 -1 0", "0 0 -1"],
              ["0 2 1", "0 1 3", "0 3 2", "1 2 3", "0 4 5", "0 6 4", "0 5 6", "4 6 5"]),
         ("non-manifold-vertex",), PLACE),
        ("a face turned round", "d.off", _cube(faces={1: TURNED[1]}), ("wrong-orientation",),
         PLACE),
        ("a surface inside out", "e.off", _cube(faces=dict(TURNED)), ("wrong-orientation",),
         ("face",)),
        ("a face in no plane", "f.off", _cube({6: "1 1 2"}), ("non-planar-face",), PLACE),
        ("a face without area", "g.off",
         _off(["0 0 0", "1 0 0", "2 0 0", "0 0 1"], ["0 1 2", "0 3 1", "1 3 2", "2 3 0"]),
         ("zero-area",), PLACE),
        ("a face whose edges cross", "h.off",
         _off(["0 0 0", "4 0 0", "4 4 0", "1 -1 0", "0 4 0"], ["0 1 2 3 4"]),
         ("face-not-simple",), PLACE),
        ("an edge without length", "i.off", _cube({1: "0 0 0"}), ("zero-length-edge",), PLACE),
        ("a face that visits a vertex twice", "j.off", _cube(faces={1: "4 5 6 5"}),
         ("repeated-vertex",), PLACE),
        ("a face of two vertices", "k.off", _cube(faces={1: "4 5"}), ("too-few-vertices",), ()),
        ("an index out of range", "l.off", _cube(faces={1: "4 5 6 8"}), ("index-out-of-range",),
         ("8",)),
        ("a vertex of no face", "m.off", _cube(more_corners=("7 7 7",)), ("unused-vertex",),
         ("vert", "(")),
        ("a dent", "n.off",
         _off(["1 0 0", "-1 0 0", "0 1 0", "0 -1 0", "0 0 1", "0 0 1/2"],
              ["0 2 4", "2 1 4", "1 3 4", "3 0 4", "2 0 5", "1 2 5", "3 1 5", "0 3 5"]),
         ("not-convex",), PLACE),
        ("two bodies", "o.off", _off([*CORNERS, *OTHER], [*CUBE, *OTHER_FACES]), ("not-convex",),
         ("face",)),
        ("a body in another", "p.off", _off([*CORNERS, *LARGE], [*CUBE, *LARGE_FACES]),
         ("shell-nesting",), BOTH),
        ("two bodies that cross", "cross.off", _off([*CORNERS, *HALF], [*CUBE, *OTHER_FACES]),
         ("self-intersection",), BOTH),
        ("two bodies on one face", "abut.off", _off([*CORNERS, *ABOVE], [*CUBE, *OTHER_FACES]),
         ("overlapping-faces",), BOTH),
        ("vertices without faces", "q.off", "OFF\n3 0 0\n1 2 3\n0 0 0\n0 0 1\n",
         ("too-few-faces",), ()),
        ("NaN", "r.off", _cube({3: "0 NaN 0"}), ("not-a-number",), ("line",)),
        ("infinity in binary STL", "s.stl", _stl((0, 0, 0, 1, 0, 0, float("inf"), 0, 0)),
         ("not-a-number",), ()),
        ("a truncated file (OFF)", "t.off", _cube()[:-20], ("truncated", "syntax"), ()),
        ("a truncated file (binary STL)", "u.stl", _stl((0, 0, 0, 1, 0, 0, 0, 1, 0))[:-9],
         ("truncated", "syntax", "wrong-length"), ()),
        ("a truncated file (PLY)", "v.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n",
         ("truncated", "syntax"), ()),
        ("counts beyond the file", "w.off", "OFF\n4000000000 4000000000 0\n0 0 0\n",
         ("truncated", "too-many-vertices", "syntax"), ()),
        ("a number of a million digits", "x.obj", f"v {'7' * 10**6} 0 0\n",
         ("number-too-long", "too-many-digits"), ()),
        ("an exponent of a billion", "y.obj", "v 1e1000000000 0 0\n", ("exponent-too-large",), ()),
        ("an index below the first (OBJ)", "z.obj",
         "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", ("index-out-of-range",), ("-4",)),
        ("an empty file", "empty.off", "", ("empty-file", "truncated"), ()),
    )
]  # fmt: skip
BAD.append(Bad("a factor of zero", "scale.off", _cube(), ("scale-zero",), scale="1,0,1",
               beside="gs3"))  # fmt: skip


GROWTH = Counts((2_000, 8_000), (5_000, 40_000), (10_000, 100_000))
MOST_SLOPE = 1.35  # log time over log corners


def _double_cone(corners: int) -> _core.Polyhedron:
    """A cone above and below a star: boxes of nearly all triangles overlap."""
    points: list[tuple[int, int, int]] = []
    for k in range(corners):
        radius, angle = 10**9 // (1 + k % 2), 2 * math.pi * k / corners
        points.append((round(radius * math.cos(angle)), round(radius * math.sin(angle)), 0))
    points += [(0, 0, 10**9), (0, 0, -(10**9))]
    faces = [[k, (k + 1) % corners, corners] for k in range(corners)]
    faces += [[(k + 1) % corners, k, corners + 1] for k in range(corners)]
    return _core.Polyhedron(points, faces)


def _validation_grows(findings: Findings, size: Size) -> None:
    sizes = size.of(GROWTH)
    seconds = []
    for corners in sizes:
        cone = _double_cone(corners)
        since = time.process_time()
        cone.validate()
        seconds.append(time.process_time() - since)
    slope = math.log(seconds[1] / seconds[0]) / math.log(sizes[1] / sizes[0])
    findings.target(
        f"slope of validation, {sizes[0]:,} to {sizes[1]:,} corners",
        slope <= MOST_SLOPE,
        f"at most {MOST_SLOPE}",
        round(slope, 2),
    )
    findings.figures["validation of a double cone"] = dict(
        zip(map(str, sizes), (round(one, 2) for one in seconds), strict=True)
    )
    # Bends a spike across its neighbours.
    crossing = _double_cone(sizes[0])
    points = crossing.points()
    points[100], points[104] = points[104], points[100]
    try:
        _core.Polyhedron(points, crossing.rings()).validate()
        found = "taken"
    except _core.BadInput as error:
        found = error.code
    findings.equal("a crossing among slivers", "self-intersection", found)


def run(findings: Findings, size: Size) -> None:
    refuse_all(findings, BAD)
    _validation_grows(findings, size)
