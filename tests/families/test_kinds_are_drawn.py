"""Each generator draws each kind, and combines each kind with each other choice. If two choices are
residues of one number, some pairs never come: a kind never drawn tests nothing, and looks like a
kind that passes."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable
from itertools import product

import pytest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.invalid.family import KINDS as INVALID
from minkref.fuzz.invalid.family import invalid_pair
from minkref.fuzz.judges.disc.disc_diagram import SETS, drawn_set
from minkref.fuzz.judges.motion.space_path_cases import KINDS as SPACE_PATHS
from minkref.fuzz.judges.motion.space_path_cases import space_path_case
from minkref.fuzz.judges.motion.trap_cases import KINDS as TRAPS
from minkref.fuzz.judges.motion.trap_cases import trap_case
from minkref.fuzz.motion.asked_path import FAMILIES as ASKED
from minkref.fuzz.motion.asked_path import POSITIONS, drawn_path
from minkref.fuzz.motion.path_cases import KINDS as PATHS
from minkref.fuzz.motion.path_cases import path_case
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.drawing import is_valid
from minkref.fuzz.plane.families.pinched_pairs import pinched_pair
from minkref.fuzz.plane.families.random_pairs import GROWTH, random_pair
from minkref.fuzz.run.case_list import FAR_AND_LARGE, CaseList
from minkref.fuzz.space.case import LAWS_IN_SPACE
from minkref.fuzz.space.general_pairs import FAMILIES as SOLIDS
from minkref.fuzz.space.general_pairs import OF_PARTS
from minkref.motion.scale_ranges import CONTACTS

SEED = 61
Kind = tuple[object, ...]


def of_invalid(index: int) -> Kind:
    """The kind of invalid pair, and whether the first operand is the valid one."""
    kind, P, _ = invalid_pair(SEED, index)
    return kind, is_valid(P)


def of_random(index: int) -> Kind:
    """Whether operands may have holes, and whether the scale is another one than 1."""
    pair = random_pair(SEED, GROWTH + index)
    holes = any(part["holes"] for text in (pair.P, pair.Q) for part in json.loads(text)["polygons"])
    return holes, pair.scale != "1"


def of_pinched(index: int) -> Kind:
    """Vertices of the smaller operand, 3 for a region."""
    pair = pinched_pair(SEED, index)
    rings = [json.loads(text)["polygons"][0]["outer"] for text in (pair.P, pair.Q)]
    return (min(3, *map(len, rings)),)


#: For each generator: the kind that a number draws, all kinds, how many numbers are enough.
GENERATORS: dict[str, tuple[Callable[[int], Kind], set[Kind], int]] = {
    "paths": (
        lambda k: (path_case(SEED, k).kind,), {(kind,) for kind in (*PATHS, "general")}, 24,
    ),
    "paths in space": (
        lambda k: (space_path_case(SEED, k).kind,),
        {(kind,) for kind in (*SPACE_PATHS, "general")}, 80,
    ),
    "traps": (lambda k: (trap_case(SEED, k).kind,), {(kind,) for kind in TRAPS}, len(TRAPS)),
    "invalid pairs": (of_invalid, set(product(INVALID, (False, True))), 2 * len(INVALID)),
    "random pairs": (of_random, set(product((False, True), repeat=2)), 60),
    "pinched pairs": (of_pinched, {(1,), (2,), (3,)}, 20),
    "sets of diagrams": (
        lambda k: (drawn_set(SEED, k)[0].split()[0],), {(name,) for name in (*SETS, "grid")}, 90,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", GENERATORS)
def test_a_generator_draws_each_kind(name: str) -> None:
    kind_of, kinds, count = GENERATORS[name]
    drawn = Counter(map(kind_of, range(count)))
    assert set(drawn) == kinds, f"seed {SEED}: {drawn}"


@pytest.mark.parametrize("family", ASKED)
def test_paths_that_are_asked_about_have_each_position(family: str) -> None:
    drawn = Counter(case.position for case in asked(family, 60))
    assert set(drawn) == POSITIONS, f"seed {SEED}: {drawn}"


def asked(family: str, count: int) -> Iterable[object]:
    return (drawn_path(CaseName(f"{family}:{SEED}:{k}", family), family, SEED, k)
            for k in range(count))  # fmt: skip


def test_each_position_comes_with_both_rules_of_contact() -> None:
    drawn = Counter((case.position, case.contact) for case in asked(ASKED[0], 160))
    assert set(drawn) == set(product(POSITIONS, CONTACTS)), f"seed {SEED}: {drawn}"


def test_scales_that_are_valid_alone_are_asked_about() -> None:
    """Scales that are valid alone occur at least once per thirty cases."""
    alone = sum(
        any(one.low == one.high for one in case.valid("pieces").ranges)
        for case in asked(ASKED[0], 120)
    )
    assert alone >= 4, f"seed {SEED}: {alone}"


def test_families_of_solids_have_paths_of_each_kind() -> None:
    """Families come in turn, but kinds of paths do not."""
    families = [*SOLIDS, *OF_PARTS]
    degenerate: Counter[tuple[str, bool]] = Counter()
    for index in range(24 * len(families)):
        case = space_path_case(SEED, index)
        degenerate[case.name.split(":")[0], case.kind != "general"] += 1
    assert set(degenerate) == set(product(families, (False, True))), f"seed {SEED}"


def test_a_run_has_each_family_with_each_law_and_far_out() -> None:
    families, laws = tuple(FAMILIES), ("swap(", "identity(")
    space = ("space-convex", "space-comb", "space-knot", "space-torus")
    cases = CaseList(SEED, 1, families=families, laws=laws, space=space, derived=True)
    drawn: Counter[tuple[str, ...]] = Counter()
    for index in range(500):
        for name in cases._round(index):
            drawn[name.text.split("(")[0] + "(", name.text.split("(")[-1].split(":")[0]] += 1
    far = {f"{change}(" for change, _ in FAR_AND_LARGE}
    wanted = set(product(far, families)) | set(product((f"{law}(" for law in laws), families))
    wanted |= set(product((f"{law}(" for law in LAWS_IN_SPACE), space))
    missing = {(law.replace("((", "("), family) for law, family in wanted} - set(drawn)
    assert not missing, f"seed {SEED}: {sorted(missing)[:9]}"
