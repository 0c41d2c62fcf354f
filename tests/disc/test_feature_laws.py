"""Laws of features: counts, other ways to write a set, similar sets, and the static sum beside the
bridges."""

from __future__ import annotations

import json
import math
import os
import random
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

import minkref
import pytest
from minkref import _core
from thoroughness import draws

SHAPES = draws(12, 60)
MODELS = {"neuron": (995, 19), "nazca_monkey": (577, 37), "bird": (133, 8)}
Move = Callable[[Fraction, Fraction], tuple[Fraction, Fraction]]


@cache
def random_set(seed: int) -> minkref.PolygonSet:
    """Boxes and triangles on a small lattice, united: with holes, islands, symmetries and ties."""
    dice = random.Random(seed)
    side = dice.choice((4, 6, 9))
    pieces = []
    for _ in range(dice.randint(2, 9)):
        x, y = dice.randint(0, side), dice.randint(0, side)
        w, h = dice.randint(1, 4), dice.randint(1, 4)
        ring = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
        if dice.random() < 0.4:
            del ring[dice.randint(0, 3)]
        pieces.append(minkref.PolygonSet(ring))
    return minkref.unite(pieces)


def moved(P: minkref.PolygonSet, move: Move, turns_over: bool = False) -> minkref.PolygonSet:
    step = -1 if turns_over else 1
    return minkref.PolygonSet(
        [[[move(Fraction(x), Fraction(y)) for x, y in ring][::step] for ring in rings]
         for rings in P.rings()]
    )  # fmt: skip


def shape_of(found: minkref.Features, with_ties: bool) -> Any:
    """The tree without places: kinds, the order of radii, children; and the bars. Ties too, if the
    map keeps the order of places: the leaf chosen by a tie counts for later depths."""
    ranks = {alpha: k for k, alpha in enumerate(sorted({node.alpha for node in found.tree}))}

    def of(number: int) -> Any:
        node = found.tree[number]
        children = sorted((of(child) for child in node.children), key=repr)
        tie = with_ties and node.tie
        return node.kind, ranks[node.alpha], tie, len(node.places), children

    roots = sorted((of(node.number) for node in found.tree if node.parent is None), key=repr)
    bars = Counter((ranks[bar.birth], ranks[bar.death], bar.essential) for bar in found.bars)
    return roots, bars


@pytest.mark.parametrize("seed", range(SHAPES))
def test_similar_sets_have_similar_features(seed: int) -> None:
    P = random_set(seed)
    found = minkref.features(P)
    c, s = Fraction(3, 5), Fraction(4, 5)
    similar: dict[str, tuple[Move, bool, Fraction]] = {
        "scaled": (lambda x, y: (x * 7 / 3, y * 7 / 3), False, Fraction(7, 3)),
        "turned": (lambda x, y: (c * x - s * y, s * x + c * y), False, Fraction(1)),
        "mirrored": (lambda x, y: (-x, y), True, Fraction(1)),
        "moved": (lambda x, y: (x + Fraction(1, 3), y - 1000), False, Fraction(1)),
    }
    for name, (move, turns_over, factor) in similar.items():
        other = minkref.features(moved(P, move, turns_over))
        in_order = name in ("scaled", "moved")
        assert shape_of(other, in_order) == shape_of(found, in_order), (seed, name)
        for node, image in zip(found.tree, other.tree, strict=True):
            square, other_square = node.squared_radius, image.squared_radius
            if square is not None and other_square is not None:  # known to be rational
                assert other_square == square * factor**2, (seed, name)


@pytest.mark.parametrize("seed", range(SHAPES))
def test_rings_may_start_anywhere_in_any_order(seed: int) -> None:
    P = random_set(seed)
    dice = random.Random(seed)

    def turned(ring: Any) -> Any:
        at = dice.randrange(len(ring))
        return [*ring[at:], *ring[:at]]

    polygons = [
        [turned(rings[0]), *(turned(hole) for hole in dice.sample(rings[1:], len(rings) - 1))]
        for rings in P.rings()
    ]
    dice.shuffle(polygons)
    found, other = minkref.features(P), minkref.features(minkref.PolygonSet(polygons))
    assert other.canonical_json() == found.canonical_json()
    assert other.digest == found.digest
    assert other.bars == found.bars
    assert other.notches(0) == found.notches(0)


def corners_of(P: minkref.PolygonSet, squared_radius: Fraction) -> int:
    """Counts the corners along the static sum's boundary: curves meet there without touching."""
    form = json.loads(_core.offset(P, str(squared_radius)).canonical_json())
    count = 0
    for component in form["components"]:
        for ring in (component["outer"], *component["holes"]):
            for k, curve in enumerate(ring if len(ring) > 1 else []):
                count += not _touch(curve, ring[k - 1])
    return count


def _touch(a: list[str], b: list[str]) -> bool:
    if a[0] == b[0]:
        return False
    arc, line = (a, b) if a[0] == "arc" else (b, a)
    (x, y), (dx, dy, c) = map(Fraction, arc[1:]), map(Fraction, line[1:])
    return dy * x - dx * y == c


@pytest.mark.parametrize("seed", range(SHAPES))
def test_bridges_are_the_corners_of_the_static_sum(seed: int) -> None:
    P = random_set(seed)
    found = minkref.features(P)
    dice = random.Random(seed)
    radii = [0.0, *(high for _, high in minkref.DiscIndex(P).radii)]
    for low, high in zip(radii, [*radii[1:], radii[-1] * 2 + 1], strict=True):
        alpha = Fraction(2 * (low + (high - low) * dice.uniform(0.2, 0.8)))
        if not low < float(alpha / 2) < high or dice.random() < 0.5:
            continue
        alive = found.at(alpha)
        bridges = sum(len(feature.bridges) for feature in alive)
        assert bridges == corners_of(P, (alpha / 2) ** 2), (seed, alpha)
        tracks = [t for t in found.tracks if t.birth[1] < alpha < t.death[0]]
        assert bridges == len(tracks), (seed, alpha)
        bars = [bar for bar in found.bars if bar.birth[1] < alpha <= bar.death[0]]
        assert Counter(bar.leaf for bar in bars) == Counter(
            found.bars[feature.bar].leaf for feature in alive
        ), (seed, alpha)


@pytest.mark.parametrize("seed", range(SHAPES))
def test_at_infinity_bridges_are_the_gaps_of_the_hull(seed: int) -> None:
    P = random_set(seed)
    found = minkref.features(P)
    gaps = {
        frozenset(((end[1][0], end[1][1]), (end[1][2], end[1][3])))
        for track in found.tracks for end in track.ends if end[0] == "infinity"
    }  # fmt: skip
    last = Fraction(max([high for _, high in minkref.DiscIndex(P).radii], default=0.0)) * 2 + 1
    bridges = [frozenset(b.ends) for feature in found.at(last) for b in feature.bridges]
    assert set(bridges) == gaps and len(bridges) == len(gaps), seed


@pytest.mark.parametrize("seed", range(SHAPES))
def test_at_zero_features_are_the_reflex_vertices(seed: int) -> None:
    P = random_set(seed)
    found = minkref.features(P)
    ends = [node for node in found.tree if node.kind == "reflex"]
    radii = minkref.DiscIndex(P).radii
    least = Fraction(min([low for low, _ in radii], default=1.0))
    assert len(found.at(least)) == len(ends) == len(found.notches(0)), seed
    assert {notch.vertex for notch in found.notches(0)} == {end.vertex for end in ends}, seed
    assert found.notches(0, "inf") == []
    many, few = found.notches(1), found.notches(1, Fraction(1, 2))
    assert {n.vertex for n in few} <= {n.vertex for n in many}, seed


def nodes_and_ends(P: minkref.PolygonSet) -> tuple[int, int, int]:
    """The sum of (nearest points - 2) over the axis's nodes; ends at vertices, and at infinity."""
    degrees: Counter[str] = Counter()
    ends: Counter[str] = Counter()
    for *both, _, _ in _core.disc_index(P).graph():
        for kind, told in both:
            if kind == "event":
                degrees[told[0]] += 1
            else:
                ends[kind] += 1
    return sum(n - 2 for n in degrees.values()), ends["vertex"], ends["infinity"]


@pytest.mark.parametrize("seed", range(SHAPES))
def test_the_count_of_nodes(seed: int) -> None:
    P = random_set(seed)
    excess, reflex, gaps = nodes_and_ends(P)
    if excess == reflex == gaps == 0:
        return  # convex
    index = minkref.DiscIndex(P)
    least = Fraction(min(low for low, _ in index.radii)) / 2
    components, holes = index.components_and_holes(least)
    assert excess == reflex - gaps + 2 * (components - holes) - 2, seed


@pytest.mark.skipif(not os.environ.get("MINKREF_MODELS"), reason="MINKREF_MODELS not set")
@pytest.mark.parametrize("name", MODELS)
def test_leaves_of_the_models_of_the_paper(name: str) -> None:
    found = _core.features(minkref.read_file(f"{os.environ['MINKREF_MODELS']}/{name}.poly"))
    ends = [end[0] for low, high, *_ in found.tracks(0, found.track_count) for end in (low, high)]
    nodes = found.nodes()
    reflex = sum(kind == "reflex" for kind, *_ in nodes)
    assert (reflex, ends.count("infinity"), ends.count("vertex")) == (*MODELS[name], reflex)
    leaves = sum(not children for _, _, _, children, *_ in nodes)
    endless = [row for row in found.bars() if row[2] is None]
    assert len(found.bars()) == leaves and sum(row[4] for row in endless) == 1


@pytest.mark.parametrize("seed", range(SHAPES))
def test_bars_follow_from_the_tree_by_the_elder_rule(seed: int) -> None:
    """At each node all births but the least end; at a root the least one, too."""
    found = minkref.features(random_set(seed))
    oldest: list[tuple[float, float]] = []
    bars: list[tuple[Any, Any]] = []
    for node in found.tree:
        births = sorted(oldest[child] for child in node.children) or [node.alpha]
        oldest.append(births[0])
        ended = births[1:] if node.parent is not None else births
        bars += [(birth, node.alpha) for birth in ended]
    assert Counter(bars) == Counter((bar.birth, bar.death) for bar in found.bars), seed
    roots = [node.number for node in found.tree if node.parent is None]
    assert sorted(bar.end for bar in found.bars if bar.essential) == roots, seed


@pytest.mark.parametrize("seed", range(SHAPES))
def test_the_deepest_leaf_lies_farthest_behind_the_bridges(seed: int) -> None:
    found = minkref.features(random_set(seed))
    for alpha in (Fraction(1, 2), Fraction(3, 2), Fraction(4)):
        for feature in found.at(alpha):
            depths = {
                leaf: min(
                    (_height(found.tree[leaf].vertex, *b.near) for b in feature.bridges),
                    default=math.inf,
                )
                for leaf in feature.leaves
            }
            if not depths:
                assert feature.deepest is None and feature.depth is None
                continue
            assert feature.deepest is not None and feature.depth is not None
            assert depths[feature.deepest] == pytest.approx(max(depths.values()), abs=1e-9), seed
            assert feature.depth[1] == pytest.approx(max(depths.values()), abs=1e-9), seed
            deepest = [leaf for leaf in depths if depths[leaf] > max(depths.values()) - 1e-9]
            assert feature.deepest == deepest[0] and feature.tie == (len(deepest) > 1), seed


def _height(vertex: Any, a: tuple[float, float], b: tuple[float, float]) -> float:
    x, y = b[0] - a[0], b[1] - a[1]
    return float(abs(x * (float(vertex[1]) - a[1]) - y * (float(vertex[0]) - a[0]))) / math.hypot(
        x, y
    )


@pytest.mark.parametrize("seed", range(SHAPES))
def test_bounds_of_depths_are_neighbouring_doubles(seed: int) -> None:
    found = minkref.features(random_set(seed))
    for notch in found.notches(Fraction(3, 2)):
        low, high = notch.depth
        assert high in (low, math.nextafter(low, math.inf)), seed
