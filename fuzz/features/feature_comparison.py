"""Features of the reference before the judge of features (oracle/features): tree, bars, tracks,
features alive at an alpha with bridges and depths, notches."""

from __future__ import annotations

import math
import random
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.oracle.features import Judge
from minkref.oracle.features.form import canonical_json, canonical_nodes
from minkref.oracle.features.number import Number, number

NEAR = 1e-9  # times the set's size: places by doubles
ALPHAS = 4  # for each set
Spot = tuple[float, float]


def feature_faults(
    judge: Judge, found: _core.Features, dice: random.Random, counts: Counter[str]
) -> list[str]:
    """Differences, in words; none if both agree."""
    faults = bar_faults(judge, found)
    if faults:  # numbers below stand for bars and nodes
        return faults
    comparison = _Comparison(judge, found)
    if judge.tracks() != comparison.tracks():
        return [f"tracks: {judge.tracks()} and {comparison.tracks()}"]
    for alpha in _alphas(judge, dice):
        counts["alphas"] += 1
        faults += comparison.alive(alpha, counts)
        faults += comparison.notches(alpha, dice, counts)
    return faults + comparison.notches(Fraction(0), dice, counts)


def bar_faults(judge: Judge, found: _core.Features) -> list[str]:
    """Differences of trees, radii and bars."""
    own, other = canonical_json(judge), found.canonical_json()
    if own != other:
        return [f"trees: the judge has {own}, the reference {other}"]
    comparison = _Comparison(judge, found)
    return [*comparison.radii(), *comparison.bars()]


def alive_faults(
    judge: Judge, found: _core.Features, alpha: Fraction, counts: Counter[str]
) -> list[str]:
    """Differences at a diameter, where trees and bars are equal."""
    return _Comparison(judge, found).alive(alpha, counts)


def _alphas(judge: Judge, dice: random.Random) -> list[Fraction]:
    """Diameters between levels, and at rational ones."""
    squares = judge.levels.squares
    radii = [*(float(square) ** 0.5 for square in squares), float(squares[-1]) ** 0.5 * 2 + 1]
    found = []
    for k in dice.sample(range(1, len(radii)), min(ALPHAS, len(radii) - 1)):
        square = None if k == len(squares) else squares[k].rational
        roots = None if square is None else _root(square)
        if roots is not None and dice.random() < 0.7:
            found.append(2 * roots)
        else:
            middle = Fraction(radii[k - 1] + radii[k])
            short = middle.limit_denominator(10**6)
            is_between = 2 * radii[k - 1] < short < 2 * radii[k]
            found.append(short if is_between else middle)
    return found


def _root(square: Fraction) -> Fraction | None:
    top, below = math.isqrt(square.numerator), math.isqrt(square.denominator)
    return Fraction(top, below) if Fraction(top * top, below * below) == square else None


class _Comparison:
    """Compares one set's answers; trees are equal, so numbers of nodes are, too."""

    def __init__(self, judge: Judge, found: _core.Features) -> None:
        self.judge, self.found = judge, found
        self.nodes = canonical_nodes(judge)
        self.number = {node: k for k, node in enumerate(self.nodes)}
        self.rows = found.nodes()
        self.slack = NEAR * (1 + judge.graph.finder.size)

    def radii(self) -> list[str]:
        """Squared radii are roots of the reference's polynomials, within bounds; ties agree."""
        faults = []
        levels = self.judge.levels
        if self.found.radii != levels.infinity - 1:
            return [f"radii: {levels.infinity - 1} and {self.found.radii}"]
        told = {row[0]: row[1:] for row in self.found.radius_rows()}
        for node, row in zip(self.nodes, self.rows, strict=True):
            if node.level != row[1]:
                faults.append(f"node {self.number[node]}: levels {node.level} and {row[1]}")
            elif 0 < node.level < levels.infinity:
                square, polynomial, (low, high) = told[node.level]
                own = levels.squares[node.level]
                if not _is_root(own, square, polynomial) or not _is_between(own, low, high):
                    faults.append(f"node {self.number[node]}: squared radius {float(own)}")
            if node.tie != row[6]:
                faults.append(f"node {self.number[node]}: tie is {node.tie} and {row[6]}")
        return faults

    def bars(self) -> list[str]:
        infinity = self.judge.levels.infinity
        own = Counter(
            (self.number[bar.leaf], bar.birth, bar.death, bar.is_essential)
            for bar in self.judge.tree.bars
        )
        other = Counter(
            (leaf, birth, infinity if death is None else death, essential)
            for leaf, birth, death, _, essential, _ in self.found.bars()
        )
        return [] if own == other else [f"bars: {sorted(own)} and {sorted(other)}"]

    def tracks(self) -> list[tuple[int, int]]:
        infinity = self.judge.levels.infinity
        rows = self.found.tracks(0, self.found.track_count)
        return sorted((row[2], infinity if row[3] is None else row[3]) for row in rows)

    def alive(self, alpha: Fraction, counts: Counter[str]) -> list[str]:
        """Features: bar, leaves, bridges, pocket minimum."""
        own = {}
        for feature in self.judge.alive(alpha * alpha / 4):
            chords = [tuple(_near(p) for p in chord) for _, chord in feature.bridges]
            pocket = None
            if feature.pocket is not None:
                depth = math.inf if feature.depth is None else float(feature.depth) ** 0.5
                pocket = self._leaf(feature.pocket), depth, feature.tie
            leaves = sorted(map(self._leaf, feature.leaves))
            own[self.number[feature.bar.leaf]] = leaves, chords, pocket
        other = {}
        bar_leaves = [row[0] for row in self.found.bars()]
        for _, bar, leaves, pocket_row, bridges in self.found.at(str(alpha)):
            told = None
            if pocket_row is not None:
                leaf, _, (low, high), tie = pocket_row
                told = leaf, low if math.isinf(low) else (low + high) / 2, tie
            ends = [((b[0][2], b[0][3]), (b[2][2], b[2][3])) for b in bridges]
            other[bar_leaves[bar]] = sorted(leaves), ends, told
        if own.keys() != other.keys():
            return [f"alpha {alpha}: features {sorted(own)} and {sorted(other)}"]
        faults = []
        for leaf, (leaves, chords, pocket) in own.items():
            counts["features alive"] += 1
            counts["bridges"] += len(chords)
            counts["pocket minima"] += pocket is not None
            if leaves != other[leaf][0]:
                faults.append(f"alpha {alpha}, feature {leaf}: leaves {leaves}, {other[leaf][0]}")
            if not self._are_same_chords(chords, other[leaf][1]):
                faults.append(f"alpha {alpha}, feature {leaf}: bridges {chords}, {other[leaf][1]}")
            if not self._is_same_pocket(pocket, other[leaf][2]):
                faults.append(f"alpha {alpha}, feature {leaf}: pocket {pocket}, {other[leaf][2]}")
        return faults

    def notches(self, alpha: Fraction, dice: random.Random, counts: Counter[str]) -> list[str]:
        """Notches without a least persistence, and with one that leaves out some; in a range."""
        lengths = [bar.death - bar.birth for bar in self.judge.tree.bars]
        taus = [Fraction(0)]
        if lengths:
            taus.append(Fraction(dice.randint(1, 40), dice.randint(4, 20)))
        faults = []
        for tau in taus:
            for alpha_to in (None, alpha + Fraction(dice.randint(1, 30), 10)):
                own = [
                    (*self.judge.wedge_name(notch.wedge)[1:3], notch.tie)
                    for notch in self.judge.notches(alpha, tau, alpha_to)
                ]
                to = None if alpha_to is None else str(alpha_to)
                rows = self.found.notches(str(alpha), str(tau), to)
                other = [(x, y, tie) for x, y, _, _, tie in rows]
                counts["notches"] += len(own)
                if own != other:
                    faults.append(f"notches at {alpha}, {tau}, to {alpha_to}: {own} and {other}")
        return faults

    def _leaf(self, wedge: int) -> int:
        return next(
            self.number[node]
            for node in self.nodes
            if node.kind == "reflex" and node.wedge == wedge
        )

    def _are_same_chords(self, own: Sequence[Any], other: Sequence[Any]) -> bool:
        left = list(other)
        for chord in own:
            partner = next((o for o in left if self._is_same_chord(chord, o)), None)
            if partner is None:
                return False
            left.remove(partner)
        return not left

    def _is_same_chord(self, a: Any, b: Any) -> bool:
        return any(
            all(math.dist(p, q) < self.slack for p, q in zip(a, ends, strict=True))
            for ends in (b, b[::-1])
        )

    def _is_same_pocket(self, a: Any, b: Any) -> bool:
        if a is None or b is None:
            return a is b
        return bool(
            a[0] == b[0] and a[2] == b[2] and (a[1] == b[1] or abs(a[1] - b[1]) < self.slack)
        )


def _near(p: tuple[Number, Number]) -> Spot:
    return float(p[0]), float(p[1])


def _is_root(value: Number, square: str | None, polynomial: Sequence[str]) -> bool:
    if square is not None and (value - Fraction(square)).sign() != 0:
        return False
    total = number(0)
    for factor in reversed(polynomial):
        total = total * value + Fraction(factor)
    return total.sign() == 0


def _is_between(square: Number, low: float, high: float) -> bool:
    return (square - Fraction(low) ** 2).sign() >= 0 >= (square - Fraction(high) ** 2).sign()
