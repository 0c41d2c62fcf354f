"""Random cases and cases of the corpus, in the plane and in space."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count, islice
from pathlib import Path

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.setting import PLANE
from minkref.fuzz.run.case_files import case_files
from minkref.fuzz.run.naming import load
from minkref.fuzz.space.setting import SPACE
from minkref.reports.evidence.framework.places import ROOT

SEED = 77
PROBES = (None, 0, 2, 4)  # the drawn scale, and scales at and next to events
CONVEX = ("space-convex", "space-sphere")


def plane_cases(number: int) -> list[str]:
    """Half of them drawn, of each family in turn, and half from the corpus, evenly."""
    return [
        *islice(filter(exists, _drawn()), number // 2),
        *_of_corpus(number - number // 2, PLANE),
    ]


def space_cases(number: int) -> list[str]:
    """The same for convex polyhedra; the corpus has others, too."""
    drawn = (f"{family}:{SEED}:{index}" for index in count() for family in CONVEX)
    return [*islice(drawn, number // 2), *_of_corpus(number - number // 2, SPACE)]


def exists(name: str) -> bool:
    """False for a probe of a pair that has fewer scales to be probed."""
    try:
        load(CaseName(name, "evidence"))
    except NoCase:
        return False
    return True


def _drawn() -> Iterator[str]:
    for index in count():
        for number, family in enumerate(FAMILIES):
            probe = PROBES[(index + number) % len(PROBES)]
            text = f"{family}:{SEED}:{index}"
            yield text if probe is None else f"probe:{probe}({text})"


def _of_corpus(number: int, setting: object) -> list[str]:
    names = [_from_root(name) for name in case_files(None, [setting]).names]  # type: ignore[list-item]
    return names[:: max(1, len(names) // number)][:number]


def _from_root(name: str) -> str:
    """The case's file as seen from the checkout, where the evidence runs."""
    path = Path(name)
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else name
