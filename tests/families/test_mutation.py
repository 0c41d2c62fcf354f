"""Mutants are valid pairs close to their parents; probes lie at their stated scales."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.geometry.plane import read_shape
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.mutation import CHANGES, mutate
from minkref.fuzz.plane.families.probes import boundary_scales, scale_probes

SEED = 14


@pytest.mark.parametrize("name", FAMILIES)
def test_mutants_are_valid(name: str) -> None:
    changed = 0
    for index in range(0, 120, 12):
        pair = FAMILIES[name].pair(SEED, index)
        texts = (pair.P, pair.Q, pair.scale)
        dice = random.Random(f"{name} {index}")
        for _ in range(3):
            before, texts = texts, mutate(dice, *texts)
            changed += before != texts
            P, Q = (_core.PolygonSet.from_json(text) for text in texts[:2])
            P.validate(f"{name}:{SEED}:{index}")
            Q.validate(f"{name}:{SEED}:{index}")
            assert P.is_region or Q.is_region or P.is_empty or Q.is_empty
            assert Fraction(texts[2]) > 0
            _core.minkowski_sum(P, Q, texts[2])
    assert changed >= 24


def test_a_mutant_depends_on_the_dice_only() -> None:
    pair = FAMILIES["holes"].pair(SEED, 30)
    mutants = [mutate(random.Random(k % 4), pair.P, pair.Q, pair.scale) for k in range(8)]
    assert mutants[:4] == mutants[4:] and len(set(mutants)) > 2


@pytest.mark.parametrize("change", dict.fromkeys(CHANGES), ids=lambda change: change.__name__)
def test_every_change_changes_something(change: object) -> None:
    assert callable(change)
    dice = random.Random(SEED)
    pair = FAMILIES["nested"].pair(SEED, 200)
    changed = 0
    for _ in range(20):
        before = read_shape(pair.P)
        changed += change(dice, read_shape(pair.P), read_shape(pair.Q), Fraction(1)) != before
    assert changed > 5


@pytest.mark.parametrize("name", ["holes", "fit", "touching", "convex", "rational"])
def test_probes_lie_where_they_say(name: str) -> None:
    seen = set()
    for index in range(0, 60, 10):
        pair = FAMILIES[name].pair(SEED, index)
        events = boundary_scales(pair.P, pair.Q)
        probes = scale_probes(pair.P, pair.Q, 12)
        assert len(probes) <= 12 and len(set(probes)) == len(probes)
        for position, text in probes:
            scale = Fraction(text)
            assert scale > 0
            seen.add(position)
            assert (position == "at") == (scale in events)
            if not events:
                continue
            nearest = min(events, key=lambda event: abs(event - scale))
            if position == "below":
                assert scale < nearest <= scale + Fraction(1, 2**10)
            if position == "above":
                assert nearest < scale <= nearest + Fraction(1, 2**10)
            seen.add(position)
    assert "far" in seen and (name == "convex" or seen == {"at", "below", "above", "far"})


def test_pairs_without_area_have_far_scales_only() -> None:
    point = '{"polygons":[{"holes":[],"outer":[["0","0"]]}]}'
    box = '{"polygons":[{"holes":[],"outer":[["0","0"],["1","0"],["1","1"]]}]}'
    assert scale_probes(point, box, 2) == [("far", "1"), ("far", "1/2")]
