"""The document of `decompose`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import Enclosure
from minkref.schemas.plane.values import AreaApproximate, Ring
from minkref.schemas.values import Amount, Count, Digest, FileIsExact, Head, Number, Point, Written
from msgspec import Meta

Persistence = Annotated[
    str, Meta(description="A number, or inf.", pattern="^(inf|[0-9]+(/[1-9][0-9]*)?)$")
]


class DecomposedShape(TypedDict):
    P: Annotated[str, Meta(description="The operand as named.")]
    alpha: Annotated[Number, Meta(description="The disc's diameter at which features are taken.")]
    to: Annotated[
        Number | None,
        Meta(description="With --to: bars count from alpha to this diameter; otherwise null."),
    ]
    persistence: Annotated[
        Persistence,
        Meta(description="Features with longer bars are cut at; lengths are diameters."),
    ]


class DecomposeNotch(TypedDict):
    vertex: Point
    birth: Annotated[Enclosure, Meta(description="Of the feature's bar, as a diameter.")]
    death: Annotated[Enclosure | None, Meta(description="null: never.")]
    depth: Annotated[
        Enclosure | None, Meta(description="Behind the feature's bridges at alpha; null: infinite.")
    ]
    tie: Annotated[
        bool, Meta(description="Several vertices of the feature are as deep: the least one.")
    ]
    cut: Annotated[
        Count | None, Meta(description="The number of its cut; null: earlier cuts resolve it.")
    ]


DecomposeCut = TypedDict(
    "DecomposeCut",
    {
        "from": Point,
        "to": Point,
        "squared_length": Number,
        "notch": Count,
        "wall": Annotated[
            Count | None,
            Meta(description="The earlier cut on which it ends; null: on the boundary of P."),
        ],
    },
)


class DecomposePiece(TypedDict):
    area: Annotated[Number, Meta(description="Exact.")]
    area_approximate: AreaApproximate
    convex: bool
    bars: Annotated[Count, Meta(description="Of the piece's own features; 0 if it is convex.")]
    endless_bars: Annotated[Count, Meta(description="How many of them never end.")]
    longest_bar: Annotated[
        Enclosure | None,
        Meta(description="Length of the longest bar that ends, as a diameter; null: none does."),
    ]
    slits: Annotated[
        list[Annotated[list[Point], Meta(min_length=2, max_length=2)]],
        Meta(description="Parts of cuts with the piece on both sides."),
    ]
    outer: Ring
    holes: list[Ring]


class DecomposeFound(TypedDict):
    output_exact: FileIsExact
    compute_seconds: Annotated[Amount, Meta(description="Of features, cuts and pieces.")]
    digest: Annotated[Digest, Meta(description="SHA-256 of the pieces as a set in plain JSON.")]
    notches: Annotated[list[DecomposeNotch], Meta(description="In the order of cutting.")]
    cuts: Annotated[list[DecomposeCut], Meta(description="One after another.")]
    pieces: Annotated[
        list[DecomposePiece], Meta(description="In the canonical order of outer rings.")
    ]


class DecomposeDocument(Head, DecomposedShape, Written, DecomposeFound):
    """The document of `minkref decompose --json`."""

    command: Literal["decompose"]
