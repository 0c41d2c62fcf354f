"""The command of a finding: how its program is started, and with which arguments.

Each program takes a point, what is right of it (`in`, `out`, or `any` without a witness), and the
case. OpenSCAD's takes nothing.
"""

from __future__ import annotations

import json
import shlex
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from minkref.reports.findings.entry import Entry

FLAGS = ("-std=c++17", "-O1", "-DNDEBUG", "-frounding-math")
CGAL_LIBRARIES = ("-lmpfr", "-lgmp")
RUN = {
    ".py": "python {}",
    ".mjs": "node {}",
    ".java": "java -cp 'jars/*' {}",
    ".scad": "openscad -o out.svg {}",
}


def libraries(entry: Entry) -> tuple[str, ...]:
    """Libraries that a C++ program is linked with."""
    return CGAL_LIBRARIES if entry.library == "CGAL" else ()


def shown(entry: Entry) -> str:
    """The shell line that shows the finding, as a maintainer would type it."""
    if entry.path.suffix == ".cpp":
        start = shlex.join(["g++", *FLAGS, entry.program, *libraries(entry)]) + " && ./a.out"
    else:
        start = RUN[entry.path.suffix].format(entry.program)
    return " ".join([start, *map(shlex.quote, arguments(entry))])


def arguments(entry: Entry) -> list[str]:
    """Arguments of the program."""
    if entry.path.suffix == ".scad":
        return []
    case, witness = entry.case, entry.witness
    point, truth = ["0", "0"], "any"
    if witness is not None:
        point, truth = witness["point"], "in" if witness["in_truth"] else "out"
    exact = entry.library in ("CGAL", "SFCGAL") or entry.path.suffix == ".py"
    given = [" ".join(_number(Fraction(x), exact) for x in point), truth]
    if "offset" in case:
        radius = _number(Fraction(case["radius"]), entry.library == "CGAL")
        return [*given, _text(entry, case["offset"]), radius]
    if "sets" in case:
        return [*given, *(_text(entry, each) for each in case["sets"])]
    if "part" in case:
        scale = Fraction(case["scales"][0])
        return [*given, _text(entry, case["part"], scale), _text(entry, case["obstacles"])]
    method = [entry.adapter.split("-")[1]] if entry.library == "CGAL" else []
    P = _text(entry, case["P"], Fraction(case["scale"]))
    return [*given, P, _text(entry, case["Q"]), *method]


def _text(entry: Entry, value: dict[str, Any], scale: Fraction = Fraction(1)) -> str:
    """A set as the program reads it: WKT, or JSON in space, or, without a reader, numbers."""
    exact = entry.library in ("CGAL", "SFCGAL")

    def points(ring: Any) -> list[str]:
        return [" ".join(_number(scale * Fraction(x), exact) for x in point) for point in ring]

    if "vertices" in value:
        vertices = [[float(scale * Fraction(x)) for x in point] for point in value["vertices"]]
        return json.dumps({"vertices": vertices, "faces": value["faces"]}, separators=(",", ":"))
    if "lines" in value:
        return f"MULTILINESTRING {_braced(_braced(points(line)) for line in value['lines'])}"
    polygons = [
        list(map(points, [polygon["outer"], *polygon.get("holes", ())]))
        for polygon in value["polygons"]
    ]
    if entry.library in ("CGAL", "Boost.Polygon"):
        (rings,) = polygons
        told = [f"{len(ring)} {' '.join(ring)}" for ring in rings]
        return " ".join([told[0], str(len(told) - 1), *told[1:]])
    bodies = [_braced(_braced([*ring, ring[0]]) for ring in rings) for rings in polygons]
    if len(bodies) == 1 and entry.library != "Boost.Geometry":
        return f"POLYGON {bodies[0]}"
    return f"MULTIPOLYGON {_braced(bodies)}"


def _braced(parts: Iterable[str]) -> str:
    return f"({','.join(parts)})"


def _number(value: Fraction, exact: bool) -> str:
    """The number as `n/d`, or its nearest double in decimals."""
    near = float(value)
    return str(value) if exact or near.is_integer() else repr(near)
