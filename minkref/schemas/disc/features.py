"""The document of `features`."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.certificates import CertificateMade
from minkref.schemas.disc.index import PartEnd
from minkref.schemas.disc.sum import Term
from minkref.schemas.disc.values import (
    DiscEvent,
    Enclosure,
    ExactPlace,
    ExactPoint,
    Polynomial,
    Radius,
    RoundedPoint,
    ShapeFeature,
)
from minkref.schemas.values import Amount, Count, Digest, Fraction, LastingHead, Written
from msgspec import Meta

AlphaBetween = Annotated[
    Enclosure, Meta(description="Two doubles with the diameter between, or one double twice.")
]
LastAlpha = Annotated[
    Enclosure | None, Meta(description="The same; null: infinite, without an end.")
]
NodeKind = Literal["reflex", "minimum", "merge", "hole", "outside"]
TwoFeatures = Annotated[list[ShapeFeature], Meta(min_length=2, max_length=2)]


class MergeTreeNode(TypedDict):
    kind: NodeKind
    alpha: LastAlpha
    squared_radius: Annotated[Fraction | None, Meta(description="Where it is rational.")]
    polynomial: Annotated[Polynomial | None, Meta(description="Null at infinity.")]
    parent: Count | None
    children: list[Count]
    places: Annotated[
        list[list[DiscEvent]], Meta(description="One list for each place or flat ridge.")
    ]
    vertex: Annotated[ExactPlace | None, Meta(description="Of a reflex leaf.")]
    along: Annotated[
        ExactPlace | None,
        Meta(
            description="The primitive direction of the edge that leaves the vertex with the wedge "
            "on its right."
        ),
    ]
    tie: Annotated[bool, Meta(description="Only the least place told which child lives on.")]


class BarOfFeature(TypedDict):
    leaf: Annotated[Count, Meta(description="A node's number.")]
    birth: AlphaBetween
    death: LastAlpha
    end: Annotated[Count, Meta(description="The node at which it ends.")]
    persistence: LastAlpha
    essential: bool
    tie: bool


class BridgeOfFeature(TypedDict):
    ends: Annotated[list[ExactPoint], Meta(min_length=2, max_length=2)]
    near: Annotated[list[RoundedPoint], Meta(min_length=2, max_length=2)]
    centre: Annotated[RoundedPoint, Meta(description="Of the disc, rounded.")]
    features: TwoFeatures


class FeatureAtAlpha(TypedDict):
    node: Count
    bar: Count
    leaves: list[Count]
    deepest: Annotated[Count | None, Meta(description="Null: it has no reflex vertex.")]
    squared_depth: Annotated[
        str | None,
        Meta(description="Of the deepest leaf, as an expression; null: infinite, or no leaf."),
    ]
    depth: Enclosure | None
    tie: Annotated[bool, Meta(description="Of several leaves as deep the least place.")]
    bridges: list[BridgeOfFeature]


class RegionOfFeature(TypedDict):
    node: Annotated[Count | None, Meta(description="Null once the feature's hole is filled.")]
    area: Enclosure
    terms: Annotated[list[Term], Meta(description="The area exactly, as a sum.")]


class RegionsAtAlpha(TypedDict):
    """The alpha-shape at alpha: the set with the regions of all features."""

    components: Annotated[Count, Meta(description="Sets that touch are one.")]
    holes: Count
    area: Annotated[Enclosure, Meta(description="Of the alpha-shape.")]
    of_features: list[RegionOfFeature]


class RestOfFeature(TypedDict):
    node: Annotated[Count | None, Meta(description="Null once the feature's hole is filled.")]
    components: Count
    area: Enclosure


class RestAtAlpha(TypedDict):
    """The rest material: a closing with the disc adds it to the set."""

    area: Enclosure
    of_features: list[RestOfFeature]


TrackEnds = TypedDict("TrackEnds", {"from": PartEnd, "to": PartEnd})


class TrackOfBridge(TrackEnds):
    birth: AlphaBetween
    death: LastAlpha
    features: Annotated[
        list[TwoFeatures], Meta(description="The pairs that it joins, one after the other.")
    ]


AlphaWindow = TypedDict(
    "AlphaWindow", {"alpha": Radius | None, "from": Radius | None, "to": Radius | None}
)


class FeaturesDocument(LastingHead, AlphaWindow, Written):
    """The document of `minkref features --json`, and its file."""

    command: Literal["features"]
    P: Annotated[str, Meta(description="The operand as named.")]
    compute_seconds: Amount | None
    exact_signs: Annotated[Count, Meta(description="Decisions that roots had to make.")]
    digest: Annotated[Digest, Meta(description="Of the merge tree's canonical form.")]
    tree: Annotated[list[MergeTreeNode], Meta(description="Children before parents.")]
    bars: Annotated[
        list[BarOfFeature], Meta(description="Those of the window, in the order of the leaves.")
    ]
    tracks: Annotated[list[TrackOfBridge], Meta(description="Lives of bridges, by birth.")]
    features: Annotated[
        list[FeatureAtAlpha] | None, Meta(description="Those alive at alpha; null without it.")
    ]
    regions: Annotated[RegionsAtAlpha | None, Meta(description="With --regions, at alpha.")]
    rest: Annotated[RestAtAlpha | None, Meta(description="With --rest, at alpha.")]
    certificate: CertificateMade
