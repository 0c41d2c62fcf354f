"""A polyhedral set's exposed faces by plane, with corners in space, by the slow engine's code: from
a canonical text, or from a polyhedron."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole
from minkref.oracle.slow import Exposed, exposed_from_json, of_faces
from minkref.oracle.slow.space.exposed import lifted, rings_of


@dataclass(frozen=True)
class PlaneFaces:
    """`normal · x = offset`, and the rings of all faces in this plane, outer rings and holes; the
    normal points out of the set."""

    normal: Whole
    offset: Fraction
    rings: list[list[Point]]


def planes_of_text(text: str) -> list[PlaneFaces]:
    """Returns the planes of a set in canonical JSON."""
    return _planes(exposed_from_json(json.loads(text)))


def planes_of_solid(solid: Polyhedron) -> list[PlaneFaces]:
    """The planes of a valid polyhedron, each with all faces in the plane."""
    return _planes(of_faces([solid.vertices[k] for k in face] for face in solid.faces))


def _planes(found: Exposed) -> list[PlaneFaces]:
    return [
        PlaneFaces(
            plane[0],
            plane[1],
            [[lifted(point, plane) for point in ring] for ring in rings_of(polygons)],
        )
        for plane, polygons in found.planes.items()
    ]
