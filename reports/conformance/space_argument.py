"""Why a witness in space proves what it says: p and q, or a plane between sP and x - Q."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, scale_of
from minkref.fuzz.verdicts.verdict import Witness
from minkref.reports.conformance.argument import around, inside, outside, point_text


def argument_in_space(P: str, Q: str, scale: str, witness: Witness) -> list[str]:
    """Sentences about a witness in space."""
    at = witness.scale or scale
    own, other = Polyhedron.from_json(P), Polyhedron.from_json(Q)
    if witness.in_truth and witness.p and witness.q:
        places = (_place("P", own, witness.p), _place("Q", other, witness.q))
        return [*inside(witness, at, places), *around(witness)]
    x, y, z = (Fraction(number) for number in witness.point)
    first, second = own.scaled(scale_of(at)), other.reflected((x, y, z))
    return [
        *outside(witness, at),
        _apart(first, second),
        "So x is not in the sum.",
        *around(witness),
    ]


def _place(name: str, solid: Polyhedron, numbers: tuple[str, ...]) -> str:
    point = tuple(Fraction(number) for number in numbers)
    return f"is a vertex of {name}" if point in solid.vertices else f"lies in {name}"


def _apart(first: Polyhedron, second: Polyhedron) -> str:
    for axis, name in enumerate("xyz"):
        spans = [(solid.box[0][axis], solid.box[1][axis]) for solid in (first, second)]
        (a, b), (c, d) = spans
        if b < c or d < a:
            spread = f"sP has {a} <= {name} <= {b}, and x - Q has {c} <= {name} <= {d}"
            return f"They do not meet: {spread}."
    for names, solid, other in (("sP", first, second), ("x - Q", second, first)):
        for number, face in enumerate(solid.faces):
            u, v, w = (solid.vertices[index] for index in face[:3])
            if _parted(u, v, w, solid, other):
                corners = " ".join(point_text(p) for p in (u, v, w))
                return (
                    f"They do not meet: the plane of face {number} of {names}, through {corners}, "
                    "has that one on one side or in it, and the other strictly on the other."
                )
    return (
        "They do not meet: no face of one meets a face of the other, and neither holds a vertex of "
        "the other."
    )


def _parted(u: Point, v: Point, w: Point, solid: Polyhedron, other: Polyhedron) -> bool:
    own = [_side(u, v, w, p) for p in solid.vertices]
    others = [_side(u, v, w, p) for p in other.vertices]
    if not any(own):
        return False  # the three corners lie on one line
    return (max(own) <= 0 < min(others)) or (min(own) >= 0 > max(others))


def _side(u: Point, v: Point, w: Point, p: Point) -> Fraction:
    """The determinant of v - u, w - u, p - u, which tells p's side of the plane."""
    (a, b, c), (d, e, f), (g, h, i) = (tuple(t[k] - u[k] for k in range(3)) for t in (v, w, p))
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
