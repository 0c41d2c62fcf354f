"""How large a disc may be on a path, in a container and among obstacles, as values."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import coordinates, expect_sets, number, whole
from minkref.disc.disc_index import Bounds, OffsetEvent, event_of
from minkref.disc.eroded import eroded_by_disc
from minkref.errors import Refusal
from minkref.exact import read_number
from minkref.motion.path_values import Feature, Place
from minkref.motion.scale_ranges import CONTACTS, Number, path_of, word_of

BOX = 0  # the ring of an outside that is none of the container's
NamedFeature = Callable[[bool, int, int], Feature]


@dataclass(frozen=True)
class DiscRadius:
    """A square root less a clearance. `bounds`: neighbouring doubles around it, equal for a double;
    `squared_distance`: the radicand, if known as rational; `polynomial`: with the radicand as a
    root, lowest coefficient first."""

    bounds: Bounds
    squared_distance: Fraction | None
    polynomial: tuple[Fraction, ...]


@dataclass(frozen=True)
class DiscContact:
    """A contact of the disc: its place on the path (segment, fraction of the segment, point), the
    feature of the obstacles or the container, the touching point."""

    segment: int
    t: Fraction
    at: Place
    obstacle: Feature
    touching: Place


@dataclass(frozen=True)
class DiscRadii:
    """A range of radii: above `low` (None: 0), below `high` (None: no end), ends included if
    `low_in`, `high_in`; `is_empty`: no radius. `cause` names the greatest radius's limit, or a
    trap's least one: "contact", "neck", "room" (a container's largest disc), "apart" (no way),
    "meets" (a place or path is not free), "free" (nothing). `contact`: at `high`, or where a path
    first meets the obstacles. `events`: necks along a best way, or places of the largest disc, with
    bounding features. `holds`: the answer for a requested radius."""

    is_empty: bool
    cause: str
    low: DiscRadius | None = None
    low_in: bool = False
    high: DiscRadius | None = None
    high_in: bool = False
    contact: DiscContact | None = None
    events: tuple[OffsetEvent, ...] = ()
    holds: bool | None = None


@dataclass(frozen=True)
class RadiusQuestion:
    """Whether contact is allowed; the distance to keep beyond the radius; perhaps the square of a
    radius that is asked for."""

    contact: str = CONTACTS[0]
    clearance: Fraction = Fraction(0)
    squared_radius: Fraction | None = None

    @property
    def is_allowed(self) -> bool:
        return self.contact == CONTACTS[0]

    @property
    def arguments(self) -> tuple[str, str | None]:
        """As the extension module takes them."""
        asked = self.squared_radius
        return str(self.clearance), None if asked is None else str(asked)

    def up_to(self, row: Any, cause: str, **causes: Any) -> DiscRadii:
        """All radii above 0 up to one."""
        if not row[2][1] > 0:
            return self.none(cause, **causes)
        fits = row[3] > 0 or (row[3] == 0 and self.is_allowed)
        return DiscRadii(
            False,
            cause,
            high=_radius(row),
            high_in=self.is_allowed,
            holds=None if self.squared_radius is None else fits,
            **causes,
        )

    def none(self, cause: str, **causes: Any) -> DiscRadii:
        return DiscRadii(
            True, cause, holds=None if self.squared_radius is None else False, **causes
        )


def on_path(
    obstacles: _core.PolygonSet, path: Sequence[tuple[str, str]], question: RadiusQuestion
) -> DiscRadii:
    """The radii at which a disc passes along a path; sets have been validated."""
    found = _core.disc_on_path(obstacles, list(path), *question.arguments)
    if found is None:
        return DiscRadii(False, "free", holds=None if question.squared_radius is None else True)
    row, contact = found
    cause = "meets" if row[0] == "0" else "contact"
    return question.up_to(row, cause, contact=_contact(contact))


def at_place(
    container: _core.PolygonSet, place: tuple[str, str], name: str, question: RadiusQuestion
) -> DiscRadii:
    """The radii of a disc at a place in a container."""
    eroded = eroded_by_disc(container, name)
    found: Any = _core.disc_on_path(eroded.set, [place], *question.arguments)
    row, contact = found
    if row[0] == "0" or contact[4] == BOX:
        return question.none("meets")
    return question.up_to(row, "contact", contact=_contact(contact, _in_container(eroded.outside)))


def anywhere(
    container: _core.PolygonSet, name: str, question: RadiusQuestion, threads: int
) -> DiscRadii:
    """The radii of a disc at some place in a container."""
    eroded = eroded_by_disc(container, name)
    row, places = _core.disc_anywhere(eroded.set, *question.arguments, threads)
    return question.up_to(row, "room", events=_events(map(eroded.in_P, places)))


def between(
    container: _core.PolygonSet,
    places: Sequence[tuple[str, str]],
    name: str,
    question: RadiusQuestion,
    threads: int,
) -> DiscRadii:
    """The radii of a disc that gets from a place to another one within a container."""
    eroded = eroded_by_disc(container, name)
    start, end = places
    found: Any = _core.disc_passage(eroded.set, start, end, *question.arguments, threads)
    cause, row = limit_between(found)
    if row is None:
        return question.none(cause)
    if cause == "neck":
        return question.up_to(row[0], cause, events=_events(map(eroded.in_P, found[4])))
    return question.up_to(row[0], cause, contact=_contact(row[1], _in_container(eroded.outside)))


def limit_between(found: Any) -> tuple[str, Any]:
    """The limit of a disc that gets from a place to another one in a container: its cause, and its
    radius with a contact; None where no disc passes."""
    limit, first, last, radius, _ = found
    if first is None or last is None or BOX in (first[1][4], last[1][4]):
        return "meets", None
    if limit == "apart":
        return "apart", None
    if limit == "neck":
        return "neck", (radius, None)
    return "contact", last if limit == "end" else first


def trapped(
    obstacles: _core.PolygonSet, place: tuple[str, str], question: RadiusQuestion, threads: int
) -> DiscRadii:
    """The radii of a disc that is free at a place and gets nowhere far away."""
    if obstacles.is_empty:
        return question.none("free")
    passage: Any = _core.disc_passage(obstacles, place, None, *question.arguments, threads)
    limit, first, _, radius, necks = passage
    if first is None:
        return question.none("meets")
    if limit == "start":
        return question.none("free")
    row, contact = first
    found = question.up_to(row, limit, contact=_contact(contact), events=_events(necks))
    if limit == "apart" or found.is_empty:
        return found
    above = radius[3] < 0 or (radius[3] == 0 and not question.is_allowed)
    is_low = radius[2][0] > 0
    return DiscRadii(
        False,
        limit,
        _radius(radius) if is_low else None,
        is_low and not question.is_allowed,
        found.high,
        found.high_in,
        found.contact,
        found.events,
        None if found.holds is None else found.holds and above,
    )


def valid_radii(
    obstacles: _core.PolygonSet,
    path: Sequence[Sequence[Number]],
    contact: str = "allowed",
    clearance: Number = 0,
) -> DiscRadii:
    """Find the radii at which a disc passes along the polyline of its centre: with contact allowed
    the open disc misses the obstacles, with contact forbidden the closed one; with a clearance, a
    disc that is larger by it. Exact: the squared distance is rational. Validates the obstacles.
    O(n log n) and the pairs of segments that are near. Raises BadInput, Refusal. docs/paths.md."""
    question = _question(contact, clearance)
    expect_sets(obstacles=obstacles)
    places = [(x, y) for x, y in path_of(path, 2)]
    obstacles.validate("obstacles")
    return on_path(obstacles, places, question)


def largest_disc(
    container: _core.PolygonSet,
    at: Sequence[Number] | None = None,
    between: Sequence[Sequence[Number]] | None = None,
    contact: str = "allowed",
    clearance: Number = 0,
    threads: int = 1,
) -> DiscRadii:
    """Find the radii of discs that lie in the container: about a place (`at`), somewhere, or about
    two places and all along some way between them (`between`). Exact: squared radii are rational,
    or roots of a polynomial. Validates the container. Takes as long as a DiscIndex, with `at` O(n
    log n). Raises BadInput, LimitExceeded, Refusal. docs/paths.md."""
    question = _question(contact, clearance)
    if at is not None and between is not None:
        what = "a place and two places are different questions"
        raise Refusal(what, "largest_disc", "give `at` or `between`, or neither")
    expect_sets(container=container)
    container.validate("container")
    count = max(1, whole("threads", threads))
    if at is not None:
        return at_place(container, _point("at", at), "container", question)
    if between is None:
        return anywhere(container, "container", question, count)
    if isinstance(between, str) or not isinstance(between, Sequence) or len(between) != 2:
        raise TypeError(f"between has to be two places, and is of type {type(between).__name__}")
    places = [_point("between", place) for place in between]
    return _between(container, places, "container", question, count)


def trapped_radii(
    obstacles: _core.PolygonSet,
    at: Sequence[Number],
    contact: str = "allowed",
    clearance: Number = 0,
    threads: int = 1,
) -> DiscRadii:
    """Find the radii at which a disc is free about a place, and no way takes it from there to
    infinity. Exact. Validates the obstacles. Takes as long as a DiscIndex. Raises BadInput,
    LimitExceeded, Refusal. docs/paths.md."""
    question = _question(contact, clearance)
    expect_sets(obstacles=obstacles)
    obstacles.validate("obstacles")
    return trapped(obstacles, _point("at", at), question, max(1, whole("threads", threads)))


_between = between


def _question(contact: str, clearance: Number) -> RadiusQuestion:
    text = number("clearance", clearance)
    value = read_number(text, "clearance", f"clearance {text}", "give 0 or a positive number")
    if value < 0:
        where, mend = f"clearance {text}", "give 0 or a positive number, as 1/2"
        raise Refusal("the clearance is negative", where, mend, "bad-clearance")
    return RadiusQuestion(word_of("contact", contact, CONTACTS), value)


def _point(name: str, value: Any) -> tuple[str, str]:
    x, y = coordinates(name, value, 2)
    return x, y


def _radius(row: Any) -> DiscRadius:
    square, polynomial, bounds, _ = row
    exact = None if square is None else Fraction(square)
    return DiscRadius(bounds, exact, tuple(map(Fraction, polynomial)))


def _contact(row: Any, named: NamedFeature = Feature) -> DiscContact | None:
    if row is None:
        return None
    segment, t, at, is_edge, ring, index, touching = row
    return DiscContact(
        segment, Fraction(t), _place(at), named(is_edge, ring, index), _place(touching)
    )


def _place(row: tuple[str, str]) -> Place:
    return Fraction(row[0]), Fraction(row[1])


def _in_container(outside: _core.Outside) -> NamedFeature:
    """Names a feature of the outside as the container does."""

    def named(is_edge: bool, ring: int, index: int) -> Feature:
        name = outside.edge_of_P if is_edge else outside.vertex_of_P
        return Feature(is_edge, *name(ring, index))

    return named


def _events(rows: Any) -> tuple[OffsetEvent, ...]:
    return tuple(map(event_of, rows))
