"""The paper's own repair of convex sums in `minkref sweep`: its options."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.cli.readings import Choices, readings_of, with_other
from minkref.errors import Refusal, choice

REPAIRS = ("proven", "literal")
SPACE_CHOICES = Choices(_core.repair_readings(), _core.check_repair_reading)


@dataclass(frozen=True)
class Repair:
    arithmetic: str
    readings: dict[str, str]
    trace: bool

    def fields(self) -> dict[str, Any]:
        return {"repair": "literal", "arithmetic": self.arithmetic, "readings": self.readings}


def asked_repair(
    repair: str | None, arithmetic: str, form: str | None, chosen: Sequence[str] | None, trace: bool
) -> Repair | None:
    """None for the proven update, with which the other options are refused."""
    repair = repair or REPAIRS[0]
    if repair not in REPAIRS:
        raise Refusal(f"there is no repair {repair[:40]!r}", "--repair", choice(repair, REPAIRS))
    check_arithmetic(arithmetic)
    if repair == "literal":
        return Repair(arithmetic, readings_of(form, chosen, SPACE_CHOICES), trace)
    mend = with_other("add --repair literal", form, chosen, SPACE_CHOICES)
    others = {
        f"--arithmetic {arithmetic}": arithmetic != "rational",
        "--form": form is not None,
        "--reading": bool(chosen),
        "--trace": trace,
    }
    for option, given in others.items():
        if given:
            raise Refusal("the proven repair is exact and has no readings", option, mend)
    return None
