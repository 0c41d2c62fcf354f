"""JSON documents that the command reads and prints. Numbers may be texts, integers or decimals,
read exactly as written; they are printed as n or n/d."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from .disc.disc import AlgebraicScale, Arc
from .disc.disc_contact import DiscEvent, Feature, polygon_events
from .disc.radicals import Radical
from .moving import KINDS, MovingSegment, parallel, point_text, s_edge, t_edge
from .pairs import Event, Interval, contact_set, pair_events
from .parallels import always_on_one_line, parallel_events
from .rational import rational, text
from .space.space_events import (
    Coming,
    edge_contact,
    facet_contact,
    four_event,
    plane_event,
    vertex_event,
)
from .space.space_moving import SpaceSegment, SpaceVertex, facet, vector
from .triples import ends_passed, meeting_scales, triple_events

Document = dict[str, Any]


class RequestError(ValueError):
    """A request without an answer; the text says what is wrong and what to ask."""


def parsed(source: str) -> Document:
    """Parse a JSON object; decimals keep their text."""
    try:
        found = json.loads(source, parse_float=str)
    except ValueError as error:
        raise RequestError(f"the request is no JSON: {error}") from error
    if not isinstance(found, dict):
        raise RequestError("the request is no JSON object")
    return found


def segments(request: Document, count: int) -> list[MovingSegment]:
    found = []
    for each in request["segments"]:
        (start, end), vertex = each["edge"], each["vertex"]
        if each["kind"] not in KINDS:
            raise RequestError(f"the kind of a segment is S or T, not {each['kind']!r}")
        scales = each["kind"] == "S"
        found.append(s_edge(start, end, vertex) if scales else t_edge(vertex, start, end))
    if len(found) != count:
        raise RequestError(f"{count} segments are asked for, {len(found)} given")
    return found


def interval(found: Interval | None) -> Document | None:
    if found is None:
        return None
    low, high = found.low, found.high
    return {"low": low and text(low), "high": high and text(high)}


def event(found: Event) -> Document:
    to = None if found.to is None else point_text(found.to)
    return {"s": text(found.s), "change": found.change, "at": point_text(found.at), "to": to}


def answer_pair(request: Document) -> Document:
    a, b = segments(request, 2)
    return {
        "contact": interval(contact_set(a, b)),
        "events": [event(each) for each in pair_events(a, b)],
    }


def answer_parallel(request: Document) -> Document:
    a, b = segments(request, 2)
    if not parallel(a, b):
        raise RequestError("the segments are not parallel; ask for `pair`")
    return {
        "always_on_one_line": always_on_one_line(a, b),
        "contact": interval(contact_set(a, b)),
        "events": [event(each) for each in parallel_events(a, b)],
    }


def answer_triple(request: Document) -> Document:
    a, b, c = segments(request, 3)
    return {
        "scales": [interval(each) for each in meeting_scales((a, b, c))],
        "events": [event(each) for each in triple_events((a, b, c))],
        "ends_passed": [{**event(each), "third": n} for each, n in ends_passed((a, b, c))],
    }


def coming(found: Coming) -> Document:
    return {
        "case": found.case,
        "s": found.s and text(found.s),
        "meet": found.meet,
        "at": found.at and [text(x) for x in found.at],
    }


def space_segment(each: Document) -> SpaceSegment:
    first, last = (
        SpaceVertex(vector(p), vector(q))
        for p, q in zip(
            each["P"] * (3 - len(each["P"])), each["Q"] * (3 - len(each["Q"])), strict=True
        )
    )
    return SpaceSegment(each["kind"], first, last)


def answer_facets(request: Document) -> Document:
    if "edges" in request:
        a, b = (space_segment(each) for each in request["edges"])
        return {"contact": interval(edge_contact(a, b))}
    facets = [facet(each["kind"], each["P"], each["Q"]) for each in request["facets"]]
    if len(facets) == 1:
        vertex = SpaceVertex(vector(request["vertex"]["p"]), vector(request["vertex"]["q"]))
        return coming(vertex_event(facets[0], vertex))
    if len(facets) == 4:
        return coming(four_event(facets))
    if len(facets) != 2:
        raise RequestError("one facet and a vertex, two facets, or four are asked for")
    found = plane_event(facets[0], facets[1])
    contact = facet_contact(facets[0], facets[1]) if found.case == "always" else []
    return {**coming(found), "contact": [interval(each) for each in contact]}


def radical(value: Radical) -> list[Document]:
    return [{"of": m, "times": text(c)} for m, c in value.terms]


def scale(found: AlgebraicScale) -> Document:
    bounds: Sequence[Any] = found.interval or ()
    return {
        "s": radical(found.value) if found.value is not None else None,
        "polynomial": list(found.polynomial),
        "interval": [text(x) for x in bounds],
    }


def feature(found: Feature) -> Document:
    if isinstance(found, Arc):
        return {"arc": point_text(found.centre)}
    return {"edge": [point_text(found.p), point_text(found.q)]}


def disc_event(found: DiscEvent) -> Document:
    return {
        **scale(found.scale),
        "change": found.name,
        "features": [feature(found.first), feature(found.second)],
        "at": [radical(x) for x in found.at or ()],
    }


def answer_disc(request: Document) -> Document:
    radius = rational(request.get("radius", 1))
    if radius <= 0 or len(request["polygon"]) < 3:
        raise RequestError(
            "a polygon of three vertices or more and a positive radius are asked for"
        )
    return {"events": [disc_event(each) for each in polygon_events(request["polygon"], radius)]}
