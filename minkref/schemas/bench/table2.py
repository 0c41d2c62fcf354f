"""The paper's Table 2: convex polyhedra under scaling along each axis."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypedDict

from minkref.schemas.bench.spread import Spread
from minkref.schemas.values import Amount, Count, PositiveCount
from msgspec import Meta

PerRescaling = Annotated[Amount, Meta(description="A re-scaling.")]


class Table2Row(TypedDict):
    P: str
    Q: str
    kind: Annotated[
        Literal["random", "steps"],
        Meta(
            description="How the factors were chosen: at random within a range of ours, for the "
            "paper gives none, or in steps of up to 1 %."
        ),
    ]
    facets: Annotated[
        list[Annotated[int, Meta(ge=4)]],
        Meta(description="Of P and Q.", min_length=2, max_length=2),
    ]
    vertex_pairs_mean: Annotated[
        Amount,
        Meta(description="Pairs of vertices whose sums are the corners in general position."),
    ]
    ee_pairs_mean: Amount
    surface_facets_mean: Annotated[
        Amount, Meta(description="Facets of the surface, where it was made.")
    ]
    update: Annotated[
        Spread,
        Meta(description="Of the update alone, at each re-scaling the least of three passes."),
    ]
    coordinates: Annotated[
        Spread,
        Meta(
            description="Of evaluating the exact coordinates of all vertices: what no method can "
            "do without."
        ),
    ]
    ours: Annotated[Spread, Meta(description="Of both.")]
    with_surface: Annotated[
        Spread,
        Meta(
            description="Of the update and the certified surface in canonical form, with its "
            "coordinates; at every 25th re-scaling."
        ),
    ]
    floor_ratio: Annotated[
        Amount, Meta(description="Ours over the coordinates alone, of all re-scalings together.")
    ]
    traversal: Annotated[
        Spread, Meta(description="From scratch by the best static route, with coordinates.")
    ]
    traversal_ratio: Annotated[
        Amount, Meta(description="That over ours, of all re-scalings together.")
    ]
    traversal_ratios_mean: Annotated[
        Amount, Meta(description="The mean over the single re-scalings, here and below.")
    ]
    brute_force: Annotated[
        Spread, Meta(description="From scratch by comparing all pairs, with coordinates.")
    ]
    brute_force_ratio: Amount
    brute_force_ratios_mean: Amount
    cgal_hull: Annotated[
        Spread | None,
        Meta(
            description="CGAL's convex hull of all sums of vertices in its exact kernel; null "
            "where there is no CGAL."
        ),
    ]
    cgal_hull_ratio: Annotated[Amount | None, Meta(description="That over ours.")]
    cgal_hull_ratios_mean: Amount | None
    cgal_hull_surface_ratio: Annotated[
        Amount | None, Meta(description="That over ours with the surface.")
    ]
    fv_errors: PerRescaling
    vf_errors: PerRescaling
    ee_errors: PerRescaling
    descent_steps: PerRescaling
    chains_walked: PerRescaling
    signs: PerRescaling
    exact_signs: PerRescaling
    signs_per_error: Annotated[
        Amount | None, Meta(description="Predicates evaluated for each error mended.")
    ]
    chains_without_error: Annotated[
        Count,
        Meta(description="Pairs of edges lost without an error of a facet, in all re-scalings."),
    ]


class RatioRange(TypedDict):
    least: Amount
    mean: Amount
    greatest: Amount


OverAllPairs = Annotated[
    RatioRange | None, Meta(description="Over all pairs; the mean is geometric.")
]


class Table2(TypedDict):
    rescalings: PositiveCount
    rows: list[Table2Row]
    random_brute_force_ratio: OverAllPairs
    random_traversal_ratio: OverAllPairs
    random_cgal_hull_ratio: OverAllPairs
    random_floor_ratio: OverAllPairs
    steps_brute_force_ratio: OverAllPairs
    steps_traversal_ratio: OverAllPairs
    steps_cgal_hull_ratio: OverAllPairs
    steps_floor_ratio: OverAllPairs
    paper: Annotated[dict[str, Any], Meta(description="The ratios that the paper prints.")]
    notes: list[str]
    wrong: Annotated[
        list[str],
        Meta(
            description="Pairs of operands for which an update does not end in the static state, "
            "or in CGAL's hull: exit code 1."
        ),
    ]
    random_cgal_hull_surface_ratio: OverAllPairs
    steps_cgal_hull_surface_ratio: OverAllPairs
