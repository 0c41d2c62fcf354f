"""The document of `index` in the plane."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.plane.values import Segments
from minkref.schemas.values import (
    Amount,
    Count,
    Head,
    MaybeEroded,
    Number,
    Operands,
    PositiveCount,
    Window,
)
from msgspec import Meta


class CheckedRoutes(TypedDict):
    """Scales at which the sum was compared with that of the static route, and found equal in
    canonical form, components and holes."""

    routes: tuple[Literal["index"], Literal["paper"]]
    scales: list[Number]


class IndexDocument(Head, Operands, Window, MaybeEroded):
    """The document of `minkref index --json`."""

    command: Literal["index"]
    warnings: list[str]
    output: Annotated[str, Meta(description="The file that was written.")]
    bytes: Annotated[Count, Meta(description="Its size.")]
    threads: Annotated[PositiveCount, Meta(description="Of the build.")]
    build_seconds: Annotated[
        Amount, Meta(description="Of the build, without reading, comparing and writing.")
    ]
    segments: Segments
    checked: CheckedRoutes
    statistics: Annotated[
        dict[str, Count],
        Meta(
            description="Counts of the index: pairs of edges that doubles let meet, those left out "
            "since they meet inside the sum, faces of patches that were tested, exposed pieces, "
            "tracks of vertices, links between them, scales of events, events of the boundary and "
            "of the topology, buckets of scales and the corners in them; bits of the longest "
            "integer of a track."
        ),
    ]
