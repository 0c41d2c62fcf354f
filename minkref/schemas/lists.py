"""Documents of `families`, `models` and `targets`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.values import Count, Head
from msgspec import Meta


class Family(TypedDict):
    name: str
    dimension: Literal[2, 3]
    title: str
    command: Annotated[
        Literal["verify", "generate"], Meta(description="The command that takes it.")
    ]


class FamiliesDocument(Head):
    """The document of `minkref families --json`."""

    command: Literal["families"]
    families: list[Family]


class Model(TypedDict):
    name: str
    vertices: Count
    holes: Count
    origin: Literal["shipped", "MINKREF_MODELS"]
    file: str
    about: str


class PolyhedronModel(TypedDict):
    name: str
    vertices: Count
    facets: Count
    origin: Literal["shipped"]
    file: str
    about: str


class UnreadableModel(TypedDict):
    name: str
    file: str
    why: str


class AbsentModel(TypedDict):
    name: str
    look_alike: str


class ModelsDocument(Head):
    """The document of `minkref models --json`."""

    command: Literal["models"]
    folder: Annotated[str | None, Meta(description="The folder MINKREF_MODELS, where it is set.")]
    models: list[Model]
    polyhedra: Annotated[
        list[PolyhedronModel],
        Meta(
            description="Convex polyhedra in OFF that ship with minkref; no operands in the plane."
        ),
    ]
    unreadable: Annotated[
        list[UnreadableModel],
        Meta(description="Files of the folder MINKREF_MODELS that hold no polygon set."),
    ]
    absent: Annotated[
        list[AbsentModel],
        Meta(description="Models of the paper that are not here, and ours that look alike."),
    ]


class ListedTarget(TypedDict):
    name: str
    version: str | None
    about: str
    available: bool
    reason: Annotated[
        str | None, Meta(description="Why it is absent, with the command that builds it.")
    ]


class TargetsDocument(Head):
    """The document of `minkref targets --json`."""

    command: Literal["targets"]
    targets: list[ListedTarget]
