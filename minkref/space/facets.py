"""Kinds of facets for a sum in space: each facet sums a face of P and a face of Q."""

from __future__ import annotations

from dataclasses import dataclass

from minkref.space.space_sum import SpaceSum

#: The first letter describes the face of P, the second the face of Q. The first three kinds come
#: from the paper (Behar & Lien 2012, Sec. 3); the others need parallel faces.
KINDS = {
    "fv": "a facet of P at a vertex of Q",
    "vf": "a vertex of P at a facet of Q",
    "ee": "an edge of P and an edge of Q",
    "fe": "a facet of P and a parallel edge of Q",
    "ef": "an edge of P and a parallel facet of Q",
    "ff": "a facet of P and a parallel facet of Q",
}
_LETTERS = {1: "v", 2: "e"}


@dataclass(frozen=True)
class Facet:
    """A facet. `P` and `Q`: the parents' vertices, numbered as in the operands' canonical form.
    `ring`: the facet's vertices in the sum."""

    kind: str
    P: list[int]
    Q: list[int]
    ring: list[int]


def facets_of(answer: SpaceSum) -> list[Facet]:
    """List the facets in canonical order. Exact."""
    return [
        Facet(_letter(p) + _letter(q), list(p), list(q), list(ring))
        for (p, q), ring in zip(answer.facet_parents, answer.surface.rings(), strict=True)
    ]


def _letter(face: list[int]) -> str:
    return _LETTERS.get(len(face), "f")
