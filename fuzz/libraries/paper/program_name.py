"""Names of the paper's own programs: arithmetic, form, and the reading of each formula.

minkref-paper@ARITHMETIC            all formulas as printed: the update, walked from another scale
minkref-paper@ARITHMETIC,corrected  all formulas corrected
minkref-paper@ARITHMETIC,static     the program of Section 3, from scratch; it has no readings
...,NAME=VALUE                      one formula or sentence as read, as --reading spells it
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.errors import Refusal, nearest, refusal_of

PREFIX = "minkref-paper"
PRINTED, CORRECTED, STATIC = FORMS = ("printed", "corrected", "static")
EXACT = "rational"
DIGITS_OF_DOUBLES = 9  # right decimal digits of a sum, for 53 bits
MOST_DIGITS = 9999  # of a tolerance in a declaration


@dataclass(frozen=True)
class _Choices:
    """A section's readings: name, values (the printed one first), the corrected one, section."""

    rows: list[tuple[str, list[str], str, str]]
    check: Callable[[str, str], None]

    def all_of(self, form: str) -> dict[str, str]:
        printed = form != CORRECTED
        return {name: values[0] if printed else right for name, values, right, _ in self.rows}


IN_PLANE = _Choices(_core.paper_readings(), _core.check_paper_reading)
IN_SPACE = _Choices(_core.space_update_readings(), _core.check_space_update_reading)
OF_REPAIR = _Choices(_core.repair_readings(), _core.check_repair_reading)
WITH_DISC = _Choices(_core.appendix_readings(), _core.check_appendix_reading)
_ALL = {"readings": IN_PLANE, "facets": IN_SPACE, "repair": OF_REPAIR, "disc": WITH_DISC}


@dataclass(frozen=True)
class ProgramName:
    """A name, read. `argument`: the name without its prefix."""

    argument: str
    arithmetic: str
    form: str
    readings: dict[str, str]  # in the plane, Section 4
    facets: dict[str, str]  # in space, Section 5
    repair: dict[str, str]  # in space of convex bodies, Section 6
    disc: dict[str, str]  # with a disc, the Appendix

    @property
    def is_static(self) -> bool:
        return self.form == STATIC

    @property
    def is_exact(self) -> bool:
        """Whether it claims the exact sum: exact numbers, all readings corrected."""
        right = all(getattr(self, name) == each.all_of(CORRECTED) for name, each in _ALL.items())
        return self.arithmetic == EXACT and (self.is_static or right)

    @property
    def bits(self) -> int | None:
        """Significant bits; None for exact numbers."""
        if self.arithmetic.startswith("mpfr:"):
            return int(self.arithmetic.removeprefix("mpfr:"))
        return None if self.arithmetic == EXACT else 53

    @property
    def digits(self) -> int | None:
        """How many decimal digits of a sum have to be right; None for all."""
        if self.bits is None:
            return None
        return min(MOST_DIGITS, max(1, DIGITS_OF_DOUBLES * self.bits // 53))

    @property
    def relative(self) -> Fraction:
        """The relative tolerance: 1e-9 for 53 bits, like other targets with doubles, in proportion
        for other bits. 0 for exact numbers, with any formulas."""
        return Fraction(0) if self.digits is None else Fraction(1, 10**self.digits)

    @property
    def title(self) -> str:
        """A few words on it."""
        _, _, rest = self.argument.partition(",")
        return f"{rest or PRINTED}, in {self.arithmetic}"


def read_name(name: str) -> ProgramName:
    """Reads a target's name. Refuses an unknown arithmetic, word or reading with all choices."""
    prefix, at, argument = name.partition("@")
    arithmetic, *words = argument.split(",")
    if prefix != PREFIX or not at:
        what = "the name of the paper's program has no arithmetic"
        raise Refusal(what, name[:60], f"write {PREFIX}@double, or {_spelling()}")
    check_arithmetic(arithmetic, name[:60])
    form = _form([word for word in words if "=" not in word], name)
    chosen = {section: choices.all_of(form) for section, choices in _ALL.items()}
    for word in (word for word in words if "=" in word):
        if form == STATIC:
            what = "the static program has no readings"
            raise Refusal(what, name[:60], f"leave out {word[:40]} or {STATIC}")
        _set(chosen, word, name)
    return ProgramName(argument, arithmetic, form, **chosen)


def _form(words: list[str], name: str) -> str:
    """Defaults to `printed`."""
    unknown = [word for word in words if word not in FORMS]
    if unknown:
        what = f"the paper's program has no form {unknown[0][:40]!r}"
        raise Refusal(what, name[:60], f"{nearest(unknown[0], _every_word())}write {_spelling()}")
    if len(words) > 1:
        what = f"the name has two forms, {words[0]} and {words[1]}"
        raise Refusal(what, name[:60], "leave out one of the two")
    return words[0] if words else PRINTED


def _set(chosen: dict[str, dict[str, str]], word: str, name: str) -> None:
    """Sets a reading in each section that has it with this value."""
    reading, _, value = word.partition("=")
    sections = [section for section, readings in chosen.items() if reading in readings]
    if not sections:
        what = f"there is no reading {word[:40]!r}"
        raise Refusal(what, name[:60], f"{nearest(word, _every_word())}write {_spelling()}")
    refused = []
    for section in sections:
        try:
            _ALL[section].check(reading, value)
        except _core.BadInput as error:
            refused.append(error)
        else:
            chosen[section][reading] = value
    if len(refused) == len(sections):
        rows = [row for section in sections for row in _ALL[section].rows if row[0] == reading]
        every = dict.fromkeys(value for _, values, *_ in rows for value in values)
        mend = f"{nearest(word, _every_word())}write {reading}={'|'.join(every)}"
        raise Refusal(refusal_of(refused[0]).what, name[:60], mend) from refused[0]


def _every_word() -> list[str]:
    return [*FORMS, *(f"{name}={value}" for name, values in _values().items() for value in values)]


def _spelling() -> str:
    """How a name is made, with all choices."""
    readings = ", ".join(f"{name}={'|'.join(values)}" for name, values in _values().items())
    return (
        f"{PREFIX}@ARITHMETIC[,{'|'.join(FORMS)}][,NAME=VALUE...] with rational, interval, double "
        f"or mpfr:BITS, and the readings {readings}"
    )


def _values() -> dict[str, list[str]]:
    """Each reading with the values of all sections that have it."""
    found: dict[str, list[str]] = {}
    for choices in _ALL.values():
        for name, values, *_ in choices.rows:
            known = found.setdefault(name, [])
            known += [value for value in values if value not in known]
    return found
