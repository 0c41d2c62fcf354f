"""A case: two operands and a scale, with a name from which it can be had again."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

from minkref import _core
from minkref.errors import Refusal
from minkref.exact import read_scale
from minkref.fuzz.families.random_pairs import random_pair
from minkref.model_catalogue import all_models
from minkref.operand import is_file, read_operand

_RANDOM = re.compile(r"random:(-?[0-9]+):([0-9]+)")


@dataclass(frozen=True)
class CaseName:
    """`random:SEED:INDEX`, or `P+Q@SCALE` with files or models; cheap to send to a worker."""

    text: str
    group: str

    def load(self) -> Case:
        if self.text.startswith("random:"):
            return _load_random(self)
        return _load_named(self)


@dataclass
class Case:
    name: CaseName
    P: _core.PolygonSet
    Q: _core.PolygonSet
    scale: str
    P_name: str
    Q_name: str

    @cached_property
    def P_json(self) -> str:
        return self.P.to_json()

    @cached_property
    def Q_json(self) -> str:
        return self.Q.to_json()

    @cached_property
    def scaled_P_json(self) -> str:
        return self.P_json if self.scale == "1" else self.P.scaled(self.scale).to_json()

    @property
    def vertex_pairs(self) -> int:
        return self.P.vertices * self.Q.vertices

    @property
    def size(self) -> tuple[int, int, str]:
        """Smaller is easier to read: vertices first, then the length of the numbers."""
        return (
            self.P.vertices + self.Q.vertices,
            len(self.P_json) + len(self.Q_json) + len(self.scale),
            self.name.text,
        )


def _load_random(name: CaseName) -> Case:
    parts = _RANDOM.fullmatch(name.text)
    if parts is None:
        raise Refusal(
            "this names no random pair",
            f"--case {name.text}",
            "write random:SEED:INDEX, for example random:1:42",
        )
    pair = random_pair(int(parts[1]), int(parts[2]))
    P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
    return Case(name, P, Q, pair.scale, "P", "Q")


def _load_named(name: CaseName) -> Case:
    operands, at, scale = name.text.rpartition("@")
    if not at:
        operands, scale = name.text, "1"
    known = all_models()
    for k in (k for k, letter in enumerate(operands) if letter == "+"):
        first, second = operands[:k], operands[k + 1 :]
        if all(part in known or is_file(part) for part in (first, second)):
            P, Q = read_operand(first), read_operand(second)
            return Case(name, P.set, Q.set, read_scale(scale), P.name, Q.name)
    raise Refusal(
        "this names no pair of files or models",
        f"--case {name.text}",
        "write P+Q@SCALE, for example g1+g2@7/5, or random:SEED:INDEX",
    )
