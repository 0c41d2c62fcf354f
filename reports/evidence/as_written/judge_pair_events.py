"""Radii and places of `minkref events P disc --kind pair`, from the condition that each contact
names (docs/disc.md, "Pair events")."""

from __future__ import annotations

from minkref.reports.evidence.as_written.answers import Answers, Document
from minkref.reports.evidence.as_written.distance import Ring
from minkref.reports.evidence.as_written.equidistant import Edge, Feature, Vertex, distance
from minkref.reports.evidence.as_written.inputs_disc import Drawn
from minkref.reports.evidence.as_written.judge_events import feature
from minkref.reports.evidence.as_written.judge_sum import bounds, rings_of
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import Real

WRITER = "events --kind pair"
LIMIT = 200  # events per set
Direction = tuple[Real, Real]


def judge(tally: Tally, answers: Answers, drawn: Drawn) -> None:
    rings = rings_of(drawn)
    words = ("events", drawn.text, "disc", "--kind", "pair", "--limit", LIMIT)
    for event in answers.document(*words)["events"]:
        features = [feature(rings, row) for row in event["features"]]
        radii = [_contact(tally, one, features, rings) for one in event["contacts"]]
        found = [radius for radius in radii if radius is not None]
        if found:
            bounds(tally, WRITER, event["radius"], found[0], f"the radius of a {event['change']}")


def _contact(
    tally: Tally, contact: Document, features: list[Feature], rings: list[Ring]
) -> Real | None:
    if contact["of"] is None:
        radius, place = _touching(contact["condition"], features)
    else:
        number = int(contact["of"])
        ended, other = features[number], features[1 - number]
        v, m = _end(ended, contact["end"], rings)
        gap = _gap(v, m, other)
        if gap is None:
            return None  # on one line at all radii, or at no radius
        radius, place = gap, (v.x + gap * m[0], v.y + gap * m[1])
    for name, number_told, true in zip("xy", contact["place"], place, strict=True):
        if number_told is None:
            tally.fault(WRITER, "null in place of a number", f"{name}, true {float(true)!r}")
        else:
            tally.number(WRITER, number_told, true, f"{name} of {contact['condition']}")
    return radius


def _normal(edge: Edge) -> Direction:
    a, b, _, _ = edge.row()
    return a, b


def _end(one: Feature, which: str, rings: list[Ring]) -> tuple[Vertex, Direction]:
    """The end v + radius m of an offset edge, or of the arc from one edge's normal to the next."""
    first = which == "first"
    if isinstance(one, Edge):
        return (one.start if first else one.end), _normal(one)
    for ring in rings:
        for k, (x, y) in enumerate(ring):
            if (x, y) == (one.x, one.y):
                before, after = Vertex(*ring[k - 1]), Vertex(*ring[(k + 1) % len(ring)])
                return one, _normal(Edge(before, one) if first else Edge(one, after))
    raise ValueError(f"{one} is no vertex of the set")


def _gap(v: Vertex, m: Direction, other: Feature) -> Real | None:
    """The radius at which v + radius m is on another feature's line or circle."""
    if isinstance(other, Edge):
        n = _normal(other)
        # 1 - n · m, without cancellation
        half = ((n[0] - m[0]) ** 2 + (n[1] - m[1]) ** 2) / 2
        return distance((v.x, v.y), other) / half if half else None
    x, y = v.x - other.x, v.y - other.y
    along = 2 * (m[0] * x + m[1] * y)
    return -(x * x + y * y) / along if along else None


def _touching(condition: str, features: list[Feature]) -> tuple[Real, Direction]:
    one, other = features
    if condition == "circles":
        assert isinstance(one, Vertex) and isinstance(other, Vertex)
        radius = distance((one.x, one.y), other) / 2
        return radius, ((one.x + other.x) / 2, (one.y + other.y) / 2)
    edge, vertex = (one, other) if isinstance(one, Edge) else (other, one)
    assert isinstance(edge, Edge) and isinstance(vertex, Vertex)
    radius = distance((vertex.x, vertex.y), edge) / 2
    n = _normal(edge)
    return radius, (vertex.x - radius * n[0], vertex.y - radius * n[1])
