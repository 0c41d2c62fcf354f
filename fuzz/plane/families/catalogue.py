"""Generated families of pairs, by name, in a run's order."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from minkref.fuzz.plane.families.convex_pairs import collinear_pair, convex_pair
from minkref.fuzz.plane.families.dented_holes import dented_pair
from minkref.fuzz.plane.families.hard_numbers import (
    degenerate_pair,
    magnitude_pair,
    offset_pair,
    rational_pair,
    thin_pair,
)
from minkref.fuzz.plane.families.holed_pairs import (
    fit_pair,
    holes_pair,
    nested_pair,
    small_holes_pair,
)
from minkref.fuzz.plane.families.lattice_pairs import lattice_pair
from minkref.fuzz.plane.families.leaning_walls import leaning_pair
from minkref.fuzz.plane.families.outlines import comb_pair, spiral_pair, star_pair
from minkref.fuzz.plane.families.passing_corners import passing_pair
from minkref.fuzz.plane.families.random_pairs import Pair, random_pair
from minkref.fuzz.plane.families.touching_pairs import cells_pair, touching_pair


@dataclass(frozen=True)
class Family:
    """`pair(seed, index)` depends on nothing else; small pairs come first."""

    name: str
    title: str
    pair: Callable[[int, int], Pair]


_ALL = (
    Family("random", "random polygons with holes on small grids", random_pair),
    Family("convex", "random convex polygons", convex_pair),
    Family("holes", "both operands with holes", holes_pair),
    Family("small-holes", "holes too small to survive beside some that just do", small_holes_pair),
    Family("dents", "many holes full of dents, and a very small triangle", dented_pair),
    Family("fit", "one operand fits the other exactly, or off by one part in 2^20", fit_pair),
    Family("collinear", "collinear vertices and parallel edges in both", collinear_pair),
    Family("touching", "rings that touch at points", touching_pair),
    Family("passing", "corners that pass each other and touch at one scale only", passing_pair),
    Family("cells", "unions of grid squares", cells_pair),
    Family("nested", "polygons in holes of polygons", nested_pair),
    Family("comb", "combs, some of which interlock", comb_pair),
    Family("star", "stars", star_pair),
    Family("spiral", "spirals", spiral_pair),
    Family("degenerate", "a point, a segment or the empty set as one operand", degenerate_pair),
    Family("lattice", "parts, holes, points and segments on a few lattice points", lattice_pair),
    Family("rational", "coordinates with small denominators", rational_pair),
    Family("thin", "slivers and needles", thin_pair),
    Family("leaning", "notches with walls that are parallel up to 1e-2 or 1e-30", leaning_pair),
    Family("offset", "far from the origin", offset_pair),
    Family("magnitude", "coordinates of very different magnitudes", magnitude_pair),
)
FAMILIES: dict[str, Family] = {family.name: family for family in _ALL}
