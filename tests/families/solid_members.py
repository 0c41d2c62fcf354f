"""The members that tests look at, from the families of general polyhedra."""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cache
from typing import Any

from minkref.degeneracies.catalogue import SOLID_FAMILIES
from minkref.degeneracies.lint import CORPUS, case_paths
from minkref.degeneracies.solids.case_document import DegenerateSolids
from minkref.fuzz.geometry.polyhedron import Polyhedron
from thoroughness import THOROUGH

SEED = 911
COUNT = 2


@cache
def documents(name: str) -> list[Any]:
    """Case documents read from files: one of the corpus if few are drawn."""
    if not THOROUGH:
        return [json.loads(case_paths(CORPUS / name)[0].read_text(encoding="utf-8"))]
    print(f"{name} --seed {SEED}")
    made = [DegenerateSolids.of(SOLID_FAMILIES[name], SEED, k) for k in range(COUNT)]
    return [json.loads(each.case_text) for each in made]


def operands(value: Any) -> tuple[Polyhedron, Polyhedron]:
    return Polyhedron.from_document(value["P"]), Polyhedron.from_document(value["Q"])


def scales(value: Any) -> list[Fraction]:
    assert all(len(set(scale)) == 1 for scale in value["scales"])
    return [Fraction(scale[0]) for scale in value["scales"]]
