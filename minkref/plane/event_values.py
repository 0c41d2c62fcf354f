"""Events of two operands, as values: the list of `minkref events`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, overload

from minkref import _core
from minkref.argument_types import expect_sets, number, text_of, truth
from minkref.errors import Refusal, choice
from minkref.exact import exact_scale, text_of_bounds
from minkref.plane.eroded import eroding_pair
from minkref.plane.event_lists import BoundaryEventList, EventList, find_events
from minkref.plane.operand import Operand

KINDS = ("pair", "parallel", "triple", "arrangement", "boundary", "topology")
PAIR_KINDS = ("pair", "parallel")
ROUTED_KINDS = ("boundary", "topology")  # found by each of ROUTES
ROUTES = ("dynamic", "index", "winding")
CONVOLUTIONS = ("dynamic", "winding")  # routes that follow the reduced and the full convolution
FORMS = ("corrected", "printed")
MOST_ROWS = 20  # of a table in a notebook
Number = str | int | Fraction
Place = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Parent:
    """An edge of the convolution: the kind S or T, ring and index of the edge (on P for S, on Q for
    T), ring and index of the other operand's vertex."""

    kind: str
    edge: tuple[int, int]
    vertex: tuple[int, int]


@dataclass(frozen=True)
class Event:
    """An exact change at a critical scale. `rank`: the number of different scales below in the
    list. `change`: birth, death, touch, overlap, swap, merge or split. `at`: the place; `to`: the
    other end if parallel edges share a segment. A topology event also names its feature (hole or
    component), the feature's numbers before and after, and its number of parts at the scale. Terms:
    docs/definitions.md."""

    scale: Fraction
    rank: int
    kind: str
    change: str
    parents: tuple[Parent, ...]
    at: Place
    to: Place | None = None
    feature: str | None = None
    before: tuple[int, ...] = ()
    after: tuple[int, ...] = ()
    parts: int | None = None


@dataclass(frozen=True)
class Life:
    """The scales between which a hole or component lives; None for a beginning or end outside the
    window. Hole 0 means the outside."""

    number: int
    birth: Fraction | None
    death: Fraction | None


class Events(Sequence[Event]):
    """A list of events, ascending by scale. The library holds millions: an event takes some
    microseconds when asked for."""

    def __init__(self, found: EventList, kind: str) -> None:
        self._found, self.kind = found, kind

    def __len__(self) -> int:
        return len(self._found)

    @overload
    def __getitem__(self, index: int) -> Event: ...
    @overload
    def __getitem__(self, index: slice) -> list[Event]: ...
    def __getitem__(self, index: int | slice) -> Event | list[Event]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        place = index + len(self) if index < 0 else index
        if not 0 <= place < len(self):
            raise IndexError(f"there are {len(self)} events, and no number {index}")
        return _event(self._found.events(place, place + 1)[0])

    def __iter__(self) -> Iterator[Event]:
        for first in range(0, len(self), 1024):
            yield from map(_event, self._found.events(first, min(first + 1024, len(self))))

    def __repr__(self) -> str:
        return f"<Events: {len(self)} {self.kind} events at {self.distinct} scales>"

    def _repr_html_(self) -> str:
        """The table in a notebook, of the first events."""
        cells = "".join(
            f"<tr><td>{event.scale}</td><td>{event.kind}</td><td>{event.change}</td>"
            f"<td>{event.feature or ''}</td></tr>"
            for event in self[:MOST_ROWS]
        )
        heads = "".join(f"<th>{head}</th>" for head in ("scale", "kind", "change", "feature"))
        return f"<p>{repr(self)[1:-1]}</p><table><tr>{heads}</tr>{cells}</table>"

    @property
    def distinct(self) -> int:
        """The number of different scales."""
        return self._found.distinct

    @property
    def holes(self) -> list[Life]:
        """All holes ever, by number; for topology events only."""
        return self._lives("holes")

    @property
    def components(self) -> list[Life]:
        """All components ever, by number; for topology events only."""
        return self._lives("components")

    def _lives(self, name: str) -> list[Life]:
        rows = self._found.features()[name]
        if rows is None:
            what = f"{self.kind} events know no {name}"
            raise Refusal(what, name, 'ask for kind="topology"', "unknown-feature")
        return [Life(row["id"], _scale(row["birth"]), _scale(row["death"])) for row in rows]


def events(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    kind: str = "boundary",
    from_scale: Number | None = None,
    to_scale: Number | None = None,
    *,
    route: str = "dynamic",
    form: str = "corrected",
    where: str | None = None,
    erode: bool = False,
) -> Events:
    """Find all events of one kind in the closed window of scales, exact, ascending: `pair`,
    `parallel`, `triple` and `arrangement` for a convolution, `boundary` and `topology` for the sum.

    Without bounds, all scales above 0. `route`: `dynamic` follows the reduced convolution,
    `winding` the full one with winding numbers, which has more pair, parallel and triple events,
    and `index` the swept sum. They give the same boundary and topology events; the index is faster
    for large operands. On the route `winding` parents are numbered along the rings of operands cut
    by slits, if they have holes. `form`: `printed` for the paper's own rule for pair and parallel
    events. `where`: keeps only events that meet a condition, as in
    `minkref events --where`. `erode`: boundary and topology events of the erosion of the scaled P
    by Q instead of the sum, by the routes `dynamic` and `index`; docs/erosion.md. Pair events take
    O(n^2 log n) for n edges of the convolution; docs/scale-index.md has the cost of the index and
    of other events. Raises BadInput, Refusal. Behar & Lien 2012, Sec. 4."""
    expect_sets(P=P, Q=Q)
    names = (("kind", kind, KINDS), ("route", route, ROUTES), ("form", form, FORMS))
    for name, word, known in names:
        if text_of(name, word) not in known:
            what = f"there is no {name} {word!r}"
            raise Refusal(what, "events", choice(word, known), f"unknown-{name}")
    if route not in CONVOLUTIONS and kind not in ROUTED_KINDS:
        what = f"{kind} events come from the arrangement of a convolution: no index has them"
        raise Refusal(what, f"route={route!r}", f"use {' or '.join(CONVOLUTIONS)}")
    if truth("erode", erode) and (kind not in ROUTED_KINDS or route == "winding"):
        what = f"there are no {kind} events of an erosion by the route {route}"
        mend = "ask for boundary or topology events by the routes dynamic or index"
        raise Refusal(what, "erode=True", mend)
    if form != FORMS[0] and kind not in PAIR_KINDS:
        what = "the printed form has pair and parallel events only"
        raise Refusal(what, f"kind={kind!r}", "leave out one of the two")
    for name, operand in (("P", P), ("Q", Q)):
        operand.validate(name, not erode)
    bounds = (("from_scale", from_scale), ("to_scale", to_scale))
    window = [None if bound is None else number(name, bound) for name, bound in bounds]
    found: EventList
    outside, covered = None, window
    if erode:
        pair = eroding_pair(Operand("P", "P", P), Operand("Q", "Q", Q))
        given = [None if bound is None else Fraction(exact_scale(bound, "")) for bound in window]
        covered = text_of_bounds(*pair.window(*given))
        P, Q, outside = pair.P.set, pair.Q.set, pair.outside
    if route == "index":
        found = BoundaryEventList(
            _core.ScaleIndex(P, Q, covered[0], covered[1]), kind, window, outside
        )
    else:
        found = find_events(P, Q, covered, kind, form, route, outside)
    if where is not None:
        from minkref.plane.event_filter import read_filter  # the parser takes longest to import

        found.keep(read_filter(text_of("where", where), kind))
    return Events(found, kind)


def _event(row: dict[str, Any]) -> Event:
    parents = (
        Parent(edge["kind"], tuple(edge["edge"]), tuple(edge["vertex"])) for edge in row["parents"]
    )
    return Event(
        Fraction(row["s"]), row["rank"], row["kind"], row["change"], tuple(parents),
        _place(row["at"]), _place(row["to"]) if row["to"] else None, row.get("feature"),
        tuple(row.get("before", ())), tuple(row.get("after", ())), row.get("parts"),
    )  # fmt: skip


def _place(texts: Sequence[str]) -> Place:
    x, y = map(Fraction, texts)
    return x, y


def _scale(text: str | None) -> Fraction | None:
    return None if text is None else Fraction(text)
