"""The paper's own program in `minkref view`: its options."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from minkref.arithmetic import check_arithmetic
from minkref.cli.readings import ROUTE, readings_of, refuse_options
from minkref.errors import Refusal

STEPS, MOST_STEPS = 61, 1000
EXACT = "rational"


@dataclass(frozen=True)
class Program:
    arithmetic: str
    readings: dict[str, str]
    steps: int  # scales of the slider that it goes through

    def fields(self) -> dict[str, Any]:
        return {"arithmetic": self.arithmetic, "readings": self.readings}


def asked_program(
    route: str, arithmetic: str | None, form: str | None, chosen: Sequence[str] | None,
    steps: int | None,
) -> Program | None:  # fmt: skip
    """None for other routes; refuses the paper's options with them."""
    refuse_options(route, form, chosen)
    check_arithmetic(arithmetic or EXACT)
    if route != ROUTE:
        for option, given in (("--arithmetic", arithmetic), ("--steps", steps)):
            if given is not None:
                mend = f"add --route {ROUTE}, or leave it out"
                raise Refusal(f"the route {route} is exact, at all scales", option, mend)
        return None
    steps = STEPS if steps is None else steps
    if not 2 <= steps <= MOST_STEPS:
        what = f"there must be 2 to {MOST_STEPS:,} scales"
        raise Refusal(what, f"--steps {steps}", "choose another N")
    return Program(arithmetic or EXACT, readings_of(form, chosen), steps)


def told(run: dict[str, Any] | None) -> dict[str, Any]:
    """The fields of the run in the document of the command; nulls without a run."""
    if run is None:
        names = ("readings", "steps", "wrong_steps", "first_wrong", "events")
        return {"arithmetic": EXACT, **dict.fromkeys(names)}
    wrong = [step["scale"] for step in run["steps"] if not step["right"]]
    return {
        "arithmetic": run["arithmetic"],
        "readings": run["readings"],
        "steps": len(run["steps"]),
        "wrong_steps": len(wrong),
        "first_wrong": wrong[0] if wrong else None,
        "events": run["events"],
    }
