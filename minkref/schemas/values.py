"""Numbers, points and heads, which documents of several settings have."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from msgspec import Meta

Amount = Annotated[float, Meta(ge=0)]
Count = Annotated[int, Meta(ge=0)]

Number = Annotated[
    str,
    Meta(
        description="An exact number in lowest terms: n or n/d with d > 1.",
        pattern="^-?[0-9]+(/[1-9][0-9]*)?$",
    ),
]

Rule = Literal["allowed", "forbidden"]
PositiveCount = Annotated[int, Meta(ge=1)]
Pair = Annotated[list[Count], Meta(min_length=2, max_length=2)]
Point = Annotated[list[Number], Meta(min_length=2, max_length=2)]
SpacePoint = Annotated[list[Number], Meta(min_length=3, max_length=3)]

FileIsExact = Annotated[
    bool | None,
    Meta(
        description="The file holds the very set; false where its format knows decimals only, or "
        "is a picture."
    ),
]

Form = Literal["corrected", "printed"]
# As Number; nobody promises lowest terms.
Fraction = Annotated[str, Meta(pattern="^-?[0-9]+(/[0-9]+)?$")]
Digest = Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]


class Head(TypedDict):
    """What every document has."""

    version: Annotated[str, Meta(description="Version of minkref.")]
    seconds: Annotated[Amount, Meta(description="Wall-clock time of the command.")]
    peak_bytes: Annotated[
        Count, Meta(description="Largest resident size of the command or a child of it.")
    ]


class Written(TypedDict):
    """What was warned of and written."""

    warnings: list[str]
    output: Annotated[str | None, Meta(description="The file that was written.")]


class LastingHead(TypedDict):
    """What every document has; times and memory are null in files, so that two runs write the same
    bytes."""

    version: Annotated[str, Meta(description="Version of minkref.")]
    seconds: Annotated[Amount | None, Meta(description="Wall-clock time of the command.")]
    peak_bytes: Annotated[
        Count | None, Meta(description="Largest resident size of the command or a child of it.")
    ]


class Operands(TypedDict):
    """The operands."""

    P: Annotated[str, Meta(description="The first operand as named; the scaled one.")]
    Q: str


class MaybeEroded(TypedDict):
    """Tells erosions from sums."""

    erode: Annotated[
        bool, Meta(description="Of the erosion, with --erode: what is left of P, not the sum.")
    ]


class PlaceOfPoint(TypedDict):
    """Where a point lies in the sum."""

    point: Annotated[list[Number], Meta(min_length=2, max_length=3)]
    place: Annotated[
        Literal["inside", "boundary", "outside", "undecided"],
        Meta(description="With a ball, between both sets: undecided."),
    ]


AskedPlace = Annotated[
    PlaceOfPoint | None, Meta(description="The answer to --at; null without it.")
]


class InSpace(TypedDict):
    """What tells documents in space from others."""

    dimension: Literal[3]


Window = TypedDict(
    "Window",
    {
        "from": Annotated[
            Number | None, Meta(description="Begin of the window, in it; null: open to 0.")
        ],
        "to": Annotated[
            Number | None, Meta(description="End of the window, in it; null: endless.")
        ],
    },
)


class AnySweep(LastingHead):
    """What each `sweep` tells."""

    warnings: list[str]
    output: Annotated[str | None, Meta(description="The folder that was written.")]


class Page(Head):
    """What each page is told of."""

    warnings: list[str]
    output: Annotated[str, Meta(description="The page that was written.")]
    bytes: Annotated[Count, Meta(description="Its size.")]
