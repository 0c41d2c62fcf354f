"""Faults about the scale. They take P, Q, the scale and sP, and show only if the caller gives all
four: as adapters, not as plain functions of sP and Q."""

from __future__ import annotations

from fractions import Fraction

from plain_sum import PlainSum, Set


def scaled(operand: Set, scale: Fraction, about: tuple[Fraction, Fraction] | None = None) -> Set:
    """The operand scaled about a point, the origin where none is given."""
    cx, cy = about or (Fraction(0), Fraction(0))
    return {
        "polygons": [
            {
                "outer": [
                    [str((Fraction(x) - cx) * scale + cx), str((Fraction(y) - cy) * scale + cy)]
                    for x, y in polygon["outer"]
                ],
                "holes": [
                    [
                        [str((Fraction(x) - cx) * scale + cx), str((Fraction(y) - cy) * scale + cy)]
                        for x, y in hole
                    ]
                    for hole in polygon.get("holes", [])
                ],
            }
            for polygon in operand["polygons"]
        ]
    }


class ScaledSum(PlainSum):
    """A sum with state: `load` once, then `at` any scale or `update` to the next."""

    def load(self, P: Set, Q: Set) -> None:
        self.P, self.Q = P, Q
        self.last: tuple[Fraction, Set | None] | None = None

    def at(self, scale: str, sP: Set) -> Set | None:
        found = self.sum_at(Fraction(scale), sP)
        self.last = (Fraction(scale), found)
        return found

    def update(self, scale: str, sP: Set) -> Set | None:
        return self.at(scale, sP)

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        return self(sP, self.Q)


class ScalesQ(ScaledSum):
    """The scale is applied to Q instead of P."""

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        return self(self.P, scaled(self.Q, scale))


class ScalesTwice(ScaledSum):
    """The scale is applied to sP again."""

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        return self(scaled(sP, scale), self.Q)


class ScalesTheSum(ScaledSum):
    """s (P + Q) instead of sP + Q."""

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        return self(sP, scaled(self.Q, scale))


class WholeScalesOnly(ScaledSum):
    """The scale is read as a whole number, and 0 taken for none."""

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        return self(scaled(self.P, Fraction(int(scale) or 1)), self.Q)


class IgnoresOneHalf(ScaledSum):
    """The scale 1/2 is divided as whole numbers and comes out as none."""

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        return self(self.P if scale == Fraction(1, 2) else sP, self.Q)


class ScaleAsADouble(ScaledSum):
    """The scale goes through a double."""

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        return self(scaled(self.P, Fraction(float(scale))), self.Q)


class ScalesAboutTheCentre(ScaledSum):
    """P is scaled about the centre of its box."""

    def sum_at(self, scale: Fraction, sP: Set) -> Set | None:
        points = [p for polygon in self.P["polygons"] for p in polygon["outer"]]
        if not points:
            return self(sP, self.Q)
        xs, ys = [Fraction(x) for x, _ in points], [Fraction(y) for _, y in points]
        centre = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
        return self(scaled(self.P, scale, centre), self.Q)


class UpdatesUpwardsOnly(ScaledSum):
    """An update to a smaller scale leaves the sum as it is."""

    def update(self, scale: str, sP: Set) -> Set | None:
        if self.last is not None and Fraction(scale) < self.last[0]:
            return self.last[1]
        return self.at(scale, sP)


class UpdatesLargeStepsOnly(ScaledSum):
    """An update by less than 1e-6 leaves the sum as it is."""

    def update(self, scale: str, sP: Set) -> Set | None:
        if self.last is not None and abs(Fraction(scale) - self.last[0]) < Fraction(1, 10**6):
            return self.last[1]
        return self.at(scale, sP)


class UpdatesLoseBornHoles(ScaledSum):
    """An update never adds holes: those that are born on the way are filled."""

    def update(self, scale: str, sP: Set) -> Set | None:
        before = self.last[1] if self.last is not None else None
        found = self.at(scale, sP)
        if before is None or found is None:
            return found
        most = sum(len(polygon["holes"]) for polygon in before["polygons"])
        for polygon in found["polygons"]:
            polygon["holes"] = polygon["holes"][:most]
            most -= len(polygon["holes"])
        return found


class LoadsOnce(ScaledSum):
    """A second load leaves the Q of the first."""

    def load(self, P: Set, Q: Set) -> None:
        super().load(P, getattr(self, "Q", Q))
