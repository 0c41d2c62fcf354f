"""Features of a set under a growing disc, as values: the merge tree, bars, bridges, notches."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.argument_types import double, expect_sets, number, whole
from minkref.disc.disc_index import Bounds, Number, OffsetEvent, event_of
from minkref.disc.feature_regions import RegionsAt
from minkref.errors import Refusal
from minkref.exact import digest, read_number

Place = tuple[Fraction, Fraction]
FeatureName = tuple[str, str, str]
NEVER = (math.inf, math.inf)


@dataclass(frozen=True)
class FeatureNode:
    """A node of the merge tree. `kind`: reflex or minimum (leaves), merge, hole or outside (roots).
    `alpha`, twice the radius, lies between two neighbouring doubles or equals a double; the
    radius's square is a root of `polynomial`, the lowest coefficient first, and equals
    `squared_radius` if known to be rational. `places`: events, one list for each place or flat
    ridge. A reflex leaf has its `vertex`, and `along`, the primitive direction of the edge that
    leaves the vertex with the wedge on its right. `tie`: only the least place told which child
    lives on. Terms: docs/features.md."""

    number: int
    kind: str
    alpha: Bounds
    squared_radius: Fraction | None
    polynomial: tuple[Fraction, ...]
    parent: int | None
    children: tuple[int, ...]
    places: tuple[tuple[OffsetEvent, ...], ...]
    vertex: Place | None
    along: Place | None
    tie: bool


@dataclass(frozen=True)
class FeatureBar:
    """A feature's life, birth < alpha <= death, between doubles. `leaf` and `end` are numbers of
    nodes. An `essential` bar is the last of its component of the complement; outside it never dies
    (`death` infinite)."""

    leaf: int
    birth: Bounds
    death: Bounds
    end: int
    essential: bool
    tie: bool

    @property
    def persistence(self) -> Bounds:
        """Bounds for death less birth."""
        if self.birth == (0, 0) or math.isinf(self.death[0]):
            return self.death
        low, high = self.death[0] - self.birth[1], self.death[1] - self.birth[0]
        return max(0.0, math.nextafter(low, -math.inf)), math.nextafter(high, math.inf)


@dataclass(frozen=True)
class Bridge:
    """The chord between the points at which an empty disc touches P: `ends` exact, `near` and
    `centre` (of the disc) as nearest doubles; `features` at the ends, as events name them."""

    ends: tuple[tuple[str, str], tuple[str, str]]
    near: tuple[tuple[float, float], tuple[float, float]]
    centre: tuple[float, float]
    features: tuple[FeatureName, FeatureName]


@dataclass(frozen=True)
class LiveFeature:
    """A feature at one alpha: its node and bar, the reflex leaves in it, its bridges, and the
    deepest leaf (`deepest`) with the exact squared depth, none if the depth is infinite, and bounds
    of the depth. `tie`: of several leaves as deep, the least place."""

    node: int
    bar: int
    leaves: tuple[int, ...]
    bridges: tuple[Bridge, ...]
    deepest: int | None
    squared_depth: str | None
    depth: Bounds | None
    tie: bool


@dataclass(frozen=True)
class BridgeTrack:
    """The life of a bridge, birth < alpha < death. `ends`: ("vertex", [x, y]), ("event", [number])
    or ("infinity", [x, y, x, y]). `features`: the pairs that it joins, one after the other."""

    birth: Bounds
    death: Bounds
    ends: tuple[tuple[str, tuple[str, ...]], tuple[str, tuple[str, ...]]]
    features: tuple[tuple[FeatureName, FeatureName], ...]


@dataclass(frozen=True)
class Notch:
    """A reflex vertex to cut at, with its feature's bar and bounds of its depth."""

    vertex: Place
    bar: int
    depth: Bounds
    tie: bool


class Features:
    """The features of `P` under a growing disc of the diameter alpha: components of the points of
    the outer medial axis nearer to P than alpha / 2, as a merge tree and a barcode; and bridges.
    Exact: no tie is broken in the tree; a barcode's ties are marked. Takes O(n log n) beyond the
    index of all radii, and O(b) for the b bridges of each feature that ends. P may be a segment or
    a point, and is validated first. Raises BadInput, LimitExceeded. Behar & Lien 2012, Sec. 8.2;
    docs/features.md."""

    def __init__(self, P: _core.PolygonSet, threads: int = 1) -> None:
        expect_sets(P=P)
        P.validate("P")
        self._found = _core.features(P, max(1, whole("threads", threads)))

    @classmethod
    def of_core(cls, found: _core.Features) -> Features:
        """The value of what the extension module found."""
        value = cls.__new__(cls)
        value._found = found
        return value

    def __repr__(self) -> str:
        return f"<Features: {len(self.bars)} bars, {self._found.track_count} tracks>"

    @cached_property
    def _alphas(self) -> dict[int, tuple[Bounds, Fraction | None, tuple[Fraction, ...]]]:
        """By number of a radius: alpha's bounds, the radius's square, and its polynomial."""
        zero = (Fraction(0), Fraction(1))
        found = {0: ((0.0, 0.0), Fraction(0), zero), self._found.radii + 1: (NEVER, None, ())}
        for which, square, polynomial, (low, high) in self._found.radius_rows():
            exact = None if square is None else Fraction(square)
            found[which] = ((2 * low, 2 * high), exact, tuple(map(Fraction, polynomial)))
        return found

    @cached_property
    def tree(self) -> list[FeatureNode]:
        """The merge tree's nodes, by radius, then by place: children before parents."""
        return [self._node(at, *row) for at, row in enumerate(self._found.nodes())]

    def _node(self, at: int, kind: str, radius: int, parent: int | None, children: list[int],
              places: list[list[int]], end: Any, tie: bool) -> FeatureNode:  # fmt: skip
        alpha, square, polynomial = self._alphas[radius]
        rows = tuple(tuple(event_of(self._found.event(k)) for k in group) for group in places)
        x, y, dx, dy = (None,) * 4 if end is None else map(Fraction, end)
        return FeatureNode(
            at, kind, alpha, square, polynomial, parent, tuple(children), rows,
            None if x is None or y is None else (x, y),
            None if dx is None or dy is None else (dx, dy), tie,
        )  # fmt: skip

    @cached_property
    def bars(self) -> list[FeatureBar]:
        """All bars, in the order of their leaves in the tree."""
        return [
            FeatureBar(
                leaf,
                self._alphas[birth][0],
                NEVER if death is None else self._alphas[death][0],
                end,
                essential,
                tie,
            )
            for leaf, birth, death, end, essential, tie in self._found.bars()
        ]

    @cached_property
    def tracks(self) -> list[BridgeTrack]:
        """The lives of all bridges, by birth. Between two events as many are alive as the boundary
        of P grown by alpha / 2 has corners."""
        return [
            BridgeTrack(
                self._bounds(birth),
                NEVER if death is None else self._bounds(death),
                ((low[0], tuple(low[1])), (high[0], tuple(high[1]))),
                tuple((left, right) for _, left, right in stretches),
            )
            for low, high, birth, death, stretches in self._found.tracks(0, self._found.track_count)
        ]

    def _bounds(self, radius: int) -> Bounds:
        if radius not in self._alphas:
            low, high = self._found.radius(radius)
            self._alphas[radius] = ((2 * low, 2 * high), None, ())
        return self._alphas[radius][0]

    def at(self, alpha: Number) -> list[LiveFeature]:
        """List the features alive at alpha > 0, birth < alpha <= death, with exact bridges."""
        return [_live(*row) for row in self._found.at(str(exact_alpha("alpha", alpha, least=None)))]

    def near(self, alpha: float) -> tuple[Any, Any]:
        """Read all bridges at alpha > 0 in doubles, quickly, as two NumPy arrays: rows (x, y of one
        end, of the other, of the disc's centre, and a bound of the error of each), and rows (number
        of the feature's node, number of its bar), by feature. The list of features and bridges is
        exact; at an event's own alpha those just below."""
        return self._found.near(double("alpha", alpha))

    def regions(self, alpha: Number | None = None) -> RegionsAt:
        """Find the features' regions at alpha > 0, the alpha-shape, and the rest material of a
        closing with the disc. Without alpha: at infinity, where regions fill the convex hull."""
        if alpha is None:
            return RegionsAt(self._found.regions(None))
        radius = exact_alpha("alpha", alpha, least=None) / 2
        return RegionsAt(self._found.regions(str(radius**2)))

    def notches(
        self, alpha: Number, persistence: Number = 0, alpha_to: Number | None = None
    ) -> list[Notch]:
        """List the deepest reflex vertex of each feature alive at alpha whose bar is longer than
        `persistence` (with `alpha_to`: its part from alpha to there), in the order of cuts: the
        longest bar first, then the deepest, then by place. 0 is the limit: each reflex vertex is a
        feature. An essential bar, or one that ends at infinity, is longer than any number.
        `persistence` may be "inf": no notches."""
        is_none = persistence == "inf"
        rows = self._found.notches(
            str(exact_alpha("alpha", alpha)),
            "inf" if is_none else str(exact_alpha("persistence", persistence)),
            None if alpha_to is None else str(exact_alpha("alpha_to", alpha_to)),
        )
        return [
            Notch((Fraction(x), Fraction(y)), bar, depth, tie) for x, y, bar, depth, tie in rows
        ]

    def canonical_json(self) -> str:
        """The merge tree in rational numbers, the same for each way to write P."""
        return self._found.canonical_json()

    @property
    def digest(self) -> str:
        """The SHA-256 of the canonical JSON."""
        return digest(self.canonical_json())


def features(P: _core.PolygonSet, threads: int = 1) -> Features:
    """Find the features of P under a growing disc: see Features."""
    return Features(P, threads)


def exact_alpha(name: str, value: Number, least: int | None = 0) -> Fraction:
    """Read a diameter, 0 or more; above 0 without `least`."""
    where, mend = f"{name} {value}", "give a number, as 7/5"
    found = read_number(number(name, value), name, where, mend)
    if found < 0 or (least is None and found == 0):
        what = "is negative" if found < 0 else "is 0"
        raise Refusal(f"{name} {what}", where, "give a number above 0", f"bad-{name}")
    return found


def _live(node: int, bar: int, leaves: list[int], deepest: Any, bridges: Any) -> LiveFeature:
    leaf, squared, depth, tie = deepest or (None, None, None, False)
    return LiveFeature(
        node, bar, tuple(leaves), tuple(_bridge(*row) for row in bridges), leaf, squared, depth, tie
    )


def _bridge(a: Any, feature: FeatureName, b: Any, other: FeatureName, centre: Any) -> Bridge:
    return Bridge(
        ((a[0], a[1]), (b[0], b[1])), ((a[2], a[3]), (b[2], b[3])), (centre[2], centre[3]),
        (feature, other),
    )  # fmt: skip
