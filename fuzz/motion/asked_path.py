"""A case of the verb `path`: a part, obstacles, a path, and the scales that are asked about."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any

import minkref
from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.exact import read_number, read_scale
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.needs import is_double, needs_of_plane
from minkref.fuzz.cases.verbs import PATH, RANGES
from minkref.fuzz.geometry.plane import Point, written_rings
from minkref.fuzz.motion.path_cases import (
    KINDS,
    PathCase,
    Place,
    case_in_a_corridor,
    case_in_a_hole,
    case_past_a_corner,
    path_case,
)
from minkref.fuzz.plane.exact_shapes import set_of, shape_of
from minkref.fuzz.plane.protocol import IN_THE_PLANE
from minkref.motion.scale_ranges import CONTACTS

GRID = "-grid"  # suffix of a family whose coordinates are multiples of UNIT
UNIT = Fraction(1, 64)
FAMILIES = (PATH, RANGES, PATH + GRID, RANGES + GRID)
#: In turn; each is asked for its cases one after the other, and so draws all of its own kinds.
DRAWS: tuple[Callable[[int, int], PathCase], ...] = (
    path_case,
    case_past_a_corner,
    case_in_a_corridor,
    path_case,
    case_in_a_hole,
)
#: The values of `position` of a drawn case.
POSITIONS = frozenset((*KINDS, "general", "past a corner", "in a hole"))
BESIDE = Fraction(1, 4096)  # relative: scales asked about just below and above each bound
MOST_SCALES = 24
MOST_VERTICES = 10_000  # most vertices of a named path
MEND = (
    'write {"part":{"polygons":[...]},"obstacles":{"polygons":[...]},"path":[["0","0"],...],'
    '"contact":"allowed","scales":["1"]}'
)


@dataclass(frozen=True)
class AskedPath:
    """`scales`: asks about each; or about scales in the closed `window`, as ranges. P is the part
    and Q the obstacles."""

    name: CaseName
    part: _core.PolygonSet
    obstacles: _core.PolygonSet
    path: tuple[Place, ...]
    contact: str
    scales: tuple[str, ...] = ()
    window: tuple[str, str] | None = None
    family: str = PATH
    position: str = "given"

    dimension = 2
    exchange = IN_THE_PLANE
    is_valid = True
    scale = "1"
    P_name, Q_name = "part", "obstacles"

    @property
    def verb(self) -> str:
        """Returns the capability that the case asks for."""
        return PATH if self.window is None else RANGES

    @cached_property
    def P_json(self) -> str:
        return self.part.to_json()

    @cached_property
    def Q_json(self) -> str:
        return self.obstacles.to_json()

    @property
    def scaled_P_json(self) -> str:
        return self.P_json

    @property
    def judged_operands(self) -> tuple[str, str]:
        return (self.P_json, self.Q_json)

    @cached_property
    def needs(self) -> frozenset[str]:
        rational = not all(is_double(axis) for point in self.path for axis in point)
        more = {"rational"} if rational else set()
        return needs_of_plane(self.P_json, self.Q_json) | {self.verb} | more

    @cached_property
    def sent(self) -> list[Fraction]:
        """Returns all coordinates sent to an implementation."""
        along = [Fraction(axis) for point in self.path for axis in point]
        return [*_numbers(self.P_json), *_numbers(self.Q_json), *along]

    @property
    def greatest_scale(self) -> Fraction:
        return Fraction(self.window[1]) if self.window else max(map(Fraction, self.scales))

    @cached_property
    def magnitude(self) -> Fraction:
        """Adds the largest absolute coordinates of the part at its greatest scale, the obstacles
        and the path."""
        groups = (_numbers(self.P_json), _numbers(self.Q_json), self.sent[-2 * len(self.path) :])
        part, obstacles, path = (max(map(abs, group), default=Fraction(0)) for group in groups)
        return self.greatest_scale * part + obstacles + path

    @cached_property
    def literal(self) -> str:
        value = {
            "part": json.loads(self.P_json),
            "obstacles": json.loads(self.Q_json),
            "path": self.path_texts,
            "contact": self.contact,
            **self.asked,
        }
        return json.dumps(value, separators=(",", ":"))

    @property
    def path_texts(self) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in self.path]

    @property
    def asked(self) -> dict[str, Any]:
        if self.window is None:
            return {"scales": list(self.scales)}
        return {"from": self.window[0], "to": self.window[1]}

    @property
    def size(self) -> tuple[int, int, str]:
        count = self.part.vertices + self.obstacles.vertices + len(self.path)
        return (count, len(self.literal), self.name.text)

    def valid(self, route: str = "contacts") -> minkref.ValidScales:
        """Finds the valid scales by a route that shares little with the default route."""
        return minkref.valid_scales(self.part, self.obstacles, self.path, self.contact, route=route)


def _numbers(text: str) -> list[Fraction]:
    return [Fraction(number) for ring in written_rings(text) for point in ring for number in point]


def drawn_path(name: CaseName, family: str, seed: int, index: int) -> AskedPath:
    """Draws small cases, many degenerate: among five, one passes a corner, one lies in a hole, and
    one between two walls; scales at and beside their bounds."""
    turn, which = divmod(index, len(DRAWS))
    draw = DRAWS[which]
    drawn = draw(seed, turn * DRAWS.count(draw) + DRAWS[:which].count(draw))
    contact = random.Random(f"contact {seed}:{index}").choice(CONTACTS)
    case = AskedPath(
        name, drawn.part, drawn.obstacles, tuple(drawn.path), contact, ("1",), None, family,
        drawn.kind,
    )  # fmt: skip
    if family.endswith(GRID):
        case = _on_grid(case)
    bounds = sorted({bound.scale for bound in case.valid("pieces").bounds})
    if family.removesuffix(GRID) == RANGES:
        least, greatest = (bounds[0], bounds[-1]) if bounds else (Fraction(1), Fraction(1))
        return replace(case, window=(str(least / 2), str(2 * greatest)))
    return replace(case, scales=tuple(map(str, _scales_beside(bounds))))


def _scales_beside(bounds: list[Fraction]) -> list[Fraction]:
    found = {Fraction(1)}
    ends = [Fraction(0), *bounds, 2 * bounds[-1] + 1] if bounds else [Fraction(0), Fraction(4)]
    for low, high in pairwise(ends):
        found.add((low + high) / 2)
    for bound in bounds:
        found |= {bound, bound * (1 - BESIDE), bound * (1 + BESIDE)}
    return sorted(found)[:MOST_SCALES]


def _on_grid(case: AskedPath) -> AskedPath:
    """Moves obstacles to the grid vertex by vertex, if they stay valid; else keeps them off the
    grid, for targets that take rational numbers."""

    def rounded(point: Point) -> Place:
        x, y = (UNIT * round(Fraction(axis) / UNIT) for axis in point)
        return (x, y)

    path = tuple(map(rounded, case.path))
    obstacles = set_of(
        [[[rounded(p) for p in ring] for ring in polygon] for polygon in shape_of(case.obstacles)]
    )
    try:
        obstacles.validate("rounded")
    except _core.BadInput:
        obstacles = case.obstacles
    return replace(case, path=path, obstacles=obstacles)


def named_path(name: CaseName, value: dict[str, Any], where: str) -> AskedPath:
    """Returns the case that a JSON value describes. Refuses other values."""
    part, obstacles = (_set(value.get(word), word, where) for word in ("part", "obstacles"))
    contact = value.get("contact", CONTACTS[0])
    if contact not in CONTACTS:
        raise Refusal("there is no such contact", where, MEND)
    path = value.get("path")
    if not isinstance(path, list) or not 0 < len(path) <= MOST_VERTICES:
        raise Refusal("the path is not a list of points", where, MEND)
    places = tuple(_place(point, where) for point in path)
    case = AskedPath(name, part, obstacles, places, contact)
    if not (part.is_region or obstacles.is_region or part.is_empty or obstacles.is_empty):
        raise Refusal("both the part and the obstacles are without area", where, MEND)
    if "scales" not in value:
        window = tuple(read_scale(str(value.get(word, "")), where) for word in ("from", "to"))
        if Fraction(window[0]) >= Fraction(window[1]):
            raise Refusal("the window is empty", where, MEND)
        return replace(case, window=(window[0], window[1]))
    scales = value["scales"]
    if not isinstance(scales, list) or not scales:
        raise Refusal("the scales are not a list", where, MEND)
    return replace(case, scales=tuple(read_scale(str(scale), where) for scale in scales))


def _set(value: Any, word: str, where: str) -> _core.PolygonSet:
    if not isinstance(value, dict) or "polygons" not in value:
        raise Refusal(f"{word} is not a polygon set", where, MEND)
    text = json.dumps(value)
    read: _core.PolygonSet = refusing(where, lambda: _core.read_text(text, "json", where))
    refusing(where, lambda: read.validate(where))
    return read


def _place(point: Any, where: str) -> Place:
    if not isinstance(point, list) or len(point) != 2:
        raise Refusal("a vertex of the path is not a pair of numbers", where, MEND)
    x, y = (Fraction(read_number(str(axis), "coordinate", where, MEND)) for axis in point)
    return (x, y)
