"""Generated families of pairs in space, by name, in a run's order."""

from __future__ import annotations

from minkref.fuzz.space.found import FAMILY as FOUND
from minkref.fuzz.space.found import found_pair
from minkref.fuzz.space.general_pairs import pair_of_family
from minkref.fuzz.space.pair import SpacePair
from minkref.fuzz.space.pairs import space_pair

PREFIX = "space-"
GROWING = {
    "space-polycube": "polycubes",
    "space-hollow": "boxes with a cavity and polycubes",
    "space-apart": "several polycubes apart, and another",
    "space-frame": "frames of unit cells and polycubes",
    "space-l-prism": "L-shaped prisms and cubes",
    "space-prism": "prisms over polygons with holes",
    "space-convex": "random convex polyhedra on a grid",
    "space-sphere": "hulls of rational points of the unit sphere",
    "space-round": "hulls of many of them: sums of a hundred vertices and more",
    "space-thin": "points and segments beside convex polyhedra",
    "space-offset": "boxes and L-shaped prisms far from the origin",
    "space-torus": "polygonal tori",
    "space-star": "star-shaped polyhedra",
}
# By the name of a family of general pairs; some have another name here, since theirs is taken.
GENERAL = {
    "mixed": ("space-mixed", "any two solids, one of them under a matrix of its own"),
    "parallel": ("space-parallel", "any two solids with many faces parallel to axes"),
    "same": ("space-same", "a solid and itself, or its mirror image"),
    "slot": ("space-slot", "a U and a plate as thick as its slot is wide, or off by one"),
    "ring": ("space-ring", "a ring and a bar that fills its hole, or is off by one"),
    "cup": ("space-cup", "a cup and a box that fills its pocket, or an L that closes it"),
    "cavity": ("space-cavity", "a box with a cavity, and what fills it, or a smaller one"),
    "coplanar": ("space-coplanar", "gears, brackets, dented prisms with lids in parallel planes"),
    "spikes": ("space-spikes", "tetrahedra with spikes and dents"),
    "tori": ("space-tori", "two tori, or one and a convex body"),
    "knot": ("space-knot", "a tube along a trefoil, and a small convex body"),
    "thin": ("space-swept", "any solid swept along a segment, or moved to a point"),
    "polycubes": ("space-sheared", "polycubes under a matrix"),
    "apart": ("space-bridge", "two solids apart, and one that bridges the gap, or just does not"),
}
SPACE_FAMILIES = (
    {FOUND: "small pairs on which libraries were found wrong"} | GROWING | dict(GENERAL.values())
)
_OF_GENERAL = {name: family for family, (name, _) in GENERAL.items()}


def drawn_pair(family: str, seed: int, index: int) -> SpacePair:
    """Draws pair `index` of a family in SPACE_FAMILIES, from the arguments alone. NoCase beyond the
    end of a family."""
    if family == FOUND:
        return found_pair(index)
    if family not in _OF_GENERAL:
        return space_pair(family.removeprefix(PREFIX), seed, index)
    drawn = pair_of_family(_OF_GENERAL[family], seed, index)
    return SpacePair(drawn.P, drawn.Q, drawn.scale, family)
