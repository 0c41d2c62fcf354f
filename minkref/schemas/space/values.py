"""Polyhedra and other sets in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Count, Digest, Number, Point, SpacePoint
from msgspec import Meta

SpaceScale = Annotated[SpacePoint, Meta(description="The factors of the three axes.")]
Face = Annotated[list[Count], Meta(min_length=3)]
FacetKind = Literal["fv", "vf", "ee"]

VolumeApproximate = Annotated[
    float | None,
    Meta(
        description="The double next to the volume; null where that is beyond the range of doubles."
    ),
]

IntegerText = Annotated[str, Meta(pattern="^-?[0-9]+$")]
FlatRing = Annotated[list[Point], Meta(min_length=3)]


class Polyhedron(TypedDict):
    """A polyhedron, in canonical form where it is convex."""

    faces: Annotated[
        list[Face], Meta(description="Rings of vertices, counter-clockwise seen from outside.")
    ]
    vertices: list[SpacePoint]


class SpaceScaling(TypedDict):
    """The sum at one scaling."""

    scale: SpaceScale
    digest: Annotated[Digest, Meta(description="SHA-256 of the canonical JSON.")]
    volume: Annotated[Number, Meta(description="Exact.")]
    volume_approximate: VolumeApproximate


class FlatPolygon(TypedDict):
    holes: list[FlatRing]
    outer: FlatRing


class FlatRegion(TypedDict):
    """The faces in this plane, seen along the first axis in which the normal is not zero."""

    polygons: list[FlatPolygon]


class ExposedPlane(TypedDict):
    normal: Annotated[
        list[IntegerText],
        Meta(
            description="Points away from the set; without common divisor.",
            min_length=3,
            max_length=3,
        ),
    ]
    offset: Number
    region: FlatRegion


class PolyhedralSet(TypedDict):
    """A set in space in canonical form: what is exposed in each oriented plane."""

    planes: list[ExposedPlane]
