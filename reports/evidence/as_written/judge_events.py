"""Judges radii and places from `minkref events P disc`, the index and the index's page of numbers,
by the equations of each event's named features (docs/disc.md)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written.answers import Answers, Document
from minkref.reports.evidence.as_written.covering import Neighbourhood
from minkref.reports.evidence.as_written.distance import Ring, to_segment
from minkref.reports.evidence.as_written.equidistant import (
    Edge,
    Feature,
    Solution,
    Vertex,
    between,
    solutions,
)
from minkref.reports.evidence.as_written.inputs_disc import Drawn
from minkref.reports.evidence.as_written.judge_sum import bounds, rings_of
from minkref.reports.evidence.as_written.read_page import page_data
from minkref.reports.evidence.as_written.read_plane import load
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import Real, exact, exact_double

NEAR = gmpy2.mpq(1, 2**400)  # relative: equal radii as numbers of 1,500 bits
PAGE = "page of view with a disc"
LINE = re.compile(r"^ *(\S+)  (\w+): (.*)$", re.M)


def feature(rings: Sequence[Ring], row: dict[str, Any]) -> Feature:
    if "vertex" in row:
        x, y = row["vertex"]
        return Vertex(exact(x), exact(y))
    ring, number = map(int, row["edge"])
    places = rings[ring]
    return Edge(Vertex(*places[number]), Vertex(*places[(number + 1) % len(places)]))


def judge(tally: Tally, answers: Answers, drawn: Drawn) -> None:
    """The document, the table and the index, which lists the same events."""
    rings = rings_of(drawn)
    document = answers.document("events", drawn.text, "disc")
    truth = [_event(tally, "events --json", one, rings) for one in document["events"]]
    with tally.answer("table of events"):
        words = ("events", drawn.text, "disc", "--limit", max(len(truth), 1))
        lines = LINE.findall(answers.table(*words))
        if len(lines) != len(truth):
            tally.fault("table of events", "more or fewer lines than events", str(len(lines)))
        for (number, _, _), true in zip(lines, truth, strict=False):
            if true is not None:
                tally.printed("table of events", number, true[2], "a radius")
    with tally.answer("index"):
        _index(tally, answers, drawn, document)
    with tally.answer(PAGE):
        _page(tally, page_data(answers, "view", drawn.text, "disc"), truth)


def _page(tally: Tally, data: Document, truth: list[Solution | None]) -> None:
    """Radii, and places as seen from the origin of the page."""
    origin = [exact_double(float(axis)) for axis in data["origin"]]
    if len(data["kinds"]) != len(truth):
        tally.fault(PAGE, "more or fewer events than there are", str(len(data["kinds"])))
    for event, (number, true) in enumerate(zip(data["numbers"], truth, strict=False)):
        if true is None:
            continue
        tally.number(PAGE, data["radii"][int(number) - 1], true[2], "a radius")
        for k, axis in enumerate(data["places"][2 * event : 2 * event + 2]):
            tally.number(PAGE, axis, true[k] - origin[k], "a place")


def _event(tally: Tally, writer: str, event: Document, rings: list[Ring]) -> Solution | None:
    features = [feature(rings, row) for row in event["features"]]
    place = [None if number is None else exact(number) for number in event["place"]]
    if None in place:
        tally.fault(writer, "null in place of a number", f"the place of a {event['kind']}")
        return None
    found = _true(event["kind"], features, (place[0], place[1]), rings)
    if found is None:
        tally.fault(
            writer, "no place is as far from its features and from no other less", str(event)[:300]
        )
        return None
    if not all(_as_near(found, one) for one in features):
        tally.fault(writer, "a feature that is not as near", str(event)[:300])
    bounds(tally, writer, event["radius"], found[2], f"the radius of a {event['kind']}")
    for name, number, true in zip("xy", event["place"], found[:2], strict=True):
        tally.number(writer, number, true, f"{name} of a {event['kind']}")
    return found


def _as_near(found: Solution, one: Feature) -> bool:
    a, b = (one.start, one.end) if isinstance(one, Edge) else (one, one)
    far = to_segment(found[:2], ((a.x, a.y), (b.x, b.y)))
    return bool(abs(far - found[2] ** 2) <= found[2] ** 2 * NEAR)


def _true(
    kind: str, features: list[Feature], near: tuple[Any, Any], rings: list[Ring]
) -> Solution | None:
    """The solution nearest to the written place that is equally far from its features, with no edge
    nearer."""
    if kind == "saddle" and len(features) == 2:
        one = between(*features)
        found = [one] if one else []
    else:
        found = list(solutions(features))
    around = Neighbourhood(rings, gmpy2.mpq(1))

    def is_empty(one: Solution) -> bool:
        least = min(to_segment(one[:2], edge) for edge in around.edges)
        return bool(abs(least - one[2] ** 2) <= one[2] ** 2 * NEAR)

    def far(one: Solution) -> Real:
        return max(abs(one[0] - near[0]), abs(one[1] - near[1]))

    return min(filter(is_empty, found), key=far, default=None)


def _index(tally: Tally, answers: Answers, drawn: Drawn, events: Document) -> None:
    """The file has the same events, number for number, and holes end only at listed events."""
    text, _ = answers.file("json", "index", drawn.text, "disc")
    document = load(text)
    for one, other in zip(document["events"], events["events"], strict=True):
        tally.numbers["index"] += 4
        if any(one[name] != other[name] for name in ("radius", "place", "features")):
            tally.fault("index", "another event than in the list", str(one)[:200])
    known = [(one["radius"], one["place"]) for one in events["events"]]
    for hole in document["holes"]:
        tally.numbers["index"] += 4
        if (hole["end"], hole["place"]) not in known:
            tally.fault("index", "a hole ends at no event", str(hole))
