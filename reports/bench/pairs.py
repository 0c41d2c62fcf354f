"""The pairs from Behar & Lien 2012, Table 1, or look-alikes."""

from __future__ import annotations

from dataclasses import dataclass

from minkref.model_catalogue import VARIABLE, all_models, or_look_alike
from minkref.plane.operand import Operand, read_operand

#: 30, 34, 24, 43 and 145 vertices, as the paper's five small polygons have.
SMALL = ("g1", "g2", "g3", "g4", "dog145")
LARGE = (("disc1", "neuron"), ("monkey", "bird"))
QUICK_LARGE = LARGE[:1]


@dataclass(frozen=True)
class Pair:
    P: Operand
    Q: Operand
    small: bool  # one of the 25

    @property
    def name(self) -> str:
        return f"{self.P.name} + {self.Q.name}"


def pairs(quick: bool) -> tuple[list[Pair], list[str]]:
    """The pairs, and notes about models that look-alikes stand for."""
    models = all_models()
    notes = []
    large = []
    for first, second in QUICK_LARGE if quick else LARGE:
        operands = []
        for name in (first, second):
            alike = or_look_alike(name, models)
            if alike != name:
                notes.append(f"{VARIABLE} does not provide {name}: our {alike} stands for it")
            operands.append(read_operand(alike))
        large.append(Pair(operands[0], operands[1], small=False))
    small = [read_operand(name) for name in SMALL]
    return [Pair(P, Q, small=True) for P in small for Q in small] + large, notes
