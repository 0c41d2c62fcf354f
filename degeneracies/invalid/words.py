"""Texts that do not keep to their format, end too early, or go on after their end."""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random

from minkref.degeneracies.invalid.json_text import MARK
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import region
from minkref.degeneracies.invalid.sheet import Sheet, sheet
from minkref.degeneracies.invalid.writing import refused, text_of

FAMILIES = Families()

Change = tuple[str, str]  # a pattern, and the replacement for a match

# The mark precedes the text that no reader understands.
OF_WKT: tuple[Change, ...] = (
    (r"\((?=-?[0-9])", MARK),  # a parenthesis less
    (r",", f",{MARK},"),
    (r"\)", f",{MARK})"),
    (r" -?[0-9][^ ,()]*(?=[,)])", MARK),  # a coordinate less
    (r"\((?=-?[0-9])", f"({MARK}("),
    (r"^", f"{MARK}("),
    (r"^", f"{MARK}<?xml?>"),
    (r"(?<=N) ", f"{MARK}["),
)
OF_JSON: tuple[Change, ...] = (
    (r",", f"{MARK};"),
    (r":", f"{MARK} ="),
    (r"\[(?=[^\]])", f"{MARK}("),
    (r"(?<=[^\[\s])(\s*)\]", f",\\1{MARK}]"),
    (r"^\{", f"{MARK}:"),
    (r'\{(?=\s*")', f"{{{MARK}x"),
    (r"(?<=\[)(?=[^\[\]])", f"{MARK}+"),
    (r"(?<=\[)(?=[^\[\]])", f"{MARK}// no comment\n"),
    (r'"(outer|type|schema)"', f"{MARK}'\\1'"),
    (r'"(outer|type|schema)"', f'{MARK}"\\1\\\\q"'),
    (r'"(outer|type|schema)"', f'{MARK}"\\1\\\\ud800"'),
    (r'"(outer|type|schema)"', f'{MARK}"\\1\t"'),
)
OF_POLY: tuple[Change, ...] = (
    (r"(out|in)(?=\n)", f"{MARK}\\1er"),
    (r"(?<=\n)([0-9]+) (out|in)(?=\n)", f"{MARK}\\2 \\1"),
    (r"(?<=\n)([0-9]+) (out|in)(?=\n)", f"{MARK}\\1.0 \\2"),
    (r"(?<=\n)([0-9]+) (out|in)(?=\n)", f"{MARK}-\\1 \\2"),
    (r"^([0-9]+)(?=\n)", f"{MARK}\\1 rings"),
    (r"^([0-9]+)(?=\n)", f"{MARK}\\1.5"),
    (r"(?<=t\n)([^ \n]+) [^ \n]+(?=\n)", f"{MARK}\\1"),  # a coordinate less
    (r"(?<=\n)1 2 3 4(?=\n| )", f"{MARK}1 2 4 3"),
    (r"(?<=\n)1 2 3", f"{MARK}0 1 2"),
)
AFTER: dict[str, tuple[str, ...]] = {
    "wkt": ("POINT (0 0)", ")", ";", "POLYGON EMPTY", "0", "EMPTY", "# end", ", POINT (1 1)"),
    "json": ("{}", "]", "}", ",", "0", "null", '"end"', "// end", '{"polygons": []}'),
    "poly": ("3 out\n0 0\n1 0\n0 1", "0", "end", "3 in", "1 2"),
}


def kind(page: Sheet) -> str:
    return page.form if page.form in ("wkt", "poly") else "json"


def drawn(dice: Random) -> tuple[Sheet, str]:
    page = sheet(dice, region(dice))
    return page, text_of(dice, page).strip() + "\n"


@FAMILIES.add("a text that does not keep to its format")
def syntax(dice: Random) -> Invalid:
    """Changes one or two letters, once."""
    while True:
        page, text = drawn(dice)
        changes = {"wkt": OF_WKT, "json": OF_JSON, "poly": OF_POLY}[kind(page)]
        pattern, to = dice.choice(changes)
        places = list(re.finditer(pattern, text))
        if places:
            found = dice.choice(places)
            text = text[: found.start()] + found.expand(to) + text[found.end() :]
            return refused(dice, page, "syntax", text=text)


@FAMILIES.add("a file whose end is missing")
def truncated(dice: Random) -> Invalid:
    """Cut behind a token; in .poly behind a line."""
    page, text = drawn(dice)
    text = text.rstrip()
    cut: Callable[[str], list[int]] = {"wkt": _in_wkt, "json": _in_json, "poly": _in_poly}[
        kind(page)
    ]
    at = dice.choice(cut(text))
    return refused(dice, page, "truncated", text=text[:at] + MARK)


def _in_wkt(text: str) -> list[int]:
    return [found.end() for found in re.finditer(r"[(),]|[^\s(),]+(?=[\s(),])", text)
            if "(" in text[: found.end()] and found.end() < len(text)]  # fmt: skip


def _in_json(text: str) -> list[int]:
    """Places behind any letter that leaves no number half written."""
    return [at for at in range(1, len(text)) if text[at - 1] not in "-+.eE\n "]


def _in_poly(text: str) -> list[int]:
    """Ends of lines that hold a vertex or a vertex count."""
    lines = text.split("\n")
    ends, at = [], 0
    due = 0
    for line in lines[:-1]:
        at += len(line) + 1
        words = line.split()
        if words[-1] in ("in", "out"):
            due = int(words[0])
        elif due:
            due -= 1
        if words[-1] in ("in", "out") or due:
            ends.append(at - 1)
    return ends


@FAMILIES.add("more after the end of the operand")
def trailing_text(dice: Random) -> Invalid:
    page, text = drawn(dice)
    more = dice.choice(AFTER[kind(page)])
    if page.form == "poly":
        if not re.search(r"\n1 2 3[0-9 ]*\n$", text) and not more.endswith("in"):
            more = AFTER["poly"][0]  # any other text after a ring would be its indices
        return refused(dice, page, "trailing-text", text=f"{text}{MARK}{more}\n")
    return refused(dice, page, "trailing-text", text=text + dice.choice(("", "\n\n")) + MARK + more)
