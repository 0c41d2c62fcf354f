"""A program with one call to one library that exits with 1 if the fault shows."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from importlib import resources
from string import Template

from minkref.fuzz.libraries.grid import Ring, polygons_of
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.verdicts.verdict import Outcome


@dataclass(frozen=True)
class Program:
    """`run` holds shell lines that build and start the program; `note` tells readers about its
    behaviour, or is empty."""

    file: str
    text: str
    run: str
    note: str = ""


def filled(template: str, finding: Finding, name: str, **fields: str) -> str:
    """Fills a library's template, `clipper2/curves`, say: the given fields, the observed outcome,
    and the program's name."""
    folder = resources.files("minkref.fuzz.libraries")
    text = (folder / f"{template}.template").read_text(encoding="utf-8")
    return Template(text).substitute(fields, OBSERVED=observed(finding.outcome), NAME=name)


def observed(outcome: Outcome) -> str:
    """The observed outcome, on one line, safe within any language's comments."""
    signal = f", {outcome.signal}" if outcome.signal else ""
    text = f"{outcome.target} {outcome.was or outcome.verdict}: {', '.join(outcome.kinds)}{signal}"
    return re.sub(r"[^\w .,:@+-]", " ", text)


def united_sets(finding: Finding) -> list[list[list[Ring]]] | None:
    """For each set its polygons, each a list of rings; None if the finding is no union."""
    if finding.case.union is None:
        return None
    return [polygons_of(json.dumps(each)) for each in json.loads(finding.case.union)["sets"]]


def scaled_operands(finding: Finding, dimension: int | None = None) -> tuple[str, str] | None:
    """P scaled, and Q, as JSON texts; None if the finding has no two operands, or another dimension
    than the given one."""
    from minkref import _core
    from minkref.fuzz.geometry.polyhedron import Polyhedron
    from minkref.fuzz.geometry.space import scale_of

    case = finding.case
    if case.P is None or case.Q is None or dimension not in (None, case.dimension):
        return None
    if case.dimension == 3:
        return Polyhedron.from_json(case.P).scaled(scale_of(case.scale)).to_json(), case.Q
    return _core.PolygonSet.from_json(case.P).scaled(case.scale).to_json(), case.Q
