"""minkref: the exact reference for Minkowski sums under scaling (Behar & Lien 2012).

import minkref
P = minkref.PolygonSet([(0, 0), (4, 0), (0, 3)])
result = minkref.minkowski_sum(P, minkref.read_file("Q.wkt"), "7/5")
print(result.region.area(), result.region.rings())
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from minkref.version import version

if TYPE_CHECKING:
    from minkref.api import (
        BadInput,
        BadPolygon,
        Certificate,
        ConvexCertificate,
        ConvexPolyhedron,
        ConvexSum,
        Convolution,
        ConvolutionEdge,
        Copy,
        DiscIndex,
        Event,
        Events,
        Feature,
        FitSupport,
        FreeBound,
        FreeScales,
        HeldEnd,
        HeldRange,
        HeldScales,
        LimitExceeded,
        NoProof,
        Offset,
        OffsetEvent,
        Owner,
        PathBound,
        PathCertificate,
        PolygonSet,
        PolyhedralSet,
        Polyhedron,
        Refusal,
        ScaleIndex,
        ScaleRange,
        Scene,
        ScenePassage,
        SolidCertificate,
        SpaceFeature,
        SpaceFitScales,
        SpaceFreeBound,
        SpaceFreeScales,
        SpaceHeldScales,
        SpacePathBound,
        SpaceValidScales,
        Sum,
        UndecidedSign,
        ValidScales,
        bad_polygons,
        build_index,
        convex_sum,
        convolution,
        decide,
        difference,
        events,
        held_scales,
        intersect,
        largest_fit,
        minkowski_sum,
        offset,
        open_index,
        polyhedral_sum,
        read_file,
        read_mesh,
        read_scene,
        read_text,
        set_memory_limit,
        subtract,
        tight_passages,
        trapped_scales,
        unite,
        valid_scales,
        write,
        write_mesh,
    )

__version__ = version()

__all__ = [
    "BadInput",
    "BadPolygon",
    "Certificate",
    "ConvexCertificate",
    "ConvexPolyhedron",
    "ConvexSum",
    "Convolution",
    "ConvolutionEdge",
    "Copy",
    "DiscIndex",
    "Event",
    "Events",
    "Feature",
    "FitSupport",
    "FreeBound",
    "FreeScales",
    "HeldEnd",
    "HeldRange",
    "HeldScales",
    "LimitExceeded",
    "NoProof",
    "Offset",
    "OffsetEvent",
    "Owner",
    "PathBound",
    "PathCertificate",
    "PolygonSet",
    "PolyhedralSet",
    "Polyhedron",
    "Refusal",
    "ScaleIndex",
    "ScaleRange",
    "Scene",
    "ScenePassage",
    "SolidCertificate",
    "SpaceFeature",
    "SpaceFitScales",
    "SpaceFreeBound",
    "SpaceFreeScales",
    "SpaceHeldScales",
    "SpacePathBound",
    "SpaceValidScales",
    "Sum",
    "UndecidedSign",
    "ValidScales",
    "bad_polygons",
    "build_index",
    "convex_sum",
    "convolution",
    "decide",
    "difference",
    "events",
    "held_scales",
    "intersect",
    "largest_fit",
    "minkowski_sum",
    "offset",
    "open_index",
    "polyhedral_sum",
    "read_file",
    "read_mesh",
    "read_scene",
    "read_text",
    "set_memory_limit",
    "subtract",
    "tight_passages",
    "trapped_scales",
    "unite",
    "valid_scales",
    "version",
    "write",
    "write_mesh",
]


def __getattr__(name: str) -> Any:
    """Load the extension module when first needed, so that the command can say that it is not
    built."""
    if name not in __all__:
        raise AttributeError(f"module 'minkref' has no attribute {name!r}")
    from minkref import api

    return getattr(api, name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
