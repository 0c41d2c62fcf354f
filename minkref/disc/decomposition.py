"""Pieces of a set, cut at the notches of its features, as values."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.disc.disc_index import Bounds, Number
from minkref.disc.features import FeatureBar, Features, Notch, Place
from minkref.output.terminal import counted
from minkref.plane.small_picture import small_picture


@dataclass(frozen=True)
class Cut:
    """A segment from a notch, given by its number, to the nearest wall within the directions that
    resolve the notch. `wall`: number of an earlier cut at the end; None on P's boundary."""

    start: Place
    end: Place
    notch: int
    wall: int | None

    @property
    def squared_length(self) -> Fraction:
        return (self.end[0] - self.start[0]) ** 2 + (self.end[1] - self.start[1]) ** 2


@dataclass(frozen=True)
class Piece:
    """The closure of a component of P's interior without the cuts, in canonical form. `slits`:
    parts of cuts with the piece on both sides."""

    region: _core.PolygonSet
    slits: tuple[tuple[Place, Place], ...]

    @cached_property
    def is_convex(self) -> bool:
        return self.region.is_convex

    @cached_property
    def bars(self) -> list[FeatureBar]:
        """The bars of the piece itself, slits left out: see Features. None of a convex piece."""
        return [] if self.is_convex else Features(self.region).bars

    @property
    def endless_bars(self) -> int:
        """Count the bars that never end: one or more unless the outer ring is convex."""
        return sum(math.isinf(bar.death[0]) for bar in self.bars)

    @property
    def longest_bar(self) -> Bounds | None:
        """Bounds for the persistence of the longest bar that ends; None without any."""
        ends = [bar.persistence for bar in self.bars if math.isfinite(bar.death[0])]
        return (max(low for low, _ in ends), max(high for _, high in ends)) if ends else None


@dataclass(frozen=True)
class Decomposition:
    """All notches in the order of cutting, cuts, and pieces in the canonical order of their outer
    rings. Earlier cuts resolve each notch without a cut. `features`: P's."""

    features: Features = field(repr=False, compare=False)
    notches: tuple[Notch, ...]
    cuts: tuple[Cut, ...]
    pieces: tuple[Piece, ...]

    def _repr_svg_(self) -> str:
        """The picture in a notebook: pieces, and cuts as lines."""
        cuts = [[cut.start, cut.end] for cut in self.cuts]
        caption = f"{counted(len(self.pieces), 'piece')}, {counted(len(self.cuts), 'cut')}"
        return small_picture([piece.region for piece in self.pieces], caption, cuts)

    @property
    def bars(self) -> list[FeatureBar]:
        """The bar of each notch's feature."""
        return [self.features.bars[notch.bar] for notch in self.notches]

    @property
    def skipped(self) -> list[int]:
        """The numbers of all notches without a cut."""
        have_cuts = {cut.notch for cut in self.cuts}
        return [number for number in range(len(self.notches)) if number not in have_cuts]


def decompose(
    P: _core.PolygonSet,
    alpha: Number = 0,
    persistence: Number = 0,
    alpha_to: Number | None = None,
    threads: int = 1,
) -> Decomposition:
    """Cut P at its notches: the deepest reflex vertex of each feature alive at the diameter `alpha`
    whose bar is longer than `persistence`; with `alpha_to`, the part of the bar from alpha to
    there. Each cut in turn goes from its notch to the nearest wall (P's boundary and earlier cuts)
    within the closed cone that resolves the notch; as near: to the lexicographically least point.

    Exact; all ends are rational. The pieces tile P, and are at most as many as notches and
    components of the interior; with 0 and 0 all are convex. Larger persistence gives fewer notches.
    O(n log n) beyond the features. P may be a segment or a point, without pieces, and is validated
    first. Raises BadInput, LimitExceeded. Behar & Lien 2012, Sec. 8.2; docs/features.md."""
    found = Features(P, threads)
    notches = tuple(found.notches(alpha, persistence, alpha_to))
    places = [(str(notch.vertex[0]), str(notch.vertex[1])) for notch in notches]
    cuts, pieces = _core.cut_at_notches(P, places)
    return Decomposition(
        found,
        notches,
        tuple(Cut(_place(start), _place(end), notch, wall) for start, end, notch, wall in cuts),
        tuple(
            Piece(region, tuple((_place(a), _place(b)) for a, b in slits))
            for region, slits in pieces
        ),
    )


def _place(point: Any) -> Place:
    return Fraction(point[0]), Fraction(point[1])
