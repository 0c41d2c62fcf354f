"""The document of `repair`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Count, FileIsExact, Head, Number, Written
from msgspec import Meta

RepairRule = Literal["nonzero", "evenodd", "positive"]
ChangeKind = Literal[
    "closed",
    "repeated-point",
    "spike",
    "no-area",
    "turned",
    "self-touching",
    "self-crossing",
    "hole-outside",
    "holes-overlap",
    "shared-edge",
    "polygons-overlap",
    "polygons-abut",
    "welded",
    "joined",
    "repeated-vertex",
    "zero-area",
    "edge-split",
    "duplicate-face",
    "opposite-face",
    "triangulated",
    "turned-face",
    "turned-shell",
    "dropped-shell",
    "split-vertex",
    "unused-vertex",
]
PlaceNumber = Annotated[
    Count, Meta(description="From 0 as in the file; absent for what the repair itself has made.")
]
Coordinates = Annotated[list[Number], Meta(min_length=2, max_length=3)]


class RepairKind(TypedDict):
    kind: ChangeKind


class RepairChange(RepairKind, total=False):
    """One change: kind, place, size."""

    ring: PlaceNumber
    other_ring: PlaceNumber
    face: PlaceNumber
    other_face: PlaceNumber
    faces: Annotated[Count, Meta(description="Of a shell.")]
    vertex: Annotated[Count, Meta(description="Of the ring, or of the polyhedron, from 0.")]
    other_vertex: Count
    line: Annotated[Count, Meta(description="Of the file.")]
    point: Coordinates
    to: Annotated[Coordinates, Meta(description="Where the point is now.")]
    squared_distance: Annotated[Number, Meta(description="Of the move, gap or spike.")]
    area: Annotated[Number, Meta(description="Of the part concerned, in the plane.")]
    squared_area: Annotated[Number, Meta(description="Of the face, in space.")]
    volume: Annotated[Number, Meta(description="That the shell encloses.")]


class RepairDocument(Head, Written):
    """The document of `minkref repair --json`."""

    command: Literal["repair"]
    dimension: Literal[2, 3]
    operand: str
    rule: RepairRule
    weld: Annotated[Number | None, Meta(description="The distance of --weld.")]
    changes: Annotated[list[RepairChange], Meta(description="In the order in which they are made.")]
    area: Annotated[Number | None, Meta(description="Of the repaired set; null in space.")]
    volume: Annotated[
        Number | None, Meta(description="Of the repaired polyhedron; null in the plane.")
    ]
    vertices: Count
    faces: Annotated[Count | None, Meta(description="Null in the plane.")]
    output_exact: FileIsExact
