"""Seeded sums of solids of any shape and balls, and erosions by balls, before the definition at
exact points."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, field
from fractions import Fraction

import minkref
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.judges.space.ball_distance import BallDistance
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import general_pair

SHARES = tuple(Fraction(text) for text in ("1/2", "1/4", "1/8", "1/16"))  # tolerance by radius


@dataclass
class BallTrial:
    """`places`: how many points lay in the inner set, between both sets, and outside."""

    name: str
    points: int = 0
    places: list[int] = field(default_factory=lambda: [0, 0, 0])
    faults: list[str] = field(default_factory=list)


def ball_trial(seed: int, index: int, points: int) -> BallTrial:
    """Sums the first solid of a pair and a ball of a random radius, or erodes it, in turn (only
    sums, of a segment or a point); half of the radii are roots. Asks for points near the surface of
    the answer, of both sets and by distances. Exact."""
    pair = general_pair(seed, index)
    dice = random.Random(f"minkref balls {seed} {index}")
    solid = pair.P
    erodes = index % 2 == 1 and not solid.is_thin
    size = max(max(c) - min(c) for c in zip(*solid.vertices, strict=True)) or 1
    square = (size * Fraction(dice.randrange(2, 30), 400 if erodes else 40)) ** 2
    if dice.random() < 0.5:
        square *= Fraction(dice.randrange(3, 9), 5)
    R = Fraction(math.isqrt(int(square * 4**40))) / 2**40  # below the radius by 2^-40 at most
    T = (dice.choice(SHARES) * R).limit_denominator(1000)
    ball, P = minkref.Ball(squared_radius=square), core_polyhedron(solid)
    found = minkref.ball_erosion(P, ball, T) if erodes else minkref.ball_sum(P, ball, T)
    distance, trial = BallDistance(solid), BallTrial(pair.name)
    laws_at = _eroded if erodes else _summed
    for _ in range(points):
        x = _near(dice, solid.vertices, -R if erodes else R, T)
        inner, outer = x in found.inner, x in found.outer
        laws = laws_at(distance, x, inner, outer, (R, square, T))
        trial.faults += [f"{pair.name}: {law} at {x}" for law, holds in laws.items() if not holds]
        trial.points += 1
        trial.places[0 if inner else 1 if outer else 2] += 1
    low, high = found.volume
    if not low <= high:
        trial.faults.append(f"{pair.name}: volumes {low} and {high}")
    return trial


Size = tuple[Fraction, Fraction, Fraction]  # the radius, its square, the tolerance


def _summed(
    distance: BallDistance, x: Point, inner: bool, outer: bool, size: Size
) -> dict[str, bool]:
    (R, square, T), at = size, distance.squared(x)
    return {
        "inner within the sum": at <= square or not inner,
        "the sum within outer": outer or at > square,
        "inner as near as promised": inner or at > max(R - T, Fraction(0)) ** 2,
        "outer as near as promised": not outer or at <= (R + Fraction(1, 2**40) + T) ** 2,
    }


def _eroded(
    distance: BallDistance, x: Point, inner: bool, outer: bool, size: Size
) -> dict[str, bool]:
    (R, square, T), at = size, Fraction(-1)
    if distance.contains(x):
        at = distance.squared_from_surface(x)
    return {
        "inner within the erosion": at >= square or not inner,
        "the erosion within outer": outer or at <= square,
        "inner as near as promised": inner or at <= (R + Fraction(1, 2**40) + T) ** 2,
        "outer as near as promised": not outer or at >= max(R - T, Fraction(0)) ** 2,
    }


def _near(dice: random.Random, vertices: tuple[Point, ...], R: Fraction, T: Fraction) -> Point:
    """A point about R away from a point between two vertices."""
    a, b = dice.choice(vertices), dice.choice(vertices)
    share = Fraction(dice.randrange(9), 8)
    way = [Fraction(dice.randrange(-64, 65), 64) for _ in range(3)]
    length = Fraction(math.sqrt(float(sum(w * w for w in way))) or 1.0).limit_denominator(512)
    far = R + T * Fraction(dice.randrange(-12, 13), 8)
    x, y, z = (p + share * (q - p) + far * w / length for p, q, w in zip(a, b, way, strict=True))
    return x, y, z
