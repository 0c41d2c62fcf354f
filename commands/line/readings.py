"""How the formulas of the paper are read: the options of the commands that follow it literally."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Annotated

import typer
from minkref import _core
from minkref.errors import Refusal, choice, refusing

ROUTE = "paper-update"
FORMS = ("printed", "corrected")


@dataclass(frozen=True)
class Choices:
    """How a section of the paper may be read. `rows`: name, values (the printed one first), the
    corrected one, section. `check` refuses a value that is none."""

    rows: list[tuple[str, list[str], str, str]]
    check: Callable[[str, str], None]

    def names(self) -> str:
        return ", ".join(f"{name} ({'|'.join(values)})" for name, values, *_ in self.rows)


PLANE_CHOICES = Choices(_core.paper_readings(), _core.check_paper_reading)

Form = Annotated[
    str | None,
    typer.Option(
        "--form",
        help=f"With --route {ROUTE}: all formulas as printed (the default) or corrected.",
        metavar="|".join(FORMS),
    ),
]
Reading = Annotated[
    list[str] | None,
    typer.Option(
        "--reading",
        help=f"With --route {ROUTE}: one formula or sentence of the paper as read, whatever --form "
        f"says; may be repeated. {PLANE_CHOICES.names()}.",
        metavar="NAME=VALUE",
    ),
]


def readings_of(
    form: str | None, chosen: Sequence[str] | None, choices: Choices = PLANE_CHOICES
) -> dict[str, str]:
    """By name, all of them. The last of a name counts."""
    form = form or FORMS[0]
    if form not in FORMS:
        raise Refusal(f"there is no form {form!r}", "--form", choice(form, FORMS))
    readings = {
        name: values[0] if form == "printed" else corrected
        for name, values, corrected, _ in choices.rows
    }
    for text in chosen or ():
        name, equals, value = text.partition("=")
        where = f"--reading {text[:60]}"
        if not equals or name not in readings:
            raise Refusal(
                f"there is no reading {name[:40]!r}", where, choice(name, tuple(readings))
            )
        refusing(where, partial(choices.check, name, value))
        readings[name] = value
    return readings


def refuse_options(route: str, form: str | None, chosen: Sequence[str] | None) -> None:
    """Refuses the options of the route with any other."""
    if route == ROUTE:
        return
    for option, given in (("--form", form), ("--reading", chosen)):
        if given:
            raise Refusal(
                f"the route {route} has no readings",
                option,
                f"add --route {ROUTE}, or leave it out",
            )
