"""The fields of a document for a set in space, and its mesh."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core
from minkref.exact import digest, in_double_range


def mesh_of(found: _core.PolyhedralSet, triangles: bool) -> _core.Polyhedron:
    convex = found.convex()
    if convex is None:
        return found.surface().mesh(triangles)
    surface = convex.surface()
    return surface.cut_into_triangles() if triangles else surface


def set_fields(found: _core.PolyhedralSet) -> dict[str, Any]:
    surface, convex, volume = found.surface(), found.convex(), found.volume()
    canonical = found.canonical_json() if convex is None else convex.surface().canonical_json()
    names = ("components", "cavities", "tunnels")
    return {
        "convex": convex is not None,
        "digest": digest(canonical),
        "volume": volume,
        "volume_approximate": in_double_range(volume),
        "vertices": surface.vertices,
        "edges": surface.edges,
        "facets": surface.facets,
        **dict(zip(names, surface.topology(), strict=True)),
        "result": json.loads(canonical),
    }
