"""The document of `sum` in space."""

from __future__ import annotations

from typing import Annotated, Literal, TypedDict

from minkref.schemas.grammar import Either
from minkref.schemas.space.paper_update import SpacePaperAnswer
from minkref.schemas.space.values import ExposedPlane, PolyhedralSet, Polyhedron, SpaceScaling
from minkref.schemas.values import (
    Amount,
    AskedPlace,
    Count,
    FileIsExact,
    Head,
    InSpace,
    Number,
    Operands,
    Pair,
    SpacePoint,
    Written,
)
from msgspec import Meta

SpaceSumRoute = Literal[
    "traversal", "brute-force", "dynamic", "edges", "definition", "paper-update"
]


class Rounding(TypedDict):
    moved_vertices: Annotated[
        Count, Meta(description="Vertices that no longer are where they were.")
    ]
    largest_displacement: Annotated[
        Number, Meta(description="How far a vertex moved at most along an axis. Exact.")
    ]
    merged_vertices: Annotated[
        Count, Meta(description="By how many fewer different points there are.")
    ]
    degenerate_faces: Annotated[
        Count, Meta(description="Faces of which a triangle has no area any more.")
    ]
    turned_faces: Annotated[
        Count,
        Meta(
            description="Faces of which a triangle is turned over: its normal has an angle of 90 "
            "degrees or more to the one before."
        ),
    ]
    bent_faces: Annotated[
        Count, Meta(description="Faces of more than three vertices that are no longer in a plane.")
    ]
    closed: Annotated[
        bool,
        Meta(
            description="Faces run along each edge as often one way as the other; so they do where "
            "vertices of the same place are taken for one."
        ),
    ]
    fault: Annotated[
        str | None,
        Meta(
            description="The first rule of a polyhedron that the rounded mesh breaks, its faces "
            "cut into triangles: a code of docs/formats.md. Null: it breaks none, and no face "
            "crosses another. A sum that touches itself along an edge or in a vertex breaks one "
            "before it is rounded."
        ),
    ]


class SpaceSignShares(TypedDict):
    by_float: Annotated[float, Meta(ge=0, le=1)]
    by_integer: Annotated[float, Meta(ge=0, le=1)]


class SpaceSumSigns(TypedDict):
    by_float: Count
    by_integer: Count
    total: Count
    shares: SpaceSignShares


class FacetParents(TypedDict):
    P: Annotated[list[Count], Meta(min_length=1)]
    Q: Annotated[list[Count], Meta(min_length=1)]


class SurfaceFacet(TypedDict):
    plane: Annotated[
        Count,
        Meta(
            description="Its number in the list of oriented planes, which a sum that is not convex "
            "has as `planes`."
        ),
    ]
    rings: Annotated[
        list[Annotated[list[Count], Meta(min_length=2)]],
        Meta(
            description="Counter-clockwise seen from outside: the outer one, those around holes, "
            "and those there and back along edges in the inside of the facet.",
            min_length=1,
        ),
    ]
    tips: Annotated[
        list[Count],
        Meta(description="Vertices at which the boundary touches the inside of the facet."),
    ]
    parents: Annotated[
        list[FacetParents],
        Meta(
            description="The faces of P and Q, by their vertices, whose sums, facets of the "
            "reduced convolution, have area in common with it: a face and a vertex, a vertex and a "
            "face, or two edges."
        ),
    ]


class Surface(TypedDict):
    vertices: list[SpacePoint]
    facets: list[SurfaceFacet]


class SumOperands(TypedDict):
    """P, not scaled, and Q: convex ones in canonical form, coplanar faces merged, flat vertices
    dropped; others as they were given. The empty set, points and segments have no faces, a
    plane polygon has one."""

    P: Polyhedron
    Q: Polyhedron


class SpacePassages(TypedDict):
    sheets: Annotated[
        list[ExposedPlane],
        Meta(
            description="Regions of planes, with both shapes in contact; the first coordinate of a "
            "normal that is not zero is above zero."
        ),
    ]
    lines: Annotated[
        list[Annotated[list[SpacePoint], Meta(min_length=2, max_length=2)]],
        Meta(description="Maximal segments that are in no sheet."),
    ]
    points: Annotated[list[SpacePoint], Meta(description="Points in neither.")]


class SpaceSumDocument(Head, InSpace, Operands, Written, SpaceScaling):
    """The document of `minkref sum --json` in space."""

    command: Literal["sum"]
    output_exact: FileIsExact
    rounding: Annotated[
        Rounding | None,
        Meta(
            description="What a program has that reads the file as doubles. Null where nothing was "
            "written, or JSON, or where all coordinates are doubles; and where the doubles cannot "
            "be looked at: a coordinate is beyond their range, of which a warning tells, or it "
            "takes too many bits to write all of them over one denominator."
        ),
    ]
    at: AskedPlace
    route: SpaceSumRoute
    paper: Annotated[
        SpacePaperAnswer | None,
        Meta(
            description="On the route `paper-update`: what the program answers. All other fields "
            "are of the exact sum."
        ),
    ]
    compute_seconds: Annotated[
        Amount,
        Meta(
            description="Of the sum; of the routes for convex operands with the proof that it is "
            "closed and convex."
        ),
    ]
    convex: Annotated[
        bool,
        Meta(description="The sum is convex: then `result` has faces and vertices, else planes."),
    ]
    vertices: Annotated[
        Count,
        Meta(
            description="Of the mesh, as `edges`: of a sum that is not convex there are some where "
            "an edge goes straight on and another begins."
        ),
    ]
    edges: Count
    facets: Annotated[Count, Meta(description="Connected parts of the boundary in one plane.")]
    components: Annotated[Count, Meta(description="Connected components of the interior.")]
    cavities: Annotated[Count, Meta(description="Bounded connected components of the complement.")]
    tunnels: Annotated[
        Count, Meta(description="The genera of the surfaces that bound the components, added up.")
    ]
    projected_areas: Annotated[
        SpacePoint,
        Meta(
            description="The areas of the projections of all facets along x, y and z, added up, "
            "whether they hide each other or not. Exact."
        ),
    ]
    signs: Annotated[
        SpaceSumSigns | None,
        Meta(
            description="How many signs doubles with a proven bound decided, and how many "
            "integers. Null where the route does not count."
        ),
    ]
    statistics: Annotated[
        dict[str, Count] | None,
        Meta(
            description="What the route `edges` counted on the way, else null: facets of the "
            "reduced convolution, those of them that cells in the interior cover, pairs of the "
            "others that may meet, pieces of edges, candidates next to them, those that the "
            "boundary has, collision tests, and those of these that cells answered."
        ),
    ]
    result: Annotated[
        Either[Polyhedron, PolyhedralSet],
        Meta(
            description="The sum in canonical form: of a convex one (and the empty set) faces and "
            "vertices, of any other its planes."
        ),
    ]
    surface: Annotated[
        Surface | None,
        Meta(
            description="The boundary as facets with common vertices, and where they come from. "
            "Null for the routes for convex operands."
        ),
    ]
    vertex_parents: Annotated[
        list[Pair] | None,
        Meta(
            description="For each vertex the one vertex of P and the one of Q whose sum it is, "
            "numbered as in `operands`. Null for the routes `edges` and `definition`."
        ),
    ]
    facet_parents: Annotated[
        list[FacetParents] | None,
        Meta(
            description="For each facet the face of P and the face of Q whose sum it is, by their "
            "vertices: one, two, or those of a facet. Null for the routes `edges` and "
            "`definition`."
        ),
    ]
    operands: SumOperands
    tight_passages: Annotated[
        SpacePassages | None,
        Meta(
            description="What the interior of the sum has and the sum of the interiors has not, as "
            "closed pieces. Null where it was not asked for (`--passages`)."
        ),
    ]
    passages_complete: Annotated[
        bool,
        Meta(description="`tight_passages` has them all; false where they were not asked for."),
    ]
