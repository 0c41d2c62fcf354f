"""The Python program for a fault of SFCGAL, for plane or space."""

from __future__ import annotations

import json

from minkref.fuzz.adapters.surfaces import triangles_of
from minkref.fuzz.libraries.grid import polygons_of
from minkref.fuzz.libraries.program import Program, filled, scaled_operands
from minkref.fuzz.run.runner import Finding


def program(finding: Finding, name: str) -> Program | None:
    operands = scaled_operands(finding)
    space = finding.case.dimension == 3
    if operands is None or space != finding.outcome.target.endswith("-space"):
        return None
    P, Q = (_solid(text) if space else _polygons(text) for text in operands)
    witness = finding.outcome.witness
    zero = ("0", "0", "0") if space else ("0", "0")
    text = filled(
        "sfcgal/space" if space else "sfcgal/plane",
        finding,
        name,
        P=P,
        Q=Q,
        X=", ".join(f'"{number}"' for number in (witness.point if witness else zero)),
        TRUTH=str(witness.in_truth) if witness else "None",
    )
    return Program(f"{name}.py", text, f"pip install pysfcgal\npython {name}.py")


def _polygons(text: str) -> str:
    texts = [
        f"({','.join(_ring([' '.join(point) for point in ring]) for ring in rings)})"
        for rings in polygons_of(text)
    ]
    if not texts:
        return "POLYGON EMPTY"
    return f"POLYGON {texts[0]}" if len(texts) == 1 else f"MULTIPOLYGON ({','.join(texts)})"


def _solid(text: str) -> str:
    value = json.loads(text)
    vertices = [" ".join(str(n) for n in vertex) for vertex in value["vertices"]]
    triangles = triangles_of(value["vertices"], value["faces"])
    faces = [f"({_ring([vertices[k] for k in face])})" for face in triangles]
    return f"SOLID Z (({','.join(faces)}))"


def _ring(points: list[str]) -> str:
    return f"({','.join([*points, points[0]])})"
