"""Radii of a disc on a path, in a container and among obstacles, in documents and for people."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref.certain_digits import between
from minkref.cli.output import print_lines
from minkref.disc.disc import ANY, ROOT, Disc, is_disc, read_disc
from minkref.disc.disc_index import OffsetEvent
from minkref.errors import Refusal
from minkref.motion.commands.path_rows import MOST_ROWS, feature_text, number_text, point_text
from minkref.motion.disc_radii import DiscContact, DiscRadii, DiscRadius, RadiusQuestion
from minkref.motion.scale_ranges import CONTACTS
from minkref.output.documents import Stopwatch, document
from minkref.verbs.path import check_words

Row = dict[str, Any]
LONGEST = 24  # characters of a square in a line
CAUSES = {
    "apart": "the places are in different rooms",
    "free": "nothing is in the way",
    "meets": "a place is not free",
}


def question_of(request: Any, second: str) -> RadiusQuestion:
    """Read a request's question. Refuses a disc as the second operand."""
    check_words(contact=(request.contact, CONTACTS))
    if is_disc(second):
        mend = "give the disc first, then a set of polygons"
        raise Refusal("the disc is the part", second, mend)
    asked = None if request.part == ANY else read_disc(request.part).squared_radius
    return RadiusQuestion(request.contact, request.clearance or Fraction(0), asked)


def radii_document(
    name: str, watch: Stopwatch, request: Any, found: DiscRadii, **fields: Any
) -> Row:
    """Make an answer's document, with its question."""
    clearance = request.clearance
    return document(
        name,
        watch,
        part=request.part,
        contact=request.contact,
        clearance=None if clearance is None else str(clearance),
        **fields,
        radii=None if found.is_empty else radii_range(found),
        cause=found.cause,
        touches=None if found.contact is None else _touches(found.contact),
        events=[_event(each) for each in found.events],
        asked=_asked(request.part, found),
    )


def radii_shown(rows: list[tuple[str, str]], verb: str) -> Callable[[Row], None]:
    """A function that prints the given rows, the answer and its causes."""

    def shown(value: Row) -> None:
        clearance = value["clearance"]
        kept = [] if clearance is None else [("clearance", clearance)]
        written = [("written", value["output"])] if value.get("output") else []
        last = [*written, ("seconds", f"{value['seconds']:.3f}")]
        print_lines([*rows, *kept, (verb, range_text(value)), *_causes(value), *last], value)

    return shown


def _asked(part: str, found: DiscRadii) -> Row | None:
    if found.holds is None:
        return None
    return {"radius": read_disc(part).radius, "holds": found.holds}


def radii_range(found: DiscRadii) -> Row:
    return {
        "from": _radius(found.low),
        "from_in": found.low_in,
        "to": _radius(found.high),
        "to_in": found.high_in,
    }


def _radius(radius: DiscRadius | None) -> Row | None:
    if radius is None:
        return None
    low, high = (bound if math.isfinite(bound) else None for bound in radius.bounds)
    square = radius.squared_distance
    return {
        "radius": {"low": low, "high": high},
        "squared_distance": None if square is None else str(square),
        "polynomial": [str(each) for each in radius.polynomial],
    }


def _touches(contact: DiscContact) -> Row:
    feature = contact.obstacle
    return {
        "at": {"segment": contact.segment, "t": str(contact.t), "point": _texts(contact.at)},
        "obstacle": {"edge" if feature.is_edge else "vertex": [feature.ring, feature.index]},
        "touching": _texts(contact.touching),
    }


def _event(event: OffsetEvent) -> Row:
    return {
        "kind": event.kind,
        "place": rounded_place(event.place),
        "features": [
            {"vertex": [first, second]} if kind == "vertex" else {"edge": [int(first), int(second)]}
            for kind, first, second in event.features
        ],
    }


def rounded_place(place: tuple[float, float]) -> list[float | None]:
    """Write a place in doubles; None for a coordinate beyond them."""
    return [c if math.isfinite(c) else None for c in place]


def _texts(place: tuple[Fraction, Fraction]) -> list[str]:
    return [str(place[0]), str(place[1])]


def range_text(value: Row) -> str:
    """All radii, or the answer for one."""
    radii, asked = value["radii"], value["asked"]
    told = "none" if radii is None else distance_text(radii, value["clearance"])
    return told if asked is None else f"{'yes' if asked['holds'] else 'no'}; all radii: {told}"


def distance_text(radii: Row, clearance: str | None = None) -> str:
    """Write a range of radii, or of distances."""
    low = "0" if radii["from"] is None else _radius_text(radii["from"], clearance)
    high = "infinity" if radii["to"] is None else _radius_text(radii["to"], clearance)
    return f"{'[' if radii['from_in'] else '('}{low}, {high}{']' if radii['to_in'] else ')'}"


def _radius_text(radius: Row, clearance: str | None) -> str:
    """Write an expression, or a long one's certain digits."""
    square, less = radius["squared_distance"], Fraction(clearance or 0)
    if square is None or len(square) > LONGEST:
        return f"about {_near(radius)}"
    root = Disc(ANY, Fraction(square)).radius
    if not root.startswith(ROOT):
        return str(Fraction(root) - less)
    return f"sqrt({square})" + (f" - {less}" if less else "")


def _near(radius: Row) -> str:
    return between(**radius["radius"])


def _causes(value: Row) -> list[tuple[str, str]]:
    """Write radii in digits, and features touching at their ends."""
    radii, touches = value["radii"], value["touches"]
    rows = []
    if value["cause"] in CAUSES:
        rows.append(("because", CAUSES[value["cause"]]))
    ends = [] if radii is None else [radii[name] for name in ("from", "to") if radii[name]]
    texts = [(_radius_text(end, value["clearance"]), _near(end)) for end in ends]
    rows += [("about", near) for text, near in texts if text.startswith("sqrt")]
    if touches is not None:
        at = touches["at"]
        place = f"segment {at['segment']}, t = {number_text(at['t'])}, {point_text(at['point'])}"
        feature, touching = feature_text(touches["obstacle"]), point_text(touches["touching"])
        whose = "container" if "container" in value else "obstacles"
        rows.append(("touches", f"{feature} of the {whose}, {touching}; {place}"))
    word = "place" if value["cause"] == "room" else "neck"
    for event in value["events"][:MOST_ROWS]:
        x, y = (f"{c:.9g}" for c in event["place"])
        features = ", ".join(_feature_text(each) for each in event["features"])
        rows.append((word, f"({x}, {y}): {features}"))
    if len(value["events"]) > MOST_ROWS:
        rows.append(("more", f"{len(value['events']) - MOST_ROWS:,}; --json prints all"))
    return rows


def _feature_text(feature: Row) -> str:
    if "vertex" in feature:
        return f"vertex ({', '.join(map(number_text, feature['vertex']))})"
    ring, index = feature["edge"]
    return f"edge {ring}.{index}"
