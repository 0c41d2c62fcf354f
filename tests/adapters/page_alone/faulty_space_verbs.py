"""Faulty adapters in space: `update` and invalid input."""

from __future__ import annotations

from fractions import Fraction

from conversation import Answer, Rejected, Request
from space_adapter import Space, UpdatingInSpace, scaling_of
from space_blocks import prism
from space_sets import parts_of, shell_of
from space_sums import sum_in_space
from stale_updates import StaysAtLastSum


class UpdateIsUnitCube(UpdatingInSpace):
    """`update` answers a unit cube."""

    def update(self, request: Request) -> Answer:
        zero, one = Fraction(0), Fraction(1)
        return self.form(
            [prism([(zero, zero), (one, zero), (one, one), (zero, one)], zero, one, 2)]
        )


class UpdateInSpaceStays(StaysAtLastSum, UpdatingInSpace):
    pass


class UpdateScalesTwice(UpdatingInSpace):
    """`update` scales sP once more by the ratio of the third factors."""

    def update(self, request: Request) -> Answer:
        before, now = Fraction(self.scaling[2]), Fraction(scaling_of(request)[2])
        self.scaling = scaling_of(request)
        points, faces = shell_of(request["sP"])
        moved = [(x, y, z * now / before) for x, y, z in points]
        return self.form(sum_in_space((moved, faces), shell_of(self.Q)))


class RejectsHollow(Space):
    """Rejects valid operands with a cavity."""

    def load(self, request: Request) -> Answer:
        for operand in (request["P"], request["Q"]):
            if len(parts_of(shell_of(operand))) > 1:
                raise Rejected("more than one shell")
        return super().load(request)
