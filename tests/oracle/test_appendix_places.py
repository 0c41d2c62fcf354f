"""Computer algebra judges the places of the paper's Appendix: one combination of readings of each
formula holds, and it is the corrected one of the program."""

from __future__ import annotations

import sympy as sp
from minkref import _core
from minkref.oracle.symbolic.disc import appendix_places as places

CORRECTED = {name: corrected for name, _, corrected, _ in _core.appendix_readings()}


def test_one_combination_of_readings_holds() -> None:
    assert places.readings_that_hold() == {
        "segments": [(CORRECTED["points"], CORRECTED["normal"])],
        "circles": [(CORRECTED["radical"], CORRECTED["middle"], CORRECTED["height"])],
        "line": [(CORRECTED["line"],)],
    }


def test_the_printed_radical_holds_for_a_disc_of_radius_1() -> None:
    p = places.crossing_of_circles("printed", "added", "left-out")
    assert [sp.simplify(off.subs(places.r, 1)) for off in places.squares_off_circles(p)] == [0, 0]


def test_the_line_that_stays_is_right_where_it_is_touched() -> None:
    p = places.crossing_with_line("printed")
    touched = places.g / (2 * places.r)
    circle, line = places.off_circle_and_line(p)
    assert circle == 0  # on the circle at all scales, on the line at one
    assert sp.solve(line, places.s) == [touched]
