"""The convolution of two operands, as values: the list of `minkref convolution`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import overload

from minkref import _core
from minkref.argument_types import expect_sets, scale_text, text_of, truth
from minkref.errors import Refusal, choice

COMPATIBLE = ("half-open", "open", "closed")
CHUNK = 1024  # edges made at a time
Number = str | int | Fraction
PlaneScale = Number | Sequence[Number]
Place = tuple[Fraction, Fraction]
PlacedRow = tuple[
    tuple[str, int, int, int, int, int], tuple[str, str], tuple[str, str], tuple[str, str]
]


@dataclass(frozen=True)
class ConvolutionEdge:
    """An exact edge of the convolution. `kind`: S, an edge of P at a vertex of Q, or T, an edge of
    Q at a vertex of P. `edge` and `vertex`: the parents by ring and index; an edge has the index of
    its start. `sign`: -1 at reflex vertices, else 1. `direction`: from `start` to `end`."""

    kind: str
    edge: tuple[int, int]
    vertex: tuple[int, int]
    sign: int
    start: Place
    end: Place
    direction: Place


class Convolution(Sequence[ConvolutionEdge]):
    """The edges of a convolution at one scale, S-edges first. The library holds them: an edge takes
    some microseconds when asked for."""

    def __init__(self, found: _core.Convolution, full: bool, compatible: str) -> None:
        self._found, self.full, self.compatible = found, full, compatible

    def __len__(self) -> int:
        return len(self._found)

    @overload
    def __getitem__(self, index: int) -> ConvolutionEdge: ...
    @overload
    def __getitem__(self, index: slice) -> list[ConvolutionEdge]: ...
    def __getitem__(self, index: int | slice) -> ConvolutionEdge | list[ConvolutionEdge]:
        if isinstance(index, slice):
            return [self[place] for place in range(*index.indices(len(self)))]
        place = index + len(self) if index < 0 else index
        if not 0 <= place < len(self):
            raise IndexError(f"there are {len(self)} edges, and no number {index}")
        return _edge(self._found.rows(place, place + 1)[0])

    def __iter__(self) -> Iterator[ConvolutionEdge]:
        for first in range(0, len(self), CHUNK):
            yield from map(_edge, self._found.rows(first, min(first + CHUNK, len(self))))

    def __repr__(self) -> str:
        which = "full" if self.full else "reduced"
        return f"<Convolution: {len(self)} edges, {which}, {self.compatible}>"


def convolution(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    scale: PlaneScale = 1,
    full: bool = False,
    compatible: str = "half-open",
) -> Convolution:
    """Compute the convolution of P, scaled by `scale` > 0 about the origin, and Q: every edge of
    each operand at each compatible vertex of the other, with the parents. `scale`: one factor, or
    two, one for each axis. Exact.

    Returns the reduced convolution, or with `full` also edges at reflex vertices, with the sign -1.
    `compatible`: the ends that belong to the turn at a vertex. `half-open` is right, and covers the
    sum's boundary; other readings differ if edges of P and Q have one direction: `open` may lose
    parts of the boundary, `closed` covers parts twice. Both operands are validated first. O((m + n)
    log(m + n) + N) for operands with m and n vertices and N edges. Raises BadInput; Refusal for an
    unknown reading; LimitExceeded if the edges need more memory than available. Behar & Lien 2012,
    Sec. 3, 4.1; docs/definitions.md, "Convolution"."""
    expect_sets(P=P, Q=Q)
    if text_of("compatible", compatible) not in COMPATIBLE:
        mend = choice(compatible, COMPATIBLE)
        what = f"there is no reading {compatible!r} of `between`"
        raise Refusal(what, "convolution", mend, "unknown-reading")
    s, with_reflex = scale_text("scale", scale), truth("full", full)
    for name, operand in (("P", P), ("Q", Q)):
        operand.validate(name)
    return Convolution(_core.Convolution(P, Q, s, with_reflex, compatible), full, compatible)


def _edge(row: PlacedRow) -> ConvolutionEdge:
    (kind, sign, edge_ring, edge, vertex_ring, vertex), start, end, direction = row
    return ConvolutionEdge(
        kind, (edge_ring, edge), (vertex_ring, vertex), sign,
        _place(start), _place(end), _place(direction),
    )  # fmt: skip


def _place(texts: tuple[str, str]) -> Place:
    x, y = map(Fraction, texts)
    return x, y
