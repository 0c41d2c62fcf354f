"""Changes of coordinates that keep degeneracies: one affine map for both operands, except for their
positions, and another scale."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from random import Random

from minkref.degeneracies.solids.draft import Probe, SolidDraft
from minkref.degeneracies.space.vectors import vector
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.generators.mapped import Matrix, mapped, unimodular

SCALES = tuple(Fraction(text) for text in ("1", "1", "1", "2", "1/2", "3/2", "2/3"))
FAR = 3  # translations are up to this long along each axis


def placed(dice: Random, draft: SolidDraft, shears: bool = True) -> SolidDraft:
    """Changes the draft's coordinates. Half the time axes only change places, so that polycubes
    stay polycubes."""
    steps = dice.randint(1, 2) if shears and dice.random() < 0.5 else 0
    matrix = unimodular(dice, steps)
    first, second = (vector(*(dice.randint(-FAR, FAR) for _ in range(3))) for _ in range(2))
    return under(rescaled(draft, dice.choice(SCALES)), matrix, first, second)


def rescaled(draft: SolidDraft, scale: Fraction) -> SolidDraft:
    """Degenerate at this scale, the sum the same but larger; whole coordinates stay whole."""
    at_one = scale / draft.scale
    up, down = Fraction(at_one.denominator), Fraction(at_one.numerator)

    def larger(probe: Probe) -> Probe:
        return Probe(times(probe.p, up), times(probe.q, down))

    plain = draft.plain and (draft.plain[0].scaled(up), draft.plain[1].scaled(down))
    return replace(
        draft,
        P=draft.P.scaled(up),
        Q=draft.Q.scaled(down),
        scale=scale,
        probes=tuple(map(larger, draft.probes)),
        plain=plain,
    )


def under(draft: SolidDraft, matrix: Matrix, first: Point, second: Point) -> SolidDraft:
    """Both under the matrix, then each moved."""

    def image(solid: Polyhedron, by: Point) -> Polyhedron:
        return mapped(matrix, solid).translated(by)

    def moved(probe: Probe) -> Probe:
        return Probe(plus(applied(matrix, probe.p), first), plus(applied(matrix, probe.q), second))

    plain = draft.plain and (image(draft.plain[0], first), image(draft.plain[1], second))
    return replace(
        draft,
        P=image(draft.P, first),
        Q=image(draft.Q, second),
        probes=tuple(map(moved, draft.probes)),
        plain=plain,
    )


def swapped(dice: Random, draft: SolidDraft) -> SolidDraft:
    """P and Q perhaps in each other's place: `P + Q` for `Q + P`, at the inverse of the scale."""
    if dice.random() < 0.5:
        return draft
    probes = tuple(Probe(probe.q, probe.p) for probe in draft.probes)
    plain = draft.plain and draft.plain[::-1]
    return SolidDraft(draft.Q, draft.P, 1 / draft.scale, probes, plain)


def applied(matrix: Matrix, point: Point) -> Point:
    x, y, z = (sum((a * b for a, b in zip(row, point, strict=True)), Fraction(0)) for row in matrix)
    return x, y, z


def plus(a: Point, b: Point) -> Point:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def times(point: Point, factor: Fraction) -> Point:
    return point[0] * factor, point[1] * factor, point[2] * factor
