"""How to read the paper's formulas: options for commands following the paper literally."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated

import typer
from minkref import _core
from minkref.errors import Refusal, choice, nearest, refusal_of

ROUTE = "paper-update"
FORMS = ("printed", "corrected")


@dataclass(frozen=True)
class Choices:
    """How a section of the paper may be read. `rows`: name, values (the printed one first), the
    corrected one, section. `check` refuses an unknown value."""

    rows: list[tuple[str, list[str], str, str]]
    check: Callable[[str, str], None]

    def names(self) -> str:
        """Lists all, as written: `solve=printed|corrected, ...`."""
        return ", ".join(self.values(name) for name, *_ in self.rows)

    def values(self, name: str) -> str:
        """The values that may be written for one name: `solve=printed|corrected`."""
        return f"{name}={'|'.join(self.values_of(name))}"

    def values_of(self, name: str) -> list[str]:
        return next(values for each, values, *_ in self.rows if each == name)


PLANE_CHOICES = Choices(_core.paper_readings(), _core.check_paper_reading)
FACET_CHOICES = Choices(_core.facet_readings(), _core.check_facet_reading)
DISC_CHOICES = Choices(_core.appendix_readings(), _core.check_appendix_reading)
# Sentences of the Appendix on which exact events depend (docs/disc.md, "Pair events").
SENTENCES = ("rejected", "number", "radical", "line", "parallel")
DISC_EVENT_CHOICES = Choices(
    [row for row in DISC_CHOICES.rows if row[0] in SENTENCES], DISC_CHOICES.check
)
SPACE_CHOICES = Choices(_core.space_update_readings(), _core.check_space_update_reading)

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
        f"says; may be repeated. {PLANE_CHOICES.names()}. With a disc: {DISC_CHOICES.names()}. In "
        f"space: {SPACE_CHOICES.names()}.",
        metavar="NAME=VALUE",
    ),
]


def readings_of(
    form: str | None, chosen: Sequence[str] | None, choices: Choices = PLANE_CHOICES
) -> dict[str, str]:
    """Maps every name to its reading; the last one chosen counts."""
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
        if name not in readings:
            what = f"there is no reading {name[:40]!r}"
            every = (f"{each}={v}" for each in readings for v in choices.values_of(each))
            raise Refusal(what, where, f"{nearest(text, every)}write {choices.names()}")
        if not equals:
            what = f"the reading {name!r} has no value"
            raise Refusal(what, where, f"write {choices.values(name)}")
        try:
            choices.check(name, value)
        except _core.BadInput as error:
            near = nearest(text, (f"{name}={each}" for each in choices.values_of(name)))
            mend = f"{near}write {choices.values(name)}"
            raise Refusal(refusal_of(error).what, where, mend) from error
        readings[name] = value
    return readings


def refuse_options(
    route: str, form: str | None, chosen: Sequence[str] | None, choices: Choices = PLANE_CHOICES
) -> None:
    """Refuses the options of the route with any other."""
    if route == ROUTE:
        return
    mend = with_other(f"add --route {ROUTE}", form, chosen, choices)
    for option, given in (("--form", form), ("--reading", chosen)):
        if given:
            raise Refusal(f"the route {route} has no readings", option, mend)


def with_other(other: str, form: str | None, chosen: Sequence[str] | None, choices: Choices) -> str:
    """How to mend readings valid with another option only, if it takes these."""
    try:
        readings_of(form, chosen, choices)
    except Refusal:
        return "leave it out"
    return f"{other}, or leave it out"
