"""Erosions in space: of unit cubes by unit cubes, counted cell by cell, by both routes."""

from __future__ import annotations

import random
from itertools import product
from pathlib import Path

import minkref
import pytest
from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.general_pairs import general_pair
from minkref.fuzz.space.generators.polycube import frame, hollow_box, random_polycube
from minkref.space.operand import SpaceOperand
from minkref.space.remaining import Find, closed, eroded, opened
from minkref.verbs.erode_request import SPACE_ROUTES
from thoroughness import draws

Cells = frozenset[tuple[int, int, int]]
ONE = ("1", "1", "1")


def mesh(cells: Cells) -> minkref.Polyhedron:
    solid = surface_of(cells)
    points = [tuple(str(c) for c in point) for point in solid.vertices]
    return minkref.Polyhedron(points, [list(face) for face in solid.faces])


def operand(cells: Cells) -> SpaceOperand:
    return SpaceOperand("cells", Path("cells.off"), mesh(cells), None)


def swollen(cells: Cells, times: int) -> Cells:
    """Each cell as so many cells in each direction."""
    steps = list(product(range(times), repeat=3))
    return frozenset(tuple(times * c + k for c, k in zip(cell, step, strict=True))
                     for cell in cells for step in steps)  # fmt: skip


def left(P: Cells, Q: Cells) -> Cells:
    """A cell belongs to the erosion iff the cell plus Q lies within P."""
    corners = list(product((0, 1), repeat=3))
    block = {tuple(map(sum, zip(q, corner, strict=True))) for q in Q for corner in corners}
    lows = [min(cell[k] for cell in P) - 3 for k in range(3)]
    highs = [max(cell[k] for cell in P) + 3 for k in range(3)]
    places = product(*(range(a, b) for a, b in zip(lows, highs, strict=True)))
    return frozenset(
        place
        for place in places
        if all(tuple(map(sum, zip(place, step, strict=True))) in P for step in block)
    )


@pytest.mark.parametrize("index", range(draws(8, 40)))
def test_cells_are_left_as_counted(index: int) -> None:
    dice = random.Random(f"cells to erode {index}")
    kind = (random_polycube, hollow_box, frame)[index % 3]
    P = swollen(kind(dice, 4), dice.choice((2, 3)))
    Q = random_polycube(dice, dice.randint(1, 2))
    expected = left(P, Q)
    forms = set()
    for route in SPACE_ROUTES:
        found, _, _ = eroded(operand(P), operand(Q), ONE, route, False)
        assert found.volume() == str(len(expected)), index
        forms.add(found.canonical_json())
    assert len(forms) == 1
    if expected:
        assert forms == {_core.polyhedral_set(mesh(expected)).canonical_json()}


def test_what_just_fits_leaves_sheets_and_points() -> None:
    room, box = (
        frozenset(product(range(2), range(3), range(3))),
        frozenset(product(range(2), (0,), (0,))),
    )
    found, _, remnants = eroded(operand(room), operand(box), ONE, "edges", True)
    assert remnants is not None
    assert (found.volume(), found.is_empty, len(remnants["sheets"])) == ("0", True, 1)
    _, _, remnants = eroded(operand(room), operand(room), ONE, "edges", True)
    assert remnants == {"lines": [], "points": [["0", "0", "0"]], "sheets": []}


def test_a_cube_in_a_hollow_cube_goes_all_around() -> None:
    walls = swollen(frozenset(set(product(range(3), repeat=3)) - {(1, 1, 1)}), 2)
    found, _, _ = eroded(operand(walls), operand(frozenset({(0, 0, 0)})), ONE, "edges", False)
    assert (found.volume(), found.surface().topology()) == ("98", (1, 1, 0))


def summed(P: Cells, Q: Cells) -> Cells:
    """The sum of blocks of cells, as cells."""
    corners = list(product((0, 1), repeat=3))
    block = {tuple(map(sum, zip(q, corner, strict=True))) for q in Q for corner in corners}
    return frozenset(tuple(map(sum, zip(p, step, strict=True))) for p in P for step in block)


def by_cells(Q: Cells, is_opening: bool, P: Cells) -> Cells:
    return summed(left(P, Q), Q) if is_opening else left(summed(P, Q), Q)


CASES = [(index, which) for index in range(draws(4, 24)) for which in ("opening", "closing")]


@pytest.mark.parametrize(("index", "which"), CASES)
def test_openings_and_closings_are_those_of_cells(index: int, which: str) -> None:
    """Places at which Q just fits have no volume, and cells do not show them."""
    dice = random.Random(f"cells to open {index}")
    kind = (random_polycube, hollow_box, frame)[index % 3]
    P = swollen(kind(dice, 3), dice.choice((2, 3)))
    Q = random_polycube(dice, dice.randint(1, 2))
    expected = by_cells(Q, which == "opening", P)
    find: Find = opened if which == "opening" else closed
    forms = set()
    for route in SPACE_ROUTES if index == 0 else SPACE_ROUTES[:1]:
        found, _, _ = find(operand(P), operand(Q), ONE, route, False)
        assert found.volume() == str(len(expected)), index
        forms.add(found.canonical_json())
    assert len(forms) == 1
    if expected:
        assert forms == {_core.polyhedral_set(mesh(expected)).canonical_json()}


@pytest.mark.parametrize("index", range(draws(3, 20)))
def test_laws_of_openings_and_closings(index: int) -> None:
    """The opening lies within P, P within the closing; both again change nothing."""
    pair = general_pair(1964, index)
    P, Q = core_polyhedron(pair.P), core_polyhedron(pair.Q).scaled(("1/9", "1/7", "1/8"))
    inner = minkref.polyhedral_opening(P, Q)
    outer = minkref.polyhedral_closing(P, Q)
    own = minkref.PolyhedralSet(P)
    assert inner.volume <= own.volume <= outer.volume, pair.name
    for small, large in ((inner, own), (own, outer)):
        points = small.surface().mesh(True).points()
        assert all(point in large for point in points), pair.name
    for find, found in ((minkref.polyhedral_opening, inner), (minkref.polyhedral_closing, outer)):
        assert find(found.surface().mesh(True), Q) == found, pair.name
