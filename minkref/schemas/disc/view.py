"""The documents of `view` with a disc, and of features."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.disc.values import DiscEventCounts, PartsOfTheDiagram, ShapeAndDisc
from minkref.schemas.values import Amount, Count, MaybeEroded, Number, Page
from msgspec import Meta

DiscViewWindow = TypedDict(
    "DiscViewWindow",
    {
        "from": Annotated[Number, Meta(description="The smallest radius of the slider.")],
        "to": Annotated[Number, Meta(description="The largest.")],
    },
)


class DiscViewDocument(Page, ShapeAndDisc, DiscViewWindow, MaybeEroded):
    """The document of `minkref view --json` with a disc."""

    command: Literal["view"]
    preprocessing_seconds: Annotated[Amount, Meta(description="Of all events and the index.")]
    radii_of_events: Annotated[
        Count, Meta(description="Radii of the window at which something changes.")
    ]
    events: Annotated[DiscEventCounts, Meta(description="Events in the window, by kind.")]
    parts_of_the_diagram: PartsOfTheDiagram
    holes: Annotated[Count, Meta(description="Holes that there are at some radius of the window.")]
    polygons: Annotated[Count, Meta(description="Of P.")]


FeatureViewWindow = TypedDict(
    "FeatureViewWindow",
    {
        "from": Annotated[Number, Meta(description="The smallest diameter of the slider.")],
        "to": Annotated[Number, Meta(description="The largest.")],
    },
)


class FeatureViewDocument(Page, FeatureViewWindow):
    """The document of `minkref view --features --json`."""

    command: Literal["view"]
    P: Annotated[str, Meta(description="The operand as named.")]
    features: Literal[True]
    compute_seconds: Annotated[Amount, Meta(description="Time for all events and the tree.")]
    nodes: Annotated[Count, Meta(description="Nodes of the merge tree.")]
    bars: Count
    endless_bars: Annotated[Count, Meta(description="Bars that never end.")]
    parts_of_the_diagram: PartsOfTheDiagram
