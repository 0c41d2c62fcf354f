"""Squared radii of events of a disc against computer algebra: each set of two or three of an
event's features singles out the same algebraic number.

`python -m minkref.fuzz.judges.disc.equidistant_comparison SEED COUNT` compares COUNT of each kind,
a third of them degenerate, prints the table as JSON and exits with 1 if there is a difference."""

from __future__ import annotations

import json
import random
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations
from typing import Any

import sympy as sp
from minkref import _core
from minkref.fuzz.features.outline import Outline
from minkref.fuzz.judges.disc.disc_diagram import drawn_set
from minkref.oracle.symbolic.disc import disc_diagram
from minkref.oracle.symbolic.disc.disc import Offset
from minkref.oracle.symbolic.disc.disc_diagram import Feature, SquaredRadius
from minkref.oracle.symbolic.rational import Rational

KINDS = (
    "three points", "two points, line", "point, two lines", "three lines",
    "joint, point", "joint, line", "saddle, two points", "saddle, point, line",
)  # fmt: skip
SAME_PLACE = 1e-9  # times the distance from the origin and the radius
MOST_SETS = 20_000  # until each kind has enough cases


@dataclass(frozen=True)
class Choice:
    """Features that single out an event's place, in the order that their kind asks for."""

    kind: str
    features: tuple[Feature, ...]

    def candidates(self) -> list[SquaredRadius]:
        if self.kind.startswith("saddle"):
            return disc_diagram.between(self.features[0], self.features[1])
        if self.kind.startswith("joint"):
            end, edge, other = self.features
            assert not isinstance(end, Offset) and isinstance(edge, Offset)
            return disc_diagram.in_front(end, edge, other)
        return disc_diagram.equidistant(self.features)


@dataclass
class Table:
    """`counts`: cases by kind; `degenerate`: cases with a tie: more than three features, parallel
    lines, or another event at the same radius. `no_place`: choices from events with more features
    that single out no place; `not_told`: rational squared radii for which minkref only has a
    polynomial with a higher degree, and bounds."""

    counts: Counter[str] = field(default_factory=Counter)
    degenerate: Counter[str] = field(default_factory=Counter)
    degrees: Counter[int] = field(default_factory=Counter)
    no_place: int = 0
    not_told: int = 0
    sets: int = 0
    differences: list[str] = field(default_factory=list)


def choices(features: Sequence[Feature]) -> Iterator[Choice]:
    """Yields a pair of two features, or triples of more, except triples on one line or with a
    common vertex, which single out no place."""
    if len(features) == 2:
        has_line = any(isinstance(feature, Offset) for feature in features)
        yield Choice(KINDS[6 + has_line], tuple(features))
        return
    for triple in combinations(features, 3):
        points = [feature for feature in triple if not isinstance(feature, Offset)]
        lines = [feature for feature in triple if isinstance(feature, Offset)]
        ends = [(point, line) for point in points for line in lines if is_on(point, line)]
        if len(ends) > 1:
            continue
        if not ends:
            yield Choice(KINDS[len(lines)], (*points, *lines))
            continue
        point, line = ends[0]
        other = next(f for f in triple if f is not point and f is not line)
        kind = KINDS[5 if isinstance(other, Offset) else 4]
        yield Choice(kind, (point, line, other))


def is_on(point: Feature, line: Offset) -> bool:
    assert not isinstance(point, Offset)
    (x, y), (u, v) = line.p, line.edge
    return bool(u * (point[1] - y) == v * (point[0] - x))


def is_degenerate(choice: Choice, count: int, is_tied: bool) -> bool:
    lines = [feature.edge for feature in choice.features if isinstance(feature, Offset)]
    parallel = any(a[0] * b[1] == a[1] * b[0] for a, b in combinations(lines, 2))
    return parallel or count > 3 or is_tied


def difference(choice: Choice, row: Any, outline: Outline) -> str | None:
    """Returns the difference from a row of minkref's list, or None. Raises LookupError if the
    features single out no place."""
    _, square, coefficients, (low, high), at, _ = row
    place = outline.spot(*at)
    candidates = choice.candidates()
    if not candidates:
        raise LookupError
    here = [each for each in candidates if is_at(each, place, high)]
    if not here:
        return "no place of the features is that of the event"
    polynomial = [Fraction(c) for c in reversed(coefficients)]
    span = Rational(Fraction(low)) ** 2, Rational(Fraction(high)) ** 2
    return min(
        (told(each, square, polynomial, span) for each in here), key=lambda why: why is not None
    )


def is_not_told(row: Any) -> bool:
    """Whether the polynomial has a rational root in the bounds, and no rational number is told."""
    _, square, coefficients, (low, high), _, _ = row
    if square is not None:
        return False
    polynomial = sp.Poly([sp.Rational(c) for c in reversed(coefficients)], sp.Symbol("R"))
    return any(
        Fraction(low) ** 2 <= Fraction(str(root)) <= Fraction(high) ** 2
        for root in polynomial.ground_roots()
    )


def is_at(found: SquaredRadius, place: tuple[float, float], radius: float) -> bool:
    if found.place is None:
        return True
    slack = SAME_PLACE * max(radius, *map(abs, place))
    return all(
        low - slack <= c <= high + slack
        for (low, high), c in zip(
            ((float(low), float(high)) for low, high in found.place), place, strict=True
        )
    )


def told(
    found: SquaredRadius, square: str | None, polynomial: list[Fraction], span: tuple[Any, Any]
) -> str | None:
    own = [Fraction(c) for c in found.polynomial]
    if any(remainder(polynomial, own)):
        return f"{list(map(str, polynomial))} is no multiple of {found.polynomial}"
    if square is not None and len(own) == 2 and square != str(-own[1] / own[0]):
        return f"the squared radius is {-own[1] / own[0]}, told is {square}"
    if square is not None and len(own) > 2:
        return f"the squared radius is not rational: a root of {found.polynomial}"
    low, high = max(span[0], found.bounds[0]), min(span[1], found.bounds[1])
    if low > high or count_roots(found.polynomial, low, high) != 1:
        return f"the root of {found.polynomial} is not in the bounds of the radius"
    if count_roots(polynomial, *span) != 1:
        return "another root of the polynomial is in the bounds of the radius"
    return None


def remainder(polynomial: list[Fraction], divisor: list[Fraction]) -> list[Fraction]:
    left = list(polynomial)
    while len(left) >= len(divisor):
        factor = left[0] / divisor[0]
        for k, c in enumerate(divisor):
            left[k] -= factor * c
        left.pop(0)
    return left


def count_roots(polynomial: Sequence[Any], low: Any, high: Any) -> int:
    """Counts the roots of a polynomial without multiple roots, in a closed interval."""

    def exact(value: Any) -> Any:
        return sp.Rational(int(value.numerator), int(value.denominator))

    found = sp.Poly([exact(c) for c in polynomial], sp.Symbol("R"))
    return int(found.count_roots(exact(low), exact(high)))


def features_of(outline: Outline, names: Sequence[tuple[str, str, str]]) -> list[Feature]:
    """Returns a row's features, with edges as in the outline."""
    found: list[Feature] = []
    for kind, first, second in names:
        if kind == "vertex":
            _, x, y = outline.vertex(first, second)
            found.append((Rational(x), Rational(y)))
            continue
        corners = outline.rings[int(first)]
        ends = corners[int(second)], corners[(int(second) + 1) % len(corners)]
        start, end = ((Rational(x), Rational(y)) for x, y in ends)
        found.append(Offset(start, end))
    return found


def compare(seed: int, count: int, table: Table) -> None:
    """Compares `count` cases per kind, a third degenerate, from numbered sets."""
    wanted = {False: count - count // 3, True: count // 3}
    have: Counter[tuple[str, bool]] = Counter()
    dice = random.Random(f"minkref equidistant {seed}")
    for number in range(MOST_SETS):
        if all(have[kind, tie] >= wanted[tie] for kind in KINDS for tie in wanted):
            return
        others = number - number // 3 - 1  # sets that are no clouds, one after the other
        name, P = cloud(dice) if number % 3 == 0 else drawn_set(seed, others)
        if P.is_empty or P.vertices < 3:
            continue
        table.sets += 1
        outline = Outline.of(P)
        rows = _core.diagram_events(P).rows(0, 10**9)
        radii = Counter(row[3] for row in rows)
        for row in rows:
            features = features_of(outline, row[5])
            for choice in choices(features):
                tie = is_degenerate(choice, len(features), radii[row[3]] > 1)
                if have[choice.kind, tie] >= wanted[tie]:
                    continue
                try:
                    why = difference(choice, row, outline)
                except LookupError:
                    table.no_place += 1
                    why = None if len(features) > 3 else "the features single out no place"
                    if why is None:
                        continue
                have[choice.kind, tie] += 1
                table.counts[choice.kind] += 1
                table.degenerate[choice.kind] += tie
                table.degrees[len(row[2]) - 1] += 1
                table.not_told += is_not_told(row)
                if why is not None:
                    table.differences.append(f"{name}, {choice.kind}, {row}: {why}")


def cloud(dice: random.Random) -> tuple[str, _core.PolygonSet]:
    """Triangles apart from each other: many places between vertices."""
    side, polygons = dice.randint(2, 4), []
    below = dice.choice((1, 7, 10))
    for x in range(side):
        for y in range(side):
            corners = [(dice.randint(1, 9), dice.randint(1, 9)) for _ in range(3)]
            (a, b), (c, d), (e, f) = corners
            turn = (c - a) * (f - b) - (d - b) * (e - a)
            ring = corners if turn > 0 else corners[::-1]
            placed = [[str(Fraction(10 * x + u, below)), str(Fraction(10 * y + v, below))]
                      for u, v in ring]  # fmt: skip
            if turn:
                polygons.append({"outer": placed, "holes": []})
    text = json.dumps({"polygons": polygons})
    return f"triangles {text}", _core.PolygonSet.from_json(text)


def main(arguments: list[str]) -> int:
    seed, count = map(int, arguments)
    table = Table()
    compare(seed, count, table)
    print(json.dumps(vars(table), indent=1))
    return 1 if table.differences or min(table.counts[kind] for kind in KINDS) < count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
