"""The events that `minkref events` lists, whatever their kind: counts, and the events in order."""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from fractions import Fraction
from typing import Any, Protocol

from minkref import _core
from minkref.parents import parents
from minkref.progress import progress
from minkref.scale_space import cores

CHUNK = 32768  # events at a time


class EventList(Protocol):
    """Exact events, ascending."""

    seconds: float  # of finding them

    def __len__(self) -> int: ...

    @property
    def distinct(self) -> int:
        """Different scales."""
        ...

    def events(self, first: int, last: int) -> list[dict[str, Any]]:
        """As the published schema has them."""
        ...

    def json(self, first: int, last: int, end: str) -> bytes:
        """The same as JSON texts, each followed by `end`."""
        ...

    def features(self) -> dict[str, Any]:
        """`holes` and `components` through the scales, for topology events; null otherwise."""
        ...


NO_FEATURES: dict[str, Any] = {"holes": None, "components": None}


class PairEventList:
    """Pair or parallel events."""

    def __init__(self, found: _core.PairEvents) -> None:
        self.found = found
        self.seconds = found.seconds
        self._edges = [parents(row) for row in found.edges()]
        self._edge_texts = [json.dumps(edge) for edge in self._edges]

    def __len__(self) -> int:
        return len(self.found)

    @property
    def distinct(self) -> int:
        return int(self.found.counts()["distinct"])

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

    def json(self, first: int, last: int, end: str) -> bytes:
        return self.found.json(first, last, self._edge_texts, end)

    def features(self) -> dict[str, Any]:
        return NO_FEATURES


class ArrangementEventList:
    """Triple events, or all arrangement events."""

    def __init__(self, found: _core.ArrangementEvents, kind: str) -> None:
        self.found = found
        self.seconds = found.seconds
        self.which = found.of_kind(kind)
        self._edges = [parents(row) for row in found.edges()]
        self._ranks = found.ranks(self.which)

    def __len__(self) -> int:
        return len(self.which)

    @property
    def distinct(self) -> int:
        return self._ranks[-1] + 1 if self._ranks else 0

    def events(self, first: int, last: int) -> list[dict[str, Any]]:
        edges = self._edges
        rows = self.found.rows(self.which[first:last])
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
            for rank, (scale, kind, change, which, at, to) in zip(
                self._ranks[first:last], rows, strict=True
            )
        ]

    def json(self, first: int, last: int, end: str) -> bytes:
        return _as_json(self.events(first, last), end)

    def features(self) -> dict[str, Any]:
        return NO_FEATURES


class BoundaryEventList:
    """Boundary events, or topology events with the life of every hole and component."""

    def __init__(
        self,
        found: _core.DynamicSum | _core.ScaleSpaceIndex,
        kind: str,
        window: Sequence[str | None] = (None, None),
    ) -> None:
        """`window`: a part of that of `found`."""
        self.found = found
        self._low, self._high = (None if b is None else Fraction(b) for b in window)
        self.seconds = found.seconds
        edges = [parents(row) for row in found.edges()]
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
                self._events[-1].update(feature=feature, before=before, after=after, parts=parts)
        self._rank()

    def _holds(self, scale: str) -> bool:
        s = Fraction(scale)
        return (self._low is None or s >= self._low) and (self._high is None or s <= self._high)

    def _life(self, name: int, birth: str | None, death: str | None) -> dict[str, Any] | None:
        """With what happens in the window; none if that holds no scale of it."""
        if birth is not None and self._high is not None and Fraction(birth) > self._high:
            return None
        if death is not None and self._low is not None and Fraction(death) < self._low:
            return None
        kept = [None if s is None or not self._holds(s) else s for s in (birth, death)]
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
        self._distinct = 0
        for i, event in enumerate(self._events):
            self._distinct += i == 0 or event["s"] != self._events[i - 1]["s"]
            event["rank"] = self._distinct - 1

    def __len__(self) -> int:
        return len(self._events)

    @property
    def distinct(self) -> int:
        return self._distinct

    def events(self, first: int, last: int) -> list[dict[str, Any]]:
        return self._events[first:last]

    def json(self, first: int, last: int, end: str) -> bytes:
        return _as_json(self.events(first, last), end)

    def features(self) -> dict[str, Any]:
        if self._kind != "topology":
            return NO_FEATURES

        def lives(kind: str) -> list[dict[str, Any]]:
            return [life for row in self.found.lives(kind) if (life := self._life(*row))]

        return {"holes": lives("hole"), "components": lives("component")}


def find_events(
    P: _core.PolygonSet, Q: _core.PolygonSet, window: list[str | None], kind: str, form: str
) -> EventList:
    """Events of one kind within the closed window. Exact."""
    if kind in ("pair", "parallel"):
        return PairEventList(_core.pair_events(P, Q, window[0], window[1], kind, form))
    if kind in ("triple", "arrangement"):
        return ArrangementEventList(_core.ArrangementEvents(P, Q, window[0], window[1]), kind)
    return BoundaryEventList(_core.DynamicSum(P, Q, window[0], window[1]), kind)


def _as_json(events: list[dict[str, Any]], end: str) -> bytes:
    return "".join(json.dumps(event) + end for event in events).encode()


def json_pieces(found: EventList, count: int, end: str) -> Iterator[bytes]:
    """The first `count` events as JSON texts, each followed by `end`, some thousand at a time and
    by all cores; progress on a terminal."""
    firsts = iter(range(0, min(count, len(found)), CHUNK))
    workers = cores()
    with progress(count) as line, ThreadPoolExecutor(workers) as pool:
        line.now("writing events")
        waiting: deque[Future[bytes]] = deque()

        def begin() -> None:
            first = next(firsts, None)
            if first is not None:
                last = min(first + CHUNK, count)
                waiting.append(pool.submit(found.json, first, last, end))

        for _ in range(2 * workers):
            begin()
        while waiting:
            yield waiting.popleft().result()
            begin()
            line.done(CHUNK)
