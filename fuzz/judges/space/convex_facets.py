"""The facets of small convex sums by computer algebra from the definition."""

from __future__ import annotations

from collections.abc import Sequence

from minkref.oracle.symbolic import convex

Corner = Sequence[str]


def convex_facets(
    P: Sequence[Corner], Q: Sequence[Corner], scaling: Corner
) -> set[tuple[frozenset[int], frozenset[int]]]:
    """Returns, for each facet of S P + Q, the vertices of P and of Q on it. Exact; for a handful of
    vertices."""
    return convex.facets(P, Q, scaling)
