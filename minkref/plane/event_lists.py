"""Lists of events of any kind: counts, and the events in order."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from itertools import compress
from typing import Any, Protocol

from minkref import _core
from minkref.plane.parents import parents


class EventList(Protocol):
    """Exact events, ascending."""

    seconds: float  # to find the events

    def __len__(self) -> int: ...

    @property
    def distinct(self) -> int:
        """The number of different scales."""
        ...

    def keep(self, condition: _core.EventCondition) -> None:
        """Drop all events that fail the condition; ranks still count all events."""
        ...

    def events(self, first: int, last: int) -> list[dict[str, Any]]:
        """List events in the form of the published schema."""
        ...

    def json(self, first: int, last: int, end: str) -> bytes:
        """Write the events as JSON texts, each followed by `end`."""
        ...

    def features(self) -> dict[str, Any]:
        """Return `holes` and `components` through the scales, for topology events; null
        otherwise."""
        ...


NO_FEATURES: dict[str, Any] = {"holes": None, "components": None}


class _EventsOfEdges:
    """Events kept in C++, with their edges written once."""

    def __init__(
        self,
        found: _core.PairEvents | _core.ArrangementEvents,
        listed: _core.PairEvents | _core.ArrangementList,
    ) -> None:
        self.seconds = found.seconds
        self._listed = listed
        self._edges = [parents(row) for row in found.edges()]
        self._edge_texts = [json.dumps(edge) for edge in self._edges]

    def __len__(self) -> int:
        return len(self._listed)

    @property
    def distinct(self) -> int:
        return self._listed.distinct()

    def keep(self, condition: _core.EventCondition) -> None:
        self._listed.keep(condition)

    def json(self, first: int, last: int, end: str) -> bytes:
        return self._listed.json(first, last, self._edge_texts, end)

    def features(self) -> dict[str, Any]:
        return NO_FEATURES


class PairEventList(_EventsOfEdges):
    """Pair or parallel events."""

    def __init__(self, found: _core.PairEvents) -> None:
        super().__init__(found, found)
        self.found = found

    def events(self, first: int, last: int) -> list[dict[str, Any]]:
        edges = self._edges
        return [
            {
                "s": scale,
                "rank": rank,
                "kind": "parallel" if parallel else "pair",
                "change": change,
                "parents": [edges[a], edges[b]],
                "at": list(at),
                "to": list(to) if to else None,
            }
            for scale, rank, change, parallel, a, b, at, to in self.found.rows(first, last)
        ]


class ArrangementEventList(_EventsOfEdges):
    """Triple events, or all arrangement events."""

    def __init__(self, found: _core.ArrangementEvents, kind: str) -> None:
        self._list = _core.ArrangementList(found, kind)
        super().__init__(found, self._list)

    def events(self, first: int, last: int) -> list[dict[str, Any]]:
        edges = self._edges
        return [
            {
                "s": scale,
                "rank": rank,
                "kind": kind,
                "change": change,
                "parents": [edges[e] for e in which],
                "at": list(at),
                "to": list(to) if to else None,
            }
            for scale, rank, kind, change, which, at, to in self._list.rows(first, last)
        ]


class BoundaryEventList:
    """Boundary events, or topology events with the life of every hole and component."""

    def __init__(
        self,
        found: _core.DynamicSum | _core.ScaleIndex,
        kind: str,
        window: Sequence[str | None] = (None, None),
        outside: _core.Outside | None = None,
    ) -> None:
        """Keep the events inside `window`, a part of the window of `found`. `outside`: the sum's
        first operand for an erosion, whose components are the sum's holes, and vice versa."""
        self.found = found
        self._eroded = outside is not None
        self._low, self._high = (None if b is None else Fraction(b) for b in window)
        self.seconds = found.seconds
        rows = found.edges()
        if outside is not None:
            rows = [outside.in_operands(row) for row in rows]
        edges = [parents(row) for row in rows]
        self._kind = kind
        self._events: list[dict[str, Any]] = []
        at_scale: dict[str, list[dict[str, Any]]] = {}
        for scale, change, which, place in found.boundary_events():
            if not self._holds(scale):
                continue
            at_scale[scale] = [edges[e] for e in which]
            if kind == "boundary":
                self._add(scale, change, at_scale[scale], place)
        if kind == "topology":
            for scale, feature, change, before, after, parts, place in found.topology_events():
                if not self._holds(scale):
                    continue
                self._add(scale, change, at_scale[scale], place)
                if self._eroded:
                    feature, before, after = _of_erosion(feature, before, after)
                self._events[-1].update(feature=feature, before=before, after=after, parts=parts)
        self._rank()

    def _holds(self, scale: str) -> bool:
        s = Fraction(scale)
        return (self._low is None or s >= self._low) and (self._high is None or s <= self._high)

    def _life(
        self, name: int, birth: Fraction | None, death: Fraction | None
    ) -> dict[str, Any] | None:
        """Describe a life with its events inside the window; None without scales inside."""
        if birth is not None and self._high is not None and birth > self._high:
            return None
        if death is not None and self._low is not None and death < self._low:
            return None
        texts = [None if s is None else str(s) for s in (birth, death)]
        kept = [None if s is None or not self._holds(s) else s for s in texts]
        return {"id": name, "birth": kept[0], "death": kept[1]}

    def _add(
        self, scale: str, change: str, edges: list[dict[str, Any]], place: tuple[str, str]
    ) -> None:
        self._events.append(
            {
                "s": scale,
                "rank": 0,
                "kind": self._kind,
                "change": change,
                "parents": edges,
                "at": list(place),
                "to": None,
            }
        )

    def _rank(self) -> None:
        for i, event in enumerate(self._events[1:]):
            event["rank"] = self._events[i]["rank"] + (event["s"] != self._events[i]["s"])

    def keep(self, condition: _core.EventCondition) -> None:
        kept = _core.matching_rows([_row(event) for event in self._events], condition)
        self._events = list(compress(self._events, kept))

    def __len__(self) -> int:
        return len(self._events)

    @property
    def distinct(self) -> int:
        return len({event["rank"] for event in self._events})

    def events(self, first: int, last: int) -> list[dict[str, Any]]:
        return self._events[first:last]

    def json(self, first: int, last: int, end: str) -> bytes:
        return "".join(json.dumps(event) + end for event in self.events(first, last)).encode()

    def features(self) -> dict[str, Any]:
        if self._kind != "topology":
            return NO_FEATURES

        def lives(kind: str) -> list[dict[str, Any]]:
            return [life for row in self.found.lives(kind) if (life := self._life(*row))]

        holes, components = lives("hole"), lives("component")
        if not self._eroded:
            return {"holes": holes, "components": components}
        left = [{**life, "id": life["id"] - 1} for life in holes]
        return {"holes": [life for life in components if life["id"] > 0], "components": left}


def find_events(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    window: list[str | None],
    kind: str,
    form: str,
    route: str,
    outside: _core.Outside | None = None,
) -> EventList:
    """Find events of one kind within the closed window. `route`: dynamic follows the reduced
    convolution, winding the full one. `outside`, P being its set: find the erosion's events.
    Exact."""
    low, high = window
    if kind in ("pair", "parallel"):
        return PairEventList(_core.pair_events(P, Q, low, high, kind, form, route))
    if kind in ("triple", "arrangement"):
        return ArrangementEventList(_core.ArrangementEvents(P, Q, low, high, route), kind)
    return BoundaryEventList(_core.DynamicSum(P, Q, low, high, route), kind, outside=outside)


def _of_erosion(
    feature: str, before: list[int], after: list[int]
) -> tuple[str, list[int], list[int]]:
    """Translate a change of an outside's sum to the erosion. Sums number holes from 1, components
    from 0, the box's own."""
    if feature == "component":
        return "hole", before, after
    return "component", [number - 1 for number in before], [number - 1 for number in after]


def _row(event: dict[str, Any]) -> Any:
    """Convert an event to the extension module's row."""
    edges = [(edge["kind"], 1, *edge["edge"], *edge["vertex"]) for edge in event["parents"]]
    x, y = event["at"]
    common = (event["s"], event["rank"], event["kind"], event["change"], edges, (x, y))
    features = [event.get(name, []) for name in ("before", "after")]
    return (*common, event.get("feature", ""), *features, event.get("parts", 0))
