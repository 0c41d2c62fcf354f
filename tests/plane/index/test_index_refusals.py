"""Refusals of the index in Python: scales, forms, windows, files, more memory than allowed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from indexed_sums import FORMS, NUMBERS, Index, operands, scales
from minkref import _core
from minkref.plane.operand import read_operand


def code_of(refused: pytest.ExceptionInfo[_core.BadInput]) -> str:
    assert refused.value.problem and refused.value.mend
    return refused.value.code


QUESTIONS = {
    "rings": lambda index, s: index.rings(s),
    "rings in lowest terms": lambda index, s: index.rings(s, "rational"),
    "batch": lambda index, s: index.batch(["1", s, "2"], "double", 2),
    "sum": lambda index, s: index.sum(s),
    "area": lambda index, s: index.area(s),
    "area_polynomial": lambda index, s: index.area_polynomial(s),
    "components_and_holes": lambda index, s: index.components_and_holes(s),
    "neighbours": lambda index, s: index.neighbours(s),
    "first_difference": lambda index, s: index.first_difference([s]),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_scales_that_are_none_or_outside_the_window_are_refused(
    indices: dict[str, Index], question: str
) -> None:
    ask = QUESTIONS[question]
    bad = {
        "x": "not-a-number",
        "": "not-a-number",
        "nan": "not-a-number",
        "1/0": "zero-denominator",
    }
    beyond = (
        "5.0000000000000000000001",
        "33333333333333333/100000000000000000",
        "0",
        "-1",
        "1e400",
    )
    for text, code in bad.items():
        with pytest.raises(_core.BadInput) as refused:
            ask(indices["letters"], text)
        assert code_of(refused) == code
    for scale in beyond:
        with pytest.raises(_core.BadInput) as refused:
            ask(indices["letters"], scale)
        assert code_of(refused) == "outside-window"
    for scale in ("0", "-1"):
        with pytest.raises(_core.BadInput) as refused:
            ask(indices["islands"], scale)
        assert code_of(refused) == "outside-window"
    for scale in ("1/3", "5"):
        ask(indices["letters"], scale)


def test_a_form_that_is_none_is_refused(indices: dict[str, Index]) -> None:
    for form in ("", "float", "Double", "tracks"):
        for ask in (
            lambda form: indices["islands"].rings("1", form),
            lambda form: indices["islands"].batch(["1"], form),
        ):
            with pytest.raises(_core.BadInput) as refused:
                ask(form)
            assert code_of(refused) == "no-form"


@pytest.mark.parametrize("form", FORMS)
def test_what_a_form_has_not_is_refused(indices: dict[str, Index], form: str) -> None:
    rings = indices["islands"].rings("1", form)
    of_forms = {**NUMBERS, "double": ("x", "y", "error")}
    for other, names in of_forms.items():
        for name in names:
            if other == form:
                getattr(rings, name)
                continue
            with pytest.raises(_core.BadInput) as refused:
                getattr(rings, name)
            assert code_of(refused) == "other-form"
            assert name in refused.value.problem and form in refused.value.problem


@pytest.mark.parametrize(
    "window", [("2", "1"), ("0", "1"), ("-1", None), (None, "0"), (None, "-2")]
)
def test_a_window_without_scales_is_refused(window: tuple[str | None, str | None]) -> None:
    with pytest.raises(_core.BadInput) as refused:
        Index(*operands("islands"), *window)
    assert code_of(refused) == "bad-window"


def test_more_memory_than_allowed_is_refused() -> None:
    with pytest.raises(_core.LimitExceeded) as refused:
        Index(*operands("islands"), "1", "2", 1, 1 << 20)
    assert code_of(refused) == "memory-limit"


def test_files_that_cannot_be_read_or_written_are_refused(
    indices: dict[str, Index], tmp_path: Path
) -> None:
    for path, code in ((tmp_path, "no-file"), (tmp_path / "absent", "no-file")):
        with pytest.raises(_core.BadInput) as refused:
            Index.open(str(path))
        assert code_of(refused) == code
        assert str(path) in str(refused.value)
    for path in (tmp_path, tmp_path / "no" / "folder"):
        with pytest.raises(_core.BadInput) as refused:
            indices["islands"].save(str(path))
        assert code_of(refused) == "cannot-write"
    assert list(tmp_path.iterdir()) == []


def test_too_many_threads_are_refused(indices: dict[str, Index]) -> None:
    index = indices["islands"]
    for ask in (
        lambda: index.batch(scales(index, 4), "double", 4_000_000_000),
        lambda: Index(index.P, index.Q, "1", "2", 1025),
    ):
        with pytest.raises(_core.BadInput) as refused:
            ask()
        assert code_of(refused) == "too-many-threads"


NO_ROOM_FOR_STACKS = """
import resource
from minkref import _core
from minkref.plane.operand import read_operand
P, Q = read_operand("g1").set, read_operand("g2").set
index = _core.ScaleIndex(P, Q, "1/2", "2")
scales = [f"{k}/100" for k in range(60, 190)]
expected = [rings.x.tolist() for rings in index.batch(scales, "double", 1)]
with open("/proc/self/statm") as file:
    size = int(file.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + (4 << 20),) * 2)
assert [rings.x.tolist() for rings in index.batch(scales, "double", 64)] == expected
"""


def test_where_no_thread_starts_the_caller_does_all_the_work() -> None:
    subprocess.run([sys.executable, "-c", NO_ROOM_FOR_STACKS], check=True, timeout=60)


@pytest.mark.parametrize("kind", ["holes", "", "Hole", "x"])
def test_a_feature_that_is_none_is_refused_by_both_routes(kind: str) -> None:
    P, Q = (read_operand(name).set for name in ("g1", "g2"))
    for routed in (_core.ScaleIndex(P, Q, "1", "2"), _core.DynamicSum(P, Q, "1", "2")):
        for ask in (routed.features, routed.lives):
            with pytest.raises(_core.BadInput) as refused:
                ask(kind)
            assert code_of(refused) == "unknown-feature"
