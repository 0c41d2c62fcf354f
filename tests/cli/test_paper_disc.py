"""The Appendix's own program on the command line: `--route paper-update` with a disc, sentences of
exact pair events, and the convolution with its parents."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import schema

Minkref = Callable[..., Any]

FRAME = "POLYGON ((0 0, 20 0, 20 20, 0 20, 0 0), (2 2, 2 18, 18 18, 18 2, 2 2))"
TWO = "MULTIPOLYGON (((0 4, 4 6, 0 8, 0 4)), ((14 4, 14 8, 10 7, 14 4)))"


@pytest.mark.parametrize("words", [("disc:7/2",), ("disc:sqrt:2",), ("disc:3", "--scale", "2/3")])
def test_all_corrected_and_exact_is_the_exact_sum(minkref: Minkref, words: tuple[str, ...]) -> None:
    by_paper = ("--route", "paper-update", "--form", "corrected", "--json")
    found = minkref("sum", TWO, *words, *by_paper).json
    jsonschema.validate(found, schema("sum_with_disc"))
    exact = minkref("sum", TWO, *words, "--json").json
    jsonschema.validate(exact, schema("sum_with_disc"))
    assert found["digest"] == exact["digest"] == found["exact"]["digest"]
    assert found["result"] == exact["result"]
    assert found["comparison"]["same_structure"] and found["exact"]["equal"]


def test_a_sentence_as_printed_loses_a_point_that_a_witness_names(minkref: Minkref) -> None:
    found = minkref(
        "sum", FRAME, "disc:1", "--route", "paper-update", "--form", "corrected",
        "--reading", "points=polygon", "--arithmetic", "double", "--json",
    ).json  # fmt: skip
    jsonschema.validate(found, schema("sum_with_disc"))
    assert not found["exact"]["equal"]
    assert found["comparison"]["witness"] is not None
    assert found["readings"]["points"] == "polygon"


def test_the_scaled_disc_is_that_of_the_appendix(minkref: Minkref) -> None:
    words = ("--route", "paper-update", "--form", "corrected", "--json")
    found = minkref("sum", "disc:2", TWO, "--scale", "7/4", *words).json
    assert found["squared_radius"] == "49/4"
    assert found["digest"] == minkref("sum", TWO, "disc:7/2", "--json").json["digest"]


def test_a_sweep_holds_each_answer_against_the_exact_sum(minkref: Minkref, tmp_path: Path) -> None:
    words = ("sweep", TWO, "disc:3/2", "--from", "1", "--to", "3", "--steps", "5")
    by_paper = ("--route", "paper-update", "--arithmetic", "mpfr:200", "--form", "corrected")
    found = minkref(*words, *by_paper, "-o", tmp_path / "sums", "--json").json
    jsonschema.validate(found, schema("sweep_with_disc"))
    assert [row["exact"]["same_structure"] for row in found["rows"]] == [True] * 5
    assert found["first_wrong"] is None
    assert found["events"]["missed"] == found["events"]["misplaced"] == 0
    one = json.loads((tmp_path / "sums" / found["rows"][0]["file"]).read_text(encoding="utf-8"))
    assert one["squared_radius"] == "9/4"
    table = minkref(*words, *by_paper)
    assert "first wrong" in table.out and "nowhere" in table.out


def test_one_sentence_of_exact_pair_events(minkref: Minkref) -> None:
    words = ("events", TWO, "disc:2", "--kind", "pair", "--json")
    all_printed = minkref(*words, "--form", "printed").json
    one = minkref(*words, "--reading", "radical=printed").json
    for found in (all_printed, one):
        jsonschema.validate(found, schema("events_with_disc_pairs"))
    assert all_printed["readings"] is None
    assert one["readings"]["radical"] == "printed"
    assert one["readings"]["line"] == "corrected"
    assert one["truth"]["missed"] <= all_printed["truth"]["missed"]


def test_the_convolution_has_segments_and_arcs_with_their_parents(minkref: Minkref) -> None:
    found = minkref("convolution", FRAME, "disc:1", "--json").json
    jsonschema.validate(found, schema("convolution_with_disc"))
    assert (found["segments"], found["arcs"], found["count"]) == (8, 4, 12)
    first, last = found["curves"][0], found["curves"][-1]
    assert first["parent"] == {"edge": [0, 0]}
    assert first["from"] == {"point": ["0", "0"], "normal": ["0", "-1"], "near": [0.0, -1.0]}
    assert last["kind"] == "arc" and "vertex" in last["parent"]
    assert "8 segments, 4 arcs" in minkref("convolution", FRAME, "disc:1").out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("sum", FRAME, "disc:1", "--reading", "line=printed"), "has no readings"),
        (("sum", FRAME, "disc:1", "--arithmetic", "double"), "exact only"),
        (("sum", FRAME, "disc:1", "--route", "paper-update", "--reading", "order=kept"),
         "no reading 'order'"),
        (("sum", FRAME, "disc:1", "--route", "paper-update", "--measures", "--json"),
         "exact sums only"),
        (("sum", FRAME, "disc:1", "--route", "paper-update", "--arithmetic", "interval"),
         "no arithmetic"),
        (("events", FRAME, "disc", "--reading", "line=printed"), "kind pair"),
        (("events", FRAME, "disc", "--kind", "pair", "--reading", "solve=printed"), "no reading"),
        (("convolution", FRAME, "disc:1", "--full"), "reduced convolution"),
    ],
)  # fmt: skip
def test_what_there_is_not_is_refused(
    minkref: Minkref, words: tuple[str, ...], message: str
) -> None:
    ran = minkref(*words)
    assert ran.code == 2
    assert message in ran.err + ran.out
