"""Random cases and cases of the corpus, in the plane and in space."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count, islice
from pathlib import Path

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.run.case_files import case_files
from minkref.fuzz.run.naming import load
from minkref.fuzz.setting import Setting
from minkref.fuzz.settings import setting_of
from minkref.reports.evidence.framework.places import ROOT

SEED = 77
PROBES = (None, 0, 2, 4)  # the drawn scale, and scales at and next to events
CONVEX = ("space-convex", "space-sphere")


def plane_cases(number: int) -> list[str]:
    """Draws half from all families in turn; half comes evenly from the corpus."""
    return [
        *islice(filter(exists, _drawn()), number // 2),
        *_of_corpus(number - number // 2, setting_of(2)),
    ]


def space_cases(number: int) -> list[str]:
    """Draws half, convex; half comes from the corpus, not only convex."""
    drawn = (f"{family}:{SEED}:{index}" for index in count() for family in CONVEX)
    return [*islice(drawn, number // 2), *_of_corpus(number - number // 2, setting_of(3))]


def exists(name: str) -> bool:
    """False for a probe beyond a pair's scales."""
    try:
        load(CaseName(name, "evidence"))
    except NoCase:
        return False
    return True


def _drawn() -> Iterator[str]:
    for index in count():
        for number, family in enumerate(setting_of(2).families):
            probe = PROBES[(index + number) % len(PROBES)]
            text = f"{family}:{SEED}:{index}"
            yield text if probe is None else f"probe:{probe}({text})"


def _of_corpus(number: int, setting: Setting) -> list[str]:
    names = [_from_root(name) for name in case_files(None, [setting]).names]
    return names[:: max(1, len(names) // number)][:number]


def _from_root(name: str) -> str:
    """Shortens a path to start at the checkout, where the evidence runs."""
    path = Path(name)
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else name
