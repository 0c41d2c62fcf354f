"""The paper's own programs as targets: right where they claim it, caught with a witness where they
are wrong, and in a class of their own where they cannot tell."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from fractions import Fraction

import pytest
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.libraries.paper.program_name import read_name
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.run.case_files import case_files
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.runner import run
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Reason, Verdict
from named_cases import named
from thoroughness import draws, some

Outcomes = Callable[..., list[Outcome]]
RIGHT = "minkref-paper@rational,corrected"
SEED = 61
FILES = draws(40, 400)
TRIANGLES = (
    '{"P":{"polygons":[{"outer":[[34,0],[0,18],[6,5]]}]},'
    '"Q":{"polygons":[{"outer":[[23,0],[26,80],[9,91],[0,30],[7,38],[13,4],[8,0]]}]},"scale":"1"}'
)


def test_with_all_corrected_and_rational_numbers_no_case_of_the_corpus_fails(
    outcomes: Outcomes,
) -> None:
    names = random.Random(SEED).sample(case_files(None).names, FILES)
    said = outcomes(RIGHT, *names)
    print(f"seed {SEED}")
    assert {outcome.verdict for outcome in said} <= {Verdict.PASS, Verdict.GAVE_UP}
    gave_up = [outcome for outcome in said if outcome.verdict is Verdict.GAVE_UP]
    assert all("has no volume" in outcome.message for outcome in gave_up), gave_up
    assert len(said) == FILES > 4 * len(gave_up)


@pytest.mark.parametrize("verb", ["update", "pair-events"])
def test_the_corrected_update_and_its_events_pass(outcomes: Outcomes, verb: str) -> None:
    names = [f"{verb}({family}:{SEED}:0)" for family in ("holes", "comb", "touching", "random")]
    said = outcomes(RIGHT, *names)
    assert [outcome.verdict for outcome in said] == [Verdict.PASS] * len(names), said


@pytest.mark.parametrize("target", [RIGHT, "minkref-paper@rational,static"])
def test_factors_for_each_axis_are_answered(outcomes: Outcomes, target: str) -> None:
    names = [f"axes:0({family}:{SEED}:0)" for family in ("holes", "comb", "spiral", "lattice")]
    said = outcomes(target, *names)
    assert [outcome.verdict for outcome in said] == [Verdict.PASS] * len(names), said


def test_solids_of_any_shape_are_followed(outcomes: Outcomes) -> None:
    """Facets in a rounding arithmetic bound no set: these are given up."""
    families = some(("polycube", "cup", "frame", "torus"), 2)
    names = [f"space-{family}:{SEED}:0" for family in families]
    said = outcomes(RIGHT, *names, f"update(space-l-prism:{SEED}:1)")
    assert {outcome.verdict for outcome in said} == {Verdict.PASS}, said
    assert outcomes("minkref-paper@double", f"space-l-prism:{SEED}:0")[0].verdict is Verdict.GAVE_UP


def test_the_printed_program_in_doubles_is_wrong_with_a_witness(outcomes: Outcomes) -> None:
    (said,) = outcomes("minkref-paper@double", TRIANGLES)
    assert said.verdict is Verdict.WRONG and Reason.MISSING in said.reasons
    case = named(TRIANGLES)
    assert said.witness is not None
    assert holds(case.P_json, case.Q_json, case.scale, said.witness)


def test_events_that_the_printed_program_invents_are_shown(outcomes: Outcomes) -> None:
    (said,) = outcomes("minkref-paper@rational", f"pair-events({TRIANGLES})")
    assert said.verdict is Verdict.WRONG
    assert set(said.reasons) <= {Reason.EVENT_MISSED, Reason.EVENT_INVENTED}
    assert said.witness is not None and said.witness.scale is not None


def test_the_printed_repair_loses_a_convex_sum(outcomes: Outcomes) -> None:
    simplex = json.dumps(
        {
            "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
            "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
        }
    )
    literal = f'{{"P":{simplex},"Q":{simplex},"scale":"1,2,2"}}'
    printed, corrected = (
        outcomes(f"minkref-paper@rational{form}", literal)[0] for form in ("", ",corrected")
    )
    assert printed.verdict is Verdict.WRONG and printed.witness is not None
    assert corrected.verdict is Verdict.PASS


def test_what_an_interval_cannot_tell_is_given_up(outcomes: Outcomes) -> None:
    (said,) = outcomes("minkref-paper@interval,corrected", "g1+g2@1")
    assert said.verdict is Verdict.GAVE_UP
    assert "not decided" in said.message


def test_giving_up_is_no_breakdown(capsys: pytest.CaptureFixture[str]) -> None:
    cases = CaseList(named=("g1+g2@1",), models=False)
    done = run(cases, ["minkref-paper@interval"], ALL_TARGETS, {}, Baseline(), Limits(), 1)
    assert (done.exit_code(), done.exit_code(strict=True)) == (0, 4)


def test_the_static_program_has_no_update() -> None:
    entry = ALL_TARGETS.select_one("minkref-paper@double,static")
    assert entry.available
    name = read_name(entry.name)
    assert name.is_static and not name.is_exact


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("minkref-paper", "mpfr:BITS"),
        ("minkref-paper@", "mpfr:BITS"),
        ("minkref-paper@float", "rational, interval, double or mpfr:BITS"),
        ("minkref-paper@mpfr:1", "between 2 and"),
        ("minkref-paper@double,corected", "printed|corrected|static"),
        ("minkref-paper@double,solv=printed", "solve=printed|tolerance:EPS|least-squares"),
        ("minkref-paper@double,solve=exact", "solve=printed|tolerance:EPS|least-squares"),
        ("minkref-paper@double,errors=all", "errors=facets-of-P|chains-from-P|both"),
        ("minkref-paper@double,static,solve=printed", "leave out solve=printed or static"),
        ("minkref-paper@double,static,printed", "leave out one of the two"),
    ],
)
def test_a_name_with_an_unknown_part_is_refused_with_all_choices(name: str, said: str) -> None:
    with pytest.raises(Refusal) as refused:
        ALL_TARGETS.select([name])
    assert said in refused.value.mend


def test_only_exact_numbers_with_corrected_formulas_claim_to_be_exact() -> None:
    claims = {
        "rational": False,
        "rational,corrected": True,
        "rational,corrected,solve=printed": False,
        "rational,corrected,search=ee-errors": False,
        "rational,static": True,
        "double,corrected": False,
        "mpfr:200,static": False,
    }
    assert {name: read_name(f"minkref-paper@{name}").is_exact for name in claims} == claims


def test_the_tolerance_follows_the_bits() -> None:
    relative = {
        name: read_name(f"minkref-paper@{name}").relative
        for name in ("rational", "double", "mpfr:53", "mpfr:200")
    }
    assert relative == {
        "rational": 0,
        "double": Fraction(1, 10**9),
        "mpfr:53": Fraction(1, 10**9),
        "mpfr:200": Fraction(1, 10**33),
    }


@pytest.mark.parametrize("bits", [2, 2000, 100_000])
def test_any_number_of_bits_can_be_declared(outcomes: Outcomes, bits: int) -> None:
    (said,) = outcomes(f"minkref-paper@mpfr:{bits},static", "random:1:3")
    assert said.verdict in (*GOOD, Verdict.WRONG), said


def test_all_targets_leave_out_programs_that_are_wrong_by_design() -> None:
    chosen, _ = ALL_TARGETS.select(["all"])
    assert not [entry for entry in chosen if entry.name.startswith("minkref-paper")]
    assert "minkref-paper@mpfr:200" in {entry.name for entry in ALL_TARGETS.entries()}
