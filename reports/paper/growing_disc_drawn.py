"""Drawings for Fig. 12: corners of a sum with a disc beside the pocket minima, and pieces."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core, decompose, features
from minkref.offset_picture import offset_picture
from minkref.reports.drawing import Layer, picture

WIDTH = 420


def pockets_drawn(P: _core.PolygonSet, diameter: str) -> str:
    """The sum's corners, each as a point, and from it a line to the deepest vertex of its
    feature."""
    found = features(P)
    marks: list[list[tuple[float, float]]] = []
    for feature in found.at(diameter):
        deepest = None if feature.deepest is None else found.tree[feature.deepest].vertex
        for bridge in feature.bridges:
            marks.append([bridge.centre])
            if deepest is not None:
                marks.append([bridge.centre, (float(deepest[0]), float(deepest[1]))])
    grown = _core.offset(P, str((Fraction(diameter) / 2) ** 2))
    return offset_picture(grown, P, f"α = {diameter}", marks)


def pieces_drawn(P: _core.PolygonSet, diameter: Fraction, last: Fraction, lasting: Fraction) -> str:
    found = decompose(P, alpha=diameter, alpha_to=last, persistence=lasting)
    drawn = [ring for piece in found.pieces for ring in piece.region.approximate_rings()]
    return picture([Layer("first", drawn)], "pieces", WIDTH)
