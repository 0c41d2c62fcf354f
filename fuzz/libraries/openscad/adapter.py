"""OpenSCAD: minkowski() in the plane and in space, and offset() in the plane; the argument is sum
or offset. The program `openscad` runs for each call.

Results are exported as SVG in the plane, as OFF in space: all formats write six significant digits
(5e-6 of a number). In the plane OpenSCAD computes on a grid of 2^-16 (Clipper), in space it merges
points on a grid of 2^-20; hence the tolerance, four units of the coarser grid and twice the digits.
offset(r) has $fn = 128: the polygon of an arc is off by 1 - cos(pi / 128) = 0.0003 of the radius,
and its vertices lie on the grid. Sharp corners are those of offset(delta).
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from adapter_protocol import Set, Skipped, serve  # type: ignore[import-not-found,unused-ignore]
from surfaces import triangles_of  # type: ignore[import-not-found,unused-ignore]

EMPTY = ("top level object is empty", "top level object is not a 2D object")  # nothing is left
PROGRAM = os.environ.get("OPENSCAD", "openscad")


def version() -> str:
    """Returns the version, as `2021.01`."""
    done = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True)
    return (done.stdout + done.stderr).split()[-1]


def point(p: Iterable[float]) -> str:
    return f"[{','.join(repr(float(x)) for x in p)}]"


def scad_plane(polygons: list[dict[str, Any]]) -> str:
    """The polygons as one child: outer rings and holes as paths of polygon()."""
    if any(len(polygon["outer"]) < 3 for polygon in polygons):
        raise Skipped("no points or segments")
    texts = []
    for polygon in polygons:
        points: list[str] = []
        paths: list[list[int]] = []
        for ring in (polygon["outer"], *polygon["holes"]):
            paths.append(list(range(len(points), len(points) + len(ring))))
            points += [point(p) for p in ring]
        texts.append(f"polygon([{','.join(points)}],{paths});")
    return f"union(){{{' '.join(texts)}}}"


def scad_space(mesh: Set) -> str:
    """The mesh as polyhedron(), whose faces run clockwise seen from outside."""
    faces = [list(reversed(t)) for t in triangles_of(mesh["vertices"], mesh["faces"])]
    return f"polyhedron([{','.join(point(v) for v in mesh['vertices'])}],{faces});"


def run(scene: str, form: str) -> str:
    """Exports the scene by OpenSCAD, which ends with exit code 1 if the scene is empty."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder, "in.scad"), Path(folder, f"out.{form}")
        source.write_text(scene, encoding="utf-8")
        done = subprocess.run(
            [PROGRAM, "-o", str(target), str(source)], capture_output=True, text=True, check=False
        )
        if done.returncode < 0:
            raise RuntimeError(f"openscad was ended by signal {-done.returncode}")
        if form == "svg" and any(words in done.stderr for words in EMPTY):
            return ""
        if done.returncode or "ERROR" in done.stderr or not target.exists():
            raise RuntimeError(f"exit code {done.returncode}: {done.stderr[-1500:]}")
        return target.read_text(encoding="utf-8")


def read_svg(text: str) -> dict[str, Any]:
    """The path's rings; in SVG, y points down."""
    found = re.search(r'<path d="([^"]*)"', text)
    rings = []
    for part in found[1].split("M")[1:] if found else []:
        numbers = [float(x) for x in re.findall(r"[-+.\deE]+", part.replace("z", ""))]
        rings.append([[x, -y] for x, y in zip(numbers[::2], numbers[1::2], strict=True)])
    return {"rings": rings, "fill": "evenodd"}


def read_off(text: str) -> dict[str, Any]:
    words = iter(text.replace("OFF", "", 1).split())
    vertex_count, face_count, _ = (int(next(words)) for _ in range(3))
    vertices = [[float(next(words)) for _ in range(3)] for _ in range(vertex_count)]
    faces = [[int(next(words)) for _ in range(int(next(words)))] for _ in range(face_count)]
    return {"vertices": vertices, "faces": faces}


def sum_of(sP: Set, Q: Set) -> dict[str, Any]:
    if "polygons" in sP:
        children = f"{scad_plane(sP['polygons'])} {scad_plane(Q['polygons'])}"
        return read_svg(run(f"minkowski(){{{children}}}", "svg"))
    return read_off(run(f"minkowski(){{{scad_space(sP)} {scad_space(Q)}}}", "off"))


def offset_of(P: Set, radius: float, how: dict[str, Any] | None = None) -> dict[str, Any]:
    by = f"delta={float(radius)!r}" if how else f"r={float(radius)!r},$fn=128"
    return read_svg(run(f"offset({by}){{{scad_plane(P['polygons'])}}}", "svg"))


def main(mode: str) -> None:
    hello: dict[str, Any] = {
        "name": "openscad",
        "version": version(),
        "language": "C++",
        "arithmetic": "float64",
        "numbers": "double",
        "grid": {"unit": "1/65536"},
        "tolerance": {"absolute": "1/16384", "relative": "1e-5"},
        "sum": "region",
        "capabilities": "plane space non-convex holes components non-uniform".split(),
    }
    if mode == "sum":
        serve(hello, sum_of)
        return
    hello["name"], hello["sum"] = "openscad-offset", "none"
    hello["grid"] = {"unit": "1/65536", "largest": "30000"}  # of the unit, within 31 bits
    # Discs of few units get few vertices, so eight units.
    hello["tolerance"] = {"absolute": "1/8192", "relative": "1e-5", "radius": "0.001"}
    hello["capabilities"] = (
        "plane non-convex holes components offset inset join-sharp inset-sharp".split()
    )
    serve(hello, None, offset_of=offset_of)


if __name__ == "__main__":
    main(sys.argv[1])
