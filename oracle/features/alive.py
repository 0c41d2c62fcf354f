"""Features alive at a radius: leaves, bridges, bars and pocket minima."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cmp_to_key

from .chord import Chord, chord, chord_at, depth
from .graph import Part
from .levels import Levels, Sets
from .number import Number, number, order
from .tree import Bar, Tree, order_of_ends


@dataclass(eq=False)
class Feature:
    """A component of the medial axis below a radius. `leaves`: wedges; `bridges`: parts up to the
    radius, with chords; `pocket`: the deepest leaf (None without leaves); `depth`: squared, None if
    infinite; `tie`: the least place decided."""

    ends: list[int]
    bar: Bar
    leaves: list[int]
    bridges: list[tuple[Part, Chord]] = field(default_factory=list)
    pocket: int | None = None
    depth: Number | None = None
    tie: bool = False


def features_at(tree: Tree, square: Fraction) -> list[Feature]:
    """Features at a squared radius above 0, one per bar around it."""
    levels = tree.levels
    graph = levels.graph
    last = levels.below(square)
    sets = Sets(levels.ends)
    crossing = []
    for part in graph.parts:
        low, high = levels.level(part.low), levels.level(part.high)
        if low <= last:
            if high <= last:
                sets.join(levels.number(part.low), levels.number(part.high))
            else:
                crossing.append(part)
    inside = [k for k in range(levels.ends - 1) if _level(levels, k) <= last]
    at_level = last + 1 < levels.infinity and order(levels.squares[last + 1], number(square)) == 0
    found = []
    for ends in sets.groups(inside):
        bar = _bar_of(tree, ends, last)
        if bar is None:
            continue
        own = Feature(ends, bar, [k - len(graph.places) for k in ends if k >= len(graph.places)])
        for part in crossing:
            if sets.find(levels.number(part.low)) == sets.find(ends[0]):
                if at_level and levels.level(part.high) == last + 1:
                    own.bridges.append((part, chord_at(levels, part, last + 1)))
                else:
                    own.bridges.append((part, chord(levels, part, number(square))))
        _find_pocket(tree, own)
        found.append(own)
    return found


def _level(levels: Levels, end: int) -> int:
    return levels.of_place[end] if end < len(levels.of_place) else 0


def _bar_of(tree: Tree, ends: list[int], last: int) -> Bar | None:
    """The elder leaf's bar: all bars of further leaves have ended. None after a hole's end."""
    places = len(tree.levels.of_place)
    leaves = {k - places for k in ends if k >= places}
    own = set(ends)
    found = [
        bar
        for bar in tree.bars
        if bar.birth <= last < bar.death
        and (
            bar.leaf.wedge in leaves if bar.leaf.kind == "reflex" else bar.leaf.groups[0][0] in own
        )
    ]
    if len(found) > 1:
        raise ArithmeticError("a feature with two bars")
    return found[0] if found else None


def _find_pocket(tree: Tree, feature: Feature) -> None:
    wedges = tree.levels.graph.outline.wedges
    best: list[tuple[int, Number | None]] = []
    for leaf in feature.leaves:
        deep: Number | None = None
        for _, ends in feature.bridges:
            own = depth(wedges[leaf].at, ends)
            if deep is None or order(own, deep) < 0:
                deep = own
        if best:
            other = best[0][1]
            sign = (deep is None) - (other is None) if deep is None or other is None else (
                order(deep, other))  # fmt: skip
            if sign < 0:
                continue
            if sign > 0:
                best = []
        best.append((leaf, deep))
    if best:

        def before(a: int, b: int) -> int:
            return order_of_ends(tree.levels, a, b)

        feature.pocket = min((leaf for leaf, _ in best), key=cmp_to_key(before))
        feature.depth = best[0][1]
        feature.tie = len(best) > 1
