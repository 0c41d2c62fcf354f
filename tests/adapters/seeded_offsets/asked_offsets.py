"""Asks implementations for offsets without a process, and judges answers."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.judgement import is_proven as shown
from minkref.fuzz.offsets.judgement import judge_offset
from minkref.fuzz.run import naming
from minkref.fuzz.targets.declaration import Declaration, read_declaration
from minkref.fuzz.verdicts.verdict import Outcome
from seeded_offset import answer, made

FAMILIES = ("offsets-grid", "insets-grid", "line-offsets-grid", "joins-grid")
SHARP = ("sharp-joins-grid",)


@cache
def case(name: str) -> AskedOffset:
    found = naming.load(CaseName(name, "test"))
    assert isinstance(found, AskedOffset)
    return found


def outcomes(name: str, seed: int, count: int) -> Iterator[tuple[AskedOffset, Outcome]]:
    """Judges an implementation on so many cases from each family."""
    target = made(name)
    declared = read_declaration(answer(target, name, {"verb": "hello"}), name)
    families = SHARP if "join-sharp" in declared.capabilities else FAMILIES
    for k in range(count):
        for family in families:
            asked = case(f"{family}:{seed}:{k}")
            if not declared.lacks(asked.needs):
                value = answer(target, name, request(asked, declared))
                read = asked.exchange.received(value, declared, 0.0)
                yield asked, judge_offset(asked, name, read)[0]


def request(asked: AskedOffset, declared: Declaration) -> dict[str, Any]:
    """The request to a target with doubles."""
    P = asked.exchange.sent(asked.asked_json, declared)
    members = asked.manner.members(float)
    return {"verb": "offset", "P": P, "radius": float(asked.radius), **members}


def is_proven(asked: AskedOffset, said: Outcome) -> bool:
    """Whether plain fractions confirm the witness."""
    return said.witness is not None and shown(asked, said.witness)
