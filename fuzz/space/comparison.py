"""The verdict on somebody else's sum in space."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.boundary_faces import boundary_test
from minkref.fuzz.space.cells import grid_cells
from minkref.fuzz.space.closedness import open_edge
from minkref.fuzz.space.cross_section import cross_sections, differing_points, sections_agree
from minkref.fuzz.space.differing_cells import cell_reasons
from minkref.fuzz.space.fault_search import FaultSearch, decided
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.sampling import points_near, sums_of_points
from minkref.fuzz.space.stray_faces import TooMany, changes
from minkref.fuzz.space.sum_faces import SumFaces
from minkref.fuzz.space.sum_sides import beside_faces, sides_agree
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Reason, Witness

Rating = Literal["pass", "pass-within", "wrong", "undecided"]
MOST_PIECES = 60_000  # most pieces of triangles off the sum's boundary, cut by each other
MOST_MIDDLES = 6  # most places tried inside a hull, for one off the result's surface
MOST_CELLS = 200_000  # most grid cells whose centres are tested


@dataclass(frozen=True)
class Comparison:
    """`proven`: the set of positive winding number is shown to be the sum. A pass without it says
    that no fault was found at `points` points."""

    verdict: Rating
    reasons: tuple[Reason, ...] = ()
    message: str = ""
    witness: Witness | None = None
    proven: bool = False
    points: int = 0


def compare(
    pair: SpacePair, result: Polyhedron, exact: bool = True, tolerance: Fraction = Fraction(0)
) -> Comparison:
    """Compares a result with the sum. The result stands for the points with positive winding
    number, regularised; unnamed vertices do not matter, nor do cancelling faces. An `exact` result
    has to equal the sum R; else it has to contain all points whose cube with half side `tolerance`
    lies within R, and none whose cube is clear of R. Every `wrong` has a witness that `holds`; with
    a tolerance it holds with the tolerance, except for a surface that is not closed: there the
    point shows where. ValueError for a negative tolerance."""
    if tolerance < 0:
        raise ValueError("the tolerance is negative")
    whole = result.without_unused_vertices()
    result = whole.without_opposite_faces()
    malformed = _malformed(pair, result, exact)
    if malformed is not None:
        return malformed
    search = FaultSearch(pair, whole, result, Fraction(0) if exact else tolerance)
    proven, message = _examine(search, exact)
    if search.refuted is not None:
        return Comparison("undecided", message=search.refuted, points=search.points)
    if search.witness is not None:
        return Comparison("wrong", tuple(search.reasons), "", search.witness, points=search.points)
    if proven:
        return Comparison("pass", proven=True, points=search.points)
    if pair.judged_by is Truth.SUM and search.unproven is not None:
        where = ", ".join(str(number) for number in search.unproven)
        message = f"({where}) is missing by our sum, but there is no witness"
        return Comparison("undecided", message=message, points=search.points)
    text = ""
    if pair.judged_by is Truth.POINTS:
        why = f", as there is no exact sum: {pair.absence}" if pair.absence else ""
        text = f"no fault at {search.points} points{why}"
    if not exact:
        return Comparison("pass-within", message=text, points=search.points)
    if pair.judged_by is Truth.POINTS:
        return Comparison("pass", message=text, points=search.points)
    return Comparison("undecided", message=message, points=search.points)


def _malformed(pair: SpacePair, result: Polyhedron, exact: bool) -> Comparison | None:
    """Finds an open surface, or in exact results a face that is not planar."""
    where, message = open_edge(result), "the surface is not closed"
    if where is None and exact:
        bent = result.bent_face()
        if bent is not None:
            where, message = result.vertices[result.faces[bent][0]], f"face {bent} is not planar"
    if where is None:
        return None
    witness = decided(pair, where)
    if not holds(pair.P, pair.Q, pair.scale, witness):
        return Comparison("undecided", message=f"{message}, but the witness there does not hold")
    return Comparison("wrong", (Reason.NOT_CLOSED,), message, witness, points=1)


def _examine(search: FaultSearch, exact: bool) -> tuple[bool, str]:
    """Tests points until both kinds of faults are found, or all points are tested. True if the
    result is proven to equal the sum; else the reason."""
    pair = search.pair
    proven, message = False, ""
    if pair.truth is Truth.CELLS:
        message = _test_cells(search)
    if pair.truth is Truth.PRISM:
        message = _test_sections(search)
    if search.reasons:
        return False, ""
    if pair.judged_by is not Truth.POINTS and not message:
        proven, message = _prove(search, exact)
    if proven or search.reasons:
        return proven, message
    if pair.judged_by is Truth.SUM and not exact:
        beside_faces(search)
    for p, q in sums_of_points(pair, search.tolerance):
        if search.test_inside(p, q) or search.refuted:
            break
    for x in points_near(pair, search.result, search.surface, search.tolerance):
        if len(search.reasons) == 2 or search.refuted:
            break
        search.test(x)
    return False, message


def _test_cells(search: FaultSearch) -> str:
    """Tests every cell's centre. Returns a reason if this says too little."""
    known = search.pair.cell_sum
    if not search.surface.triangles:
        low, high = (Fraction(0),) * 3, (Fraction(0),) * 3
    else:
        low, high = search.result.box
    spans = [-(-high[k] // known.unit[k]) - low[k] // known.unit[k] for k in range(3)]
    if spans[0] * spans[1] * spans[2] > MOST_CELLS:
        return "the result is too large for its cells"
    cells = set(known.cells) | set(grid_cells(low, high, known.unit))
    claimed = set()
    half = Fraction(1, 2)
    a, b, c = known.unit
    for x, y, z in sorted(cells):
        centre = ((x + half) * a, (y + half) * b, (z + half) * c)
        winding = search.surface.winding(centre)
        truth = (x, y, z) in known.cells
        if truth if winding is None else winding > 0:
            claimed.add((x, y, z))
        if ((x, y, z) in claimed) != truth:
            search.test(centre)
        if search.refuted:
            return ""
    search.points += len(cells)
    if search.reasons:
        found = set(search.reasons)
        search.reasons = cell_reasons(known.cells, claimed, found)
    return "" if claimed == known.cells else "a cell differs by less than the tolerance"


def _test_sections(search: FaultSearch) -> str:
    """Tests points where cross-sections differ. Returns a reason if this says too little."""
    prism, surface = search.pair.prism_sum, search.surface
    try:
        sections, complete = cross_sections(prism, surface)
        for x in differing_points(prism, sections, search.tolerance):
            search.test(x)
            if len(search.reasons) == 2 or search.refuted:
                return ""
        if not complete:
            return "the result has vertices at too many heights"
        return "" if sections_agree(prism, sections) else "a cross-section differs"
    except ValueError as error:
        return str(error)


def _prove(search: FaultSearch, exact: bool) -> tuple[bool, str]:
    """Proves the result equal to the sum, if all triangles that bound the result lie within the
    sum's boundary, or for cells and prisms in planes that cut space into cells, each tested; for an
    exact sum, tests every connected part beside the faces. Tests other triangles on both sides."""
    surface, faces = search.surface, None
    if search.pair.judged_by is Truth.SUM:
        faces = SumFaces(search.pair.exact.polyhedron, surface.denominator)
    on_boundary = boundary_test(search.pair, surface, faces)
    stray = [k for k in range(len(surface.triangles)) if not on_boundary(k)]
    if stray and not exact:
        return False, ""
    if faces is not None and not sides_agree(search):
        return False, "the result differs beside a face of the sum"
    changed = False
    try:
        off_boundary = None if faces is None else faces.left
        for outer, inner in changes(
            search.whole, search.result, surface, stray, MOST_PIECES, off_boundary
        ):
            changed = True
            search.test(outer)
            search.test(inner)
            if search.reasons or search.refuted:
                return False, ""
    except TooMany as error:
        return False, str(error)
    if changed:
        return False, "a face off the boundary of the sum bounds the result"
    if stray and search.pair.truth is Truth.CELLS:
        # A stray triangle may contain a centre.
        return _stray_cells(search), "a stray face passes through the centre of a cell"
    if search.pair.truth is Truth.HULL:
        vertices = search.pair.hull.vertices
        return _middle_is_inside(search, vertices), "the middle of the hull is on the surface"
    return True, ""


def _middle_is_inside(search: FaultSearch, vertices: tuple[Point, ...]) -> bool:
    """Tests one place inside the hull: the first off the surface among several with unlike
    weights."""
    for power in range(MOST_MIDDLES):
        weights = [Fraction(1 + ((k + 1) ** power) % 97) for k in range(len(vertices))]
        total = sum(weights, Fraction(0))
        x, y, z = (
            sum((w * v[k] for w, v in zip(weights, vertices, strict=True)), Fraction(0)) / total
            for k in range(3)
        )
        winding = search.surface.winding((x, y, z))
        if winding is not None:
            search.test((x, y, z))
            return winding > 0
    return False


def _stray_cells(search: FaultSearch) -> bool:
    """Finds, in every cell, a place off the surface, and tests the result there."""
    known = search.pair.cell_sum
    a, b, c = known.unit
    low, high = search.result.box
    for x, y, z in set(known.cells) | set(grid_cells(low, high, known.unit)):
        for number in range(7):
            share = Fraction(1, 2) + Fraction(number, 17 + number)
            other = Fraction(1, 2) - Fraction(number, 23 + number)
            place = ((x + share) * a, (y + other) * b, (z + share * share) * c)
            winding = search.surface.winding(place)
            if winding is not None:
                search.test(place)
                break
        else:
            return False
    return not search.reasons and search.refuted is None
