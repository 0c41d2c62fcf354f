"""Rational points on the unit circle and the unit sphere."""

from __future__ import annotations

from fractions import Fraction
from math import pi, tan

from minkref.fuzz.geometry.space import Point


def circle(count: int, fineness: int = 12) -> list[tuple[Fraction, Fraction]]:
    """Returns `count` points exactly on the unit circle, counter-clockwise from (1, 0), about
    evenly spread."""
    points = [(Fraction(1), Fraction(0))]
    for k in range(1, count):
        if 2 * k == count:
            points.append((Fraction(-1), Fraction(0)))
            continue
        # The float only chooses a grid number; equal on all machines that round it so.
        t = Fraction(round(tan(pi * k / count) * fineness), fineness)
        points.append(((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)))
    return points


def on_sphere(u: Fraction, v: Fraction) -> Point:
    """Returns the unit sphere's point whose stereographic projection is (u, v)."""
    square = u * u + v * v
    return (2 * u / (1 + square), 2 * v / (1 + square), (square - 1) / (1 + square))
