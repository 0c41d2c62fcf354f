"""Notches: the pocket minima of features with long bars, in the order of cuts."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cmp_to_key

from .alive import Feature, features_at
from .number import Number, number, order, root
from .tree import Bar, Tree, order_of_ends


@dataclass(frozen=True, eq=False)
class Notch:
    """A wedge to cut at, its feature's bar, the squared depth (None: infinite)."""

    wedge: int
    bar: Bar
    depth: Number | None
    tie: bool


def notches(
    tree: Tree, alpha: Fraction, persistence: Fraction, alpha_to: Fraction | None = None
) -> list[Notch]:
    """The longest bar first, then the deepest wedge, then the least place. Essential bars, and bars
    up to infinity, are longer than any number. With `alpha_to` the bar's part from alpha to there
    has to be longer. At alpha 0 each wedge is a feature."""
    found = []
    for wedge, depth, tie, bar in _pockets(tree, alpha):
        length = _length(tree, bar)
        part = length if alpha_to is None else _part(tree, bar, alpha, alpha_to)
        if part is None or order(part, number(persistence)) > 0:
            found.append((length, Notch(wedge, bar, depth, tie)))

    def before(a: tuple[Number | None, Notch], b: tuple[Number | None, Notch]) -> int:
        return (
            -order_with_infinity(a[0], b[0])
            or -order_with_infinity(a[1].depth, b[1].depth)
            or order_of_ends(tree.levels, a[1].wedge, b[1].wedge)
        )

    return [notch for _, notch in sorted(found, key=cmp_to_key(before))]


def _pockets(tree: Tree, alpha: Fraction) -> list[tuple[int, Number | None, bool, Bar]]:
    if alpha == 0:
        own = [bar for bar in tree.bars if bar.leaf.kind == "reflex"]
        return [(bar.leaf.wedge, number(0), False, bar) for bar in own]
    features: list[Feature] = features_at(tree, alpha * alpha / 4)
    return [(f.pocket, f.depth, f.tie, f.bar) for f in features if f.pocket is not None]


def _length(tree: Tree, bar: Bar) -> Number | None:
    """As a diameter; None is infinite."""
    levels = tree.levels
    if bar.is_essential or bar.death == levels.infinity:
        return None
    return (root(levels.squares[bar.death]) - root(levels.squares[bar.birth])) * 2


def _part(tree: Tree, bar: Bar, alpha: Fraction, alpha_to: Fraction) -> Number:
    """The length inside a range that begins in the bar."""
    levels = tree.levels
    if bar.death < levels.infinity:
        death = root(levels.squares[bar.death]) * 2
        if order(death, number(alpha_to)) < 0:
            return death - alpha
    return number(alpha_to - alpha)


def order_with_infinity(a: Number | None, b: Number | None) -> int:
    """The sign of a - b; None is infinite."""
    if a is None or b is None:
        return (a is None) - (b is None)
    return order(a, b)
