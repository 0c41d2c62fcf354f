"""The reference's routes to a sum in space, each as canonical text."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron

# A route's name, and its function's name in the module: (P, Q, scaling) to a set with
# canonical_json().
ROUTES = {"definition": "definition_sum_in_space", "edges": "edge_sum_in_space"}
Route = Callable[[Polyhedron, Polyhedron, Fraction], str]


def routes() -> dict[str, Route]:
    """Returns the routes that the module has."""
    found: dict[str, Any] = {name: getattr(_core, key, None) for name, key in ROUTES.items()}
    return {name: _route(function) for name, function in found.items() if function}


def _route(function: Any) -> Route:
    def text(P: Polyhedron, Q: Polyhedron, scale: Fraction) -> str:
        factor = str(scale)
        found = function(core_polyhedron(P), core_polyhedron(Q), (factor, factor, factor))
        return str(found.canonical_json())

    return text


def core_polyhedron(solid: Polyhedron) -> _core.Polyhedron:
    points = [(str(x), str(y), str(z)) for x, y, z in solid.vertices]
    return _core.Polyhedron(points, [list(face) for face in solid.faces])
