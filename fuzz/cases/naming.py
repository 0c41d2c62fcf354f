"""Names of cases, and the cases that they name.

FAMILY:SEED:INDEX         what a generator makes (`minkref families`)
P+Q@SCALE                 files or models
CASE.json[@SCALE]         a case file, at its first scale or the one given
{"P":...,"Q":...,"scale":"3/2"}   the case itself
probe:K(NAME)             at the K-th scale that lies at or next to a boundary event
scaled-up:B(NAME)         both operands 2^B times as large (scaled-down: as small)
cut:N(NAME)               edges cut into equal parts, so that there are N vertices or more
grid:B(NAME)              sP and Q rounded to a grid of B bits, at scale 1
mutant:K(NAME)            something close to the case, drawn by the seed K
LAW(NAME)                 the case changed so that a law tells the sum: swap, quarter-turn, ...
update(NAME)              the case by the verb `update` from another scale
events(NAME)              the scales at which the topology of the sum changes
invalid:SEED:INDEX        operands of which one is invalid
"""

from __future__ import annotations

import json
import random
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import Refusal, cut, refusing
from minkref.exact import read_scale
from minkref.fuzz.cases.case import Case, CaseName
from minkref.fuzz.cases.case_files import case_document, scales_in
from minkref.fuzz.cases.grid import rounded, unit_for
from minkref.fuzz.cases.invalid_case import FAMILY as INVALID
from minkref.fuzz.cases.invalid_case import InvalidCase, load_invalid
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.cases.space_case import LAWS_IN_SPACE, SPACE_FAMILIES, SpaceCase, load_space
from minkref.fuzz.cases.space_case_file import is_in_space, read_space_case
from minkref.fuzz.cases.verbs import EVENTS, UPDATE
from minkref.fuzz.families.catalogue import FAMILIES
from minkref.fuzz.families.mutation import mutate
from minkref.fuzz.families.probes import scale_probes
from minkref.fuzz.verdicts.laws import LAWS
from minkref.model_catalogue import all_models
from minkref.operand import is_file, read_operand

MOST_PROBES = 12
MOST_BITS = 1000
SCALED = {"scaled-up": Fraction(2), "scaled-down": Fraction(1, 2)}
MOST_VERTICES = 2000  # that are asked of a case whose edges are cut
DEEPEST = 64  # operations in a name
_GENERATED = re.compile(r"([a-z0-9-]+):(-?[0-9]+):([0-9]+)")
_DERIVED = re.compile(r"([A-Za-z0-9-]+)(?::([0-9]+))?\((.*)\)", re.DOTALL)


def load(name: CaseName) -> Case | SpaceCase | InvalidCase:
    """The case. Refusal where the text names none; NoCase where a derived one does not exist, as
    a probe of a pair without events."""
    text = name.text
    if text.startswith("{"):
        return _literal(name)
    derived = _DERIVED.fullmatch(text)
    if derived:
        return _derive(name, derived[1], derived[2], derived[3])
    generated = _GENERATED.fullmatch(text)
    if generated and generated[1] == INVALID:
        return load_invalid(name, int(generated[2]), int(generated[3]))
    if generated and generated[1] in SPACE_FAMILIES:
        return load_space(name, generated[1], int(generated[2]), int(generated[3]))
    if generated:
        return _generate(name, generated[1], int(generated[2]), int(generated[3]))
    if text.startswith("random:"):
        raise _no_family(text)
    return _named(name)


def _generate(name: CaseName, family: str, seed: int, index: int) -> Case:
    if family not in FAMILIES:
        raise _no_family(name.text)
    pair = FAMILIES[family].pair(seed, index)
    P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
    return Case(name, P, Q, pair.scale, "P", "Q", family)


def _no_family(text: str) -> Refusal:
    return Refusal(
        "no generated case has this name",
        f"--case {cut(text)}",
        "write FAMILY:SEED:INDEX, for example random:1:42; `minkref families` lists the families",
    )


def _derive(name: CaseName, operation: str, number: str | None, inner: str) -> Case | SpaceCase:
    if name.text.count("(") > DEEPEST:
        raise Refusal(
            f"a case is derived from another in more than {DEEPEST} steps",
            f"--case {cut(name.text)}",
            "write the case itself",
        )
    base = load(CaseName(inner, name.group))
    if isinstance(base, SpaceCase) and operation in LAWS_IN_SPACE and number is None:
        return base.under(operation, name)
    if isinstance(base, SpaceCase) and operation == UPDATE and number is None:
        return base.updated(name)
    if isinstance(base, InvalidCase):
        raise NoCase("nothing is got from an invalid case")
    if isinstance(base, SpaceCase):
        raise NoCase("a case in space has no probes and no mutants, and other laws")
    if operation in LAWS and number is None:
        return replace(LAWS[operation].changed(base), name=name)
    if operation == UPDATE and number is None:
        return replace(base, name=name, scale=_other_scale(base, name), law=(UPDATE, base))
    if operation == EVENTS and number is None:
        return replace(base, name=name, law=(EVENTS, base))
    if operation == "probe" and number is not None:
        probes = scale_probes(base.P_json, base.Q_json, MOST_PROBES)
        if int(number) >= len(probes):
            raise NoCase(f"the pair has {len(probes)} scales to be probed")
        position, scale = probes[int(number)]
        return replace(base, name=name, scale=scale, position=position)
    if operation == "grid" and number is not None:
        return _on_grid(base, name, int(number))
    if operation in SCALED and number is not None and int(number) <= MOST_BITS:
        factor = str(SCALED[operation] ** int(number))
        return replace(base, name=name, P=base.P.scaled(factor), Q=base.Q.scaled(factor))
    if operation == "cut" and number is not None and int(number) <= MOST_VERTICES:
        return _cut(base, name, int(number))
    if operation == "mutant" and number is not None:
        dice = random.Random(f"minkref mutant {name.text}")
        P, Q, scale = mutate(dice, base.P_json, base.Q_json, base.scale)
        return Case(
            name,
            _core.PolygonSet.from_json(P),
            _core.PolygonSet.from_json(Q),
            scale,
            "P",
            "Q",
            base.family,
            "mutant",
        )
    ways = ["probe:K", "mutant:K", "grid:B", "scaled-up:B", "scaled-down:B", "cut:N"]
    known = ", ".join([*ways, UPDATE, EVENTS, *LAWS])
    raise Refusal(
        f"no case is derived from another by {operation[:40]!r}",
        f"--case {cut(name.text)}",
        f"write one of {known}",
    )


def _cut(base: Case, name: CaseName, fewest: int) -> Case:
    """The same sets with vertices along their edges: each edge in the same number of parts, a power
    of two, so that doubles stay doubles."""
    regions = [operand for operand in (base.P, base.Q) if operand.is_region]
    there = sum(operand.vertices for operand in regions)
    if not there:
        raise NoCase("there are no edges to be cut")
    parts = 1
    while parts * there < fewest:
        parts *= 2

    def refined(operand: _core.PolygonSet) -> _core.PolygonSet:
        if not operand.is_region:
            return operand
        value = json.loads(operand.to_json())
        for polygon in value["polygons"]:
            polygon["outer"] = _in_parts(polygon["outer"], parts)
            polygon["holes"] = [_in_parts(hole, parts) for hole in polygon["holes"]]
        return _core.PolygonSet.from_json(json.dumps(value))

    return replace(base, name=name, P=refined(base.P), Q=refined(base.Q))


def _in_parts(ring: list[list[str]], parts: int) -> list[list[str]]:
    points = [[Fraction(number) for number in point] for point in ring]
    made = []
    for (x, y), (u, v) in zip(points, points[1:] + points[:1], strict=True):
        made += [(x + (u - x) * k / parts, y + (v - y) * k / parts) for k in range(parts)]
    return [[str(x), str(y)] for x, y in made]


def _on_grid(base: Case, name: CaseName, bits: int) -> Case:
    """The case with sP and Q rounded to integers of so many bits times a power of two, at scale 1:
    what an implementation on a grid takes as it is."""
    largest = max(map(abs, base.coordinates), default=Fraction(0))
    if not 1 <= bits <= MOST_BITS or not largest:
        raise NoCase("there is nothing to round")
    unit = unit_for(largest, bits)
    operands = []
    for text in (base.scaled_P_json, base.Q_json):
        moved = [
            {
                "outer": _rounded(polygon["outer"], unit),
                "holes": [_rounded(hole, unit) for hole in polygon["holes"]],
            }
            for polygon in json.loads(text)["polygons"]
        ]
        operand = _core.PolygonSet.from_json(json.dumps({"polygons": moved}))
        try:
            operand.validate("rounded")
        except _core.BadInput as error:
            raise NoCase(f"rounded it is no operand: {error}") from error
        operands.append(operand)
    return replace(base, name=name, P=operands[0], Q=operands[1], scale="1")


def _rounded(ring: list[list[str]], unit: Fraction) -> list[list[str]]:
    return [[str(rounded(Fraction(number), unit)) for number in point] for point in ring]


def _other_scale(base: Case, name: CaseName) -> str:
    """At, next to or between the events of the pair."""
    dice = random.Random(f"minkref update {name.text}")
    scales = [scale for _, scale in scale_probes(base.P_json, base.Q_json, MOST_PROBES)]
    others = [scale for scale in scales if scale != base.scale]
    if not others:
        raise NoCase("the pair has no other scale to be reached")
    return dice.choice(others)


def _literal(name: CaseName) -> Case | SpaceCase:
    where = f"--case {cut(name.text)}"
    mend = 'write {"P":{"polygons":[...]},"Q":{"polygons":[...]},"scale":"3/2"}'
    try:
        value: Any = json.loads(name.text, parse_float=str)
        operands = [value["P"], value["Q"]]
        scale = value.get("scale", "1")
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise Refusal(f"this is not a case: {cut(str(error))}", where, mend) from error
    if all(isinstance(each, dict) and "faces" in each for each in operands):
        return SpaceCase.of(name, operands, scale, where)
    P, Q = (_valid(json.dumps(each), where) for each in operands)
    return Case(name, P, Q, read_scale(str(scale), where), "P", "Q", "named")


def _valid(text: str, where: str) -> _core.PolygonSet:
    read: _core.PolygonSet = refusing(where, lambda: _core.read_text(text, "json", where))
    refusing(where, lambda: read.validate(where))
    return read


def _named(name: CaseName) -> Case | SpaceCase:
    operands, at, scale = name.text.rpartition("@")
    if not at:
        operands, scale = name.text, ""
    if operands.endswith(".json") and Path(operands).is_file():
        path = Path(operands)
        value = case_document(path)
        if value is not None:
            if not at:
                scale = scales_in(path, value)[0]
            if is_in_space(value):
                return read_space_case(name, path, scale)
            P, Q = read_operand(f"{operands}#P"), read_operand(f"{operands}#Q")
            return Case(name, P.set, Q.set, read_scale(scale), P.name, Q.name)
        if "+" not in operands:
            read_operand(f"{operands}#P")  # says what is wrong with it
    known = all_models()
    for k in (k for k, letter in enumerate(operands) if letter == "+"):
        first, second = operands[:k], operands[k + 1 :]
        if all(part in known or is_file(part) for part in (first, second)):
            P, Q = read_operand(first), read_operand(second)
            return Case(name, P.set, Q.set, read_scale(scale if at else "1"), P.name, Q.name)
    raise Refusal(
        "this is not the name of a pair of files or models",
        f"--case {cut(name.text)}",
        "write P+Q@SCALE, for example g1+g2@7/5, random:SEED:INDEX, or a case file",
    )
