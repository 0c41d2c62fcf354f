"""The cases for `minkref verify`."""

from __future__ import annotations

from collections.abc import Iterable

from minkref.errors import Refusal, choice, nearest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.cases.verbs import EVENTS, FEATURES, PAIR_EVENTS, PATH, RANGES, UNION, UPDATE
from minkref.fuzz.features.question import FEATURES as OF_FEATURES
from minkref.fuzz.offsets.question import OFFSETS
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.laws import LAWS
from minkref.fuzz.run import naming
from minkref.fuzz.run.case_files import CaseFiles, case_files
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.settings import SETTINGS
from minkref.fuzz.space.families import SPACE_FAMILIES
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.unions.question import UNIONS
from minkref.verbs.verify_request import Cases

SUITES = ("fuzz", "corpus", "all")


def case_list(asked: Cases, declared: Iterable[Declaration]) -> CaseList:
    """Families and case files in space, or in the plane, only where a target takes them. Refuses
    what names no case."""
    suite, named, families = asked.suite, asked.case, asked.family
    if suite not in SUITES:
        what = f"there is no suite {suite[:40]!r}"
        mend = choice(suite, SUITES)
        raise Refusal(what, "--suite", mend)
    for text in named or []:
        refuse_unless_case(text)
    known = (*FAMILIES, *SPACE_FAMILIES, *UNIONS.families, *OFFSETS.families, *OF_FEATURES.families)
    for name in families or []:
        if name not in known:
            raise Refusal(
                "there is no such family",
                f"--family {name[:40]}",
                f"{nearest(name, known)}`minkref families` lists them",
            )
    kinds = list(declared)
    able = frozenset(word for kind in kinds for word in kind.capabilities)
    summing = frozenset(word for kind in kinds if kind.makes_sums for word in kind.capabilities)
    space, plane = "space" in summing, "plane" in summing
    wanted = families or [
        *(FAMILIES if plane else ()),
        *(SPACE_FAMILIES if space else ()),
        *(UNIONS.families if UNION in able else ()),
        *OFFSETS.families_for(able),
        *(OF_FEATURES.families if FEATURES in able else ()),
    ]
    fuzz = suite in ("fuzz", "all")
    filed = suite in ("corpus", "all") and not named
    taken = [setting for setting in SETTINGS if setting.name in able]
    files = case_files(asked.corpus, taken) if filed else CaseFiles()
    laws = [*LAWS, *(verb for verb in (UPDATE, EVENTS, PAIR_EVENTS) if verb in able)]
    cases = CaseList(
        asked.seed,
        asked.pairs,
        asked.seconds,
        tuple(named or ()),
        asked.models and fuzz and plane and not families,
        tuple(name for name in wanted if name in FAMILIES) if fuzz else (),
        tuple(name for name in wanted if name in SPACE_FAMILIES) if fuzz else (),
        tuple(laws) if asked.derived else (),
        asked.derived,
        files.names,
        "rejects-invalid" in able and fuzz and not families,
        tuple(verb for verb in (PATH, RANGES) if verb in able and fuzz and not families),
        tuple(name for name in wanted if name in UNIONS.families) if fuzz else (),
        tuple(name for name in wanted if name in OFFSETS.families) if fuzz else (),
        tuple(name for name in wanted if name in OF_FEATURES.families) if fuzz else (),
        "rational" not in able,
    )
    if files.note is not None:
        cases.notes.append(files.note)
    return cases


def refuse_unless_case(text: str) -> None:
    """Refuses what names no case, before any worker does."""
    try:
        naming.load(CaseName(text, "named"))
    except NoCase as reason:
        raise Refusal(
            f"there is no such case: {reason}", f"--case {text[:80]}", "name another"
        ) from reason
