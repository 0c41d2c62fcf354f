"""Area and length of a sum with a disc, from its corners, in numbers of 1,500 bits."""

from __future__ import annotations

import gmpy2
from minkref.reports.evidence.as_written.curves import Arc, Grown, Piece
from minkref.reports.evidence.as_written.units import Real


def angle(piece: Piece) -> Real:
    """How far an arc turns, counter-clockwise, more than 0 and at most a whole turn."""
    whole = 2 * gmpy2.const_pi()
    if piece.start is None or piece.end is None:
        return whole
    assert isinstance(piece.curve, Arc)
    x, y = piece.curve.x, piece.curve.y
    ax, ay = piece.start[0] - x, piece.start[1] - y
    bx, by = piece.end[0] - x, piece.end[1] - y
    turned = gmpy2.atan2(gmpy2.mpfr(ax * by - ay * bx), gmpy2.mpfr(ax * bx + ay * by))
    return turned if turned > 0 else turned + whole


def area_and_length(of: Grown) -> tuple[Real, Real]:
    """Green's formula about a corner, and the lengths of all pieces."""
    radius = of.radius
    doubled, length, corner = gmpy2.mpfr(0), gmpy2.mpfr(0), _some_corner(of)
    for piece in (piece for ring in of.rings for piece in ring):
        arc = isinstance(piece.curve, Arc)
        turned = angle(piece) if arc else gmpy2.mpfr(0)
        if arc:
            doubled += of.squared * turned
            length += radius * turned
        if piece.start is None or piece.end is None:
            continue
        ax, ay = piece.start[0] - corner[0], piece.start[1] - corner[1]
        bx, by = piece.end[0] - corner[0], piece.end[1] - corner[1]
        if isinstance(piece.curve, Arc):
            x, y = piece.curve.x - corner[0], piece.curve.y - corner[1]
            doubled += x * (by - ay) - y * (bx - ax)
        else:
            doubled += ax * by - ay * bx
            length += gmpy2.sqrt(gmpy2.mpfr((bx - ax) ** 2 + (by - ay) ** 2))
    return doubled / 2, length


def _some_corner(of: Grown) -> tuple[Real, Real]:
    starts = [piece.start for ring in of.rings for piece in ring if piece.start is not None]
    return starts[0] if starts else (gmpy2.mpq(0), gmpy2.mpq(0))


def bulge(piece: Piece) -> Real:
    """The tangent of a quarter of an arc's angle, as in DXF; 0 for a line."""
    if not isinstance(piece.curve, Arc):
        return gmpy2.mpq(0)
    return gmpy2.tan(angle(piece) / 4)
