"""Case names, and the cases behind them.

FAMILY:SEED:INDEX         what a generator makes (`minkref families`)
P+Q@SCALE                 files or models
CASE.json[@SCALE]         a case file, at its first scale or the one given
{"P":...,"Q":...,"scale":"3/2"}   the case itself
probe:K(NAME)             at the K-th scale that lies at or next to a boundary event
axes:K(NAME)              with a factor for each axis, drawn by the number K
scaled-up:B(NAME)         both operands 2^B times as large (scaled-down: as small)
cut:N(NAME)               edges cut into equal parts, so that there are N vertices or more
grid:B(NAME)              sP and Q rounded to a grid of B bits, at scale 1
mutant:K(NAME)            something close to the case, drawn by the seed K
LAW(NAME)                 the case changed so that a law tells the sum: swap, quarter-turn, ...
update(NAME)              the case by the verb `update` from another scale
events(NAME)              the scales at which the topology of the sum changes
pair-events(NAME)         the scales at which two edges of the convolution begin or cease to meet
invalid:SEED:INDEX        operands of which one is invalid
path:SEED:INDEX           a part on a path, at given scales (path-grid: on a grid of doubles)
path-ranges:SEED:INDEX    the same, all valid scales of a window (path-ranges-grid: on a grid)
union:SEED:INDEX          sets to unite (union-grid: on a grid of 24 bits; union-known: known)
{"sets":[...]}            such sets themselves
offsets:SEED:INDEX        a set to grow by a disc (offsets-grid: on a grid; offsets-known: known)
insets:SEED:INDEX         a set to erode by a disc (insets-grid: on a grid)
line-offsets:SEED:INDEX   open lines to grow (line-offsets-grid: on a grid)
joins:SEED:INDEX          sets and lines to grow with other joins and caps (joins-grid: on a grid)
sharp-joins:SEED:INDEX    sets to grow or erode with sharp corners (sharp-joins-grid: on a grid)
{"offset":{...},"radius":"7/5"}   such a set itself
features:SEED:INDEX       concave features of a set, bridges at a radius (features-grid: on a grid)
{"features":{...},"radius":"7/5"}   such a set itself
{"part":...,"obstacles":...,"path":...,"contact":...,"scales":[...]}   such a case itself
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, cut
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.derived import WAYS
from minkref.fuzz.plane.laws import LAWS
from minkref.fuzz.run.case_files import case_document, scales_in
from minkref.fuzz.setting import Question, Setting
from minkref.fuzz.settings import (
    QUESTIONS,
    SETTINGS,
    setting_of,
    setting_of_document,
    setting_of_operands,
)
from minkref.model_catalogue import all_models
from minkref.plane.operand import is_file, read_operand
from minkref.plane.scaling import read_plane_scale, text_of

DEEPEST = 64  # operations in a name
_GENERATED = re.compile(r"([a-z0-9-]+):(-?[0-9]+):([0-9]+)")
_DERIVED = re.compile(r"([A-Za-z0-9-]+)(?::([0-9]+))?\((.*)\)", re.DOTALL)


def load(name: CaseName) -> AnyCase:
    """Returns the case. Refusal if the text names none; NoCase if a derived case does not exist, as
    for a probe on a pair without events."""
    text = name.text
    if text.startswith("{"):
        return _literal(name)
    derived = _DERIVED.fullmatch(text)
    if derived:
        return _derive(name, derived[1], derived[2], derived[3])
    generated = _GENERATED.fullmatch(text)
    if generated:
        family, seed, index = generated[1], int(generated[2]), int(generated[3])
        draws: tuple[Setting | Question, ...] = (*SETTINGS, *QUESTIONS)
        drawn = (each.drawn(name, family, seed, index) for each in draws)
        found = next((case for case in drawn if case is not None), None)
        if found is not None:
            return found
    if generated or text.startswith("random:"):
        raise _no_family(text)
    return _named(name)


def load_in_plane(name: CaseName) -> Case:
    """Returns the case in the plane. Refusal if the text names none."""
    case = load(name)
    if not isinstance(case, Case):
        raise Refusal("this case is in space", f"--case {name.text}", "name one in the plane")
    return case


def _no_family(text: str) -> Refusal:
    return Refusal(
        "no generated case has this name",
        f"--case {cut(text)}",
        "write FAMILY:SEED:INDEX, for example random:1:42; `minkref families` lists the families",
    )


def _derive(name: CaseName, operation: str, number: str | None, inner: str) -> AnyCase:
    if name.text.count("(") > DEEPEST:
        raise Refusal(
            f"a case is derived from another in more than {DEEPEST} steps",
            f"--case {cut(name.text)}",
            "write the case itself",
        )
    base = load(CaseName(inner, name.group))
    setting = setting_of(base.dimension)
    case = setting.derived(base, name, operation, None if number is None else int(number))
    if case is None:
        raise Refusal(
            f"no case is derived from another by {operation[:40]!r}",
            f"--case {cut(name.text)}",
            f"write one of {', '.join([*WAYS, *LAWS])}",
        )
    return case


def _literal(name: CaseName) -> AnyCase:
    where = f"--case {cut(name.text)}"
    mend = 'write {"P":{"polygons":[...]},"Q":{"polygons":[...]},"scale":"3/2"}'
    try:
        value: Any = json.loads(name.text, parse_float=str)
        for question in QUESTIONS:
            if (asked := question.named(name, value, where)) is not None:
                return asked
        operands = [value["P"], value["Q"]]
        scale = value.get("scale", "1")
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise Refusal(f"this is not a case: {cut(str(error))}", where, mend) from error
    return setting_of_operands(operands).case_of(name, operands, scale, where)


def _named(name: CaseName) -> AnyCase:
    operands, at, scale = name.text.rpartition("@")
    if not at:
        operands, scale = name.text, ""
    if operands.endswith(".json") and Path(operands).is_file():
        path = Path(operands)
        value = case_document(path)
        if value is not None:
            setting = setting_of_document(value)
            return setting.case_in(name, path, scale if at else scales_in(path, value)[0])
        if "+" not in operands:
            read_operand(f"{operands}#P")  # refuses it with the reason
    known = all_models()
    for k in (k for k, letter in enumerate(operands) if letter == "+"):
        first, second = operands[:k], operands[k + 1 :]
        if all(part in known or is_file(part) for part in (first, second)):
            P, Q = read_operand(first), read_operand(second)
            s = text_of(read_plane_scale(scale if at else "1"))
            return Case(name, P.set, Q.set, s, P.name, Q.name)
    raise Refusal(
        "this is not the name of a pair of files or models",
        f"--case {cut(name.text)}",
        "write P+Q@SCALE, for example g1+g2@7/5, random:SEED:INDEX, or a case file",
    )
