"""The paper's own programs; the argument, `mpfr:53` or `rational,corrected`, is a target's name
without its prefix (`program_name.py`).

Operands come as exact numbers; the program takes the nearest numbers of its arithmetic, and scales
P by itself. It gives up undecided signs and refused operands.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from typing import Any

from adapter_protocol import GaveUp, Set, serve  # type: ignore[import-not-found,unused-ignore]
from minkref import _core
from minkref.fuzz.libraries.paper.in_plane import PlaneProgram
from minkref.fuzz.libraries.paper.in_space import SpaceProgram
from minkref.fuzz.libraries.paper.program_name import PREFIX, ProgramName, read_name
from minkref.fuzz.libraries.paper.with_disc import grown
from minkref.version import version

Fields = dict[str, Any]
IN_PLANE = "plane non-convex holes components touching empty point segment rational"
WALKED = "update pair-events space non-uniform offset"
REFUSALS = (_core.UndecidedSign, _core.BadInput, _core.LimitExceeded)


class Programs:
    """Answers each verb in the operands' setting."""

    def __init__(self, name: ProgramName) -> None:
        self._plane, self._space = PlaneProgram(name), SpaceProgram(name)
        self._name = name

    def at(self, P: Set, Q: Set, request: Fields) -> Fields:
        if "faces" in P:
            return guarded(lambda: self._space.at(P, Q, request["scale"]))
        return guarded(lambda: self._plane.at(json.dumps(P), json.dumps(Q), request["scale"]))

    def update(self, P: Set, Q: Set, request: Fields) -> Fields:
        program = self._space if "faces" in P else self._plane
        return guarded(lambda: program.update(request["scale"]))

    def pair_events(self, P: Set, Q: Set, request: Fields) -> Fields:
        texts = json.dumps(P), json.dumps(Q)
        return guarded(lambda: self._plane.pair_events(*texts, request["from"], request["to"]))

    def offset(self, P: Set, radius: str) -> Fields:
        name = self._name
        return guarded(lambda: grown(json.dumps(P), radius, name.arithmetic, name.disc))


def guarded(work: Callable[[], Fields]) -> Fields:
    """Turns refusals and undecided signs into GaveUp."""
    try:
        return work()
    except REFUSALS as error:
        raise GaveUp(getattr(error, "problem", "") or str(error)) from error


def declaration(name: ProgramName) -> Fields:
    able = IN_PLANE if name.is_static else f"{IN_PLANE} {WALKED}"
    fields = {
        "name": f"{PREFIX}@{name.argument}",
        "version": version(),
        "language": "C++",
        "arithmetic": "exact" if name.is_exact else f"{name.arithmetic}, the paper's formulas",
        "numbers": "text",
        "sum": "region",
        "sets": "regularised",
        "capabilities": able.split(),
    }
    if name.is_exact:
        return fields
    relative = "0" if name.digits is None else f"1e-{name.digits}"
    return {**fields, "tolerance": {"relative": relative}}


def main(argument: str) -> None:
    name = read_name(f"{PREFIX}@{argument}")
    programs = Programs(name)
    verbs = {"at": programs.at, "update": programs.update, "pair-events": programs.pair_events}
    offset_of = None if name.is_static else programs.offset
    serve(declaration(name), None, verbs=verbs, offset_of=offset_of)


if __name__ == "__main__":
    main(sys.argv[1])
