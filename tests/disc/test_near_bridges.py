"""Bridges in doubles are the exact ones within the stated error, at events and between."""

from __future__ import annotations

import random
from fractions import Fraction

import minkref
import numpy as np
import pytest
from test_feature_laws import random_set
from thoroughness import draws

FAR = Fraction(10) ** 12


@pytest.mark.parametrize("seed", range(draws(12, 60)))
def test_bridges_in_doubles_are_the_exact_ones_within_their_error(seed: int) -> None:
    dice = random.Random(f"near bridges {seed}")
    P = random_set(seed)
    if seed % 3 == 2:
        P = P.translated(FAR, -FAR)
    found = minkref.features(P)
    ends = sorted({node.alpha for node in found.tree if node.squared_radius is not None})
    diameters = [dice.uniform(0.1, 6), *(low for low, high in ends if 0 < low == high)]
    for diameter in diameters:
        places, owners = found.near(diameter)
        exact = found.at(Fraction(diameter))
        assert len(places) == len(owners) == sum(len(feature.bridges) for feature in exact)
        for feature in exact:
            mine = owners[:, 0] == feature.node
            assert set(owners[mine, 1]) <= {feature.bar}
            rows = sorted(map(tuple, places[mine]))
            bridges = sorted((*b.near[0], *b.near[1], *b.centre) for b in feature.bridges)
            for row, bridge in zip(rows, bridges, strict=True):
                off = np.abs(np.array(row[:6]) - np.array(bridge))
                assert np.all(off <= row[6] + np.spacing(np.abs(bridge))), (seed, diameter)
