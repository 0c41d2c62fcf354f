"""The facets of a sum in space by their kinds: which faces of P and Q each is the sum of."""

from __future__ import annotations

from dataclasses import dataclass

from minkref.space.space_sum import SpaceSum

#: The first letter is of the face of P, the second of that of Q. The first three are the paper's
#: (Behar & Lien 2012, Sec. 3); the others occur where faces are parallel.
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
    """`P` and `Q`: its parents by their vertices, numbered as in the operands in canonical form.
    `ring`: its vertices, of the sum."""

    kind: str
    P: list[int]
    Q: list[int]
    ring: list[int]


def facets_of(answer: SpaceSum) -> list[Facet]:
    """In canonical order. Exact."""
    return [
        Facet(_letter(p) + _letter(q), list(p), list(q), list(ring))
        for (p, q), ring in zip(answer.facet_parents, answer.surface.rings(), strict=True)
    ]


def _letter(face: list[int]) -> str:
    return _LETTERS.get(len(face), "f")
