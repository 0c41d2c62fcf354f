"""convex-minkowski-sum (npm): sums of convex polygons, by a hull one dimension up."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="convex-minkowski-sum",
    targets="convex-minkowski-sum",
    place=20,
    methods=(Method("convex-minkowski-sum", "convex-minkowski-sum, of convex polygons only"),),
    kind="node",
    program="convex_sum/adapter.mjs",
    source="convex-minkowski-sum 1.0.0 (npm)",
    licence="MIT",
    home="convex-minkowski-sum",
    has_program=False,
)
