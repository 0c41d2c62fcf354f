"""The scene for a fault of OpenSCAD: an empty scene ends the program with 1."""

from __future__ import annotations

import json
from fractions import Fraction

from minkref.fuzz.adapters.surfaces import triangles_of
from minkref.fuzz.libraries.grid import polygons_of
from minkref.fuzz.libraries.program import Program, filled, scaled_operands
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.verdicts.verdict import Witness

LEAST_HALF = Fraction(1, 8192)  # the probe's: eight grid units of OpenSCAD in the plane
NOTE = (
    "OpenSCAD ends with exit code 1 where the scene is empty. Around the witness there is a small "
    "square or cube: its part in the sum is left where the witness is in the sum, its part outside "
    "where it is not. What is left would be empty by the fault."
)


def program(finding: Finding, name: str) -> Program | None:
    operands = scaled_operands(finding)
    if operands is None:
        return None
    space = finding.case.dimension == 3
    P, Q = (_solid(text) if space else _polygons(text) for text in operands)
    witness = finding.outcome.witness
    form = "off" if space else "svg"
    text = filled("openscad/program", finding, name, FORM=form, P=P, Q=Q, SCENE=_scene(witness))
    run = f"openscad -o {name}.{form} {name}.scad; echo $?"
    return Program(f"{name}.scad", text, run, NOTE if witness else "")


def _scene(witness: Witness | None) -> str:
    if witness is None:
        return "total();"
    half = max(LEAST_HALF, Fraction(witness.tolerance) / 8)
    size, shape = _number(2 * half), "square" if len(witness.point) == 2 else "cube"
    probe = f"translate({_point(witness.point)}) {shape}({size}, center = true);"
    if witness.in_truth:
        return f"intersection() {{\n  total();\n  {probe}\n}}"
    return f"difference() {{\n  {probe}\n  total();\n}}"


def _polygons(text: str) -> str:
    shapes = []
    for rings in polygons_of(text):
        points: list[str] = []
        paths: list[list[int]] = []
        for ring in rings:
            paths.append(list(range(len(points), len(points) + len(ring))))
            points += [_point(point) for point in ring]
        shapes.append(f"polygon([{', '.join(points)}],\n    {paths});")
    return "\n  ".join(shapes)


def _solid(text: str) -> str:
    value = json.loads(text)
    faces = [list(reversed(t)) for t in triangles_of(value["vertices"], value["faces"])]
    points = ", ".join(_point(vertex) for vertex in value["vertices"])
    return f"polyhedron([{points}],\n    {faces});"


def _point(numbers: tuple[str, ...] | list[str]) -> str:
    return f"[{', '.join(_number(Fraction(n)) for n in numbers)}]"


def _number(value: Fraction) -> str:
    return repr(float(value))
