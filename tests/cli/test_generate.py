"""`minkref generate`, and its cases in other commands."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from minkref.degeneracies import lint


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (["fits-hole", "--count", "2"], 0, "2 cases"),
        (["invalid-self-intersection", "--count", "3"], 0, "3 cases"),
        (["comb"], 2, "no such family"),
        (["fits-hole", "--count", "0"], 2, "--count"),
    ],
)
def test_generate(minkref: Any, tmp_path: Path, words: list[str], code: int, told: str) -> None:
    ran = minkref("generate", *words, "-o", str(tmp_path / "out"))
    assert (ran.code, told in ran.out + ran.err) == (code, True)
    if words[0].startswith("invalid"):
        for path in (tmp_path / "out").rglob("*.refusal.json"):
            told = json.loads(path.read_text(encoding="utf-8"))
            bad = minkref("sum", str(path.with_name(told["operand"])), "g1")
            assert bad.code == 2 and all(place in bad.err for place in told["place"])
    elif code == 0:
        assert minkref("check", str(tmp_path / "out")).code == 0
        value = minkref("generate", *words, "-o", str(tmp_path / "out"), "--json").json
        assert [Path(row["case"]).exists() for row in value["cases"]] == [True, True]
    else:
        assert not (tmp_path / "out").exists()


def test_a_case_can_be_verified(minkref: Any) -> None:
    (path,) = list((lint.CORPUS / "fits-slot").glob("*.json"))[:2][:1]
    name = str(path).replace(".cert.json", ".json")
    ran = minkref("verify", "minkref", "--case", name, "--json")
    assert ran.code == 0


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('{"schema": "case-v1", "id"', "syntax"),
        ('{"schema": "case-v9", "id": "x", "dimension": 2}', "unsupported-version"),
        (
            '{"schema": "case-v1", "id": "x", "dimension": 2, "scales": ["1"], '
            '"P": {"polygons": [{"outer": [["0","0"],["0","0"],["1","0"],["0","1"]]}]}, '
            '"Q": {"polygons": []}}',
            "zero-length-edge",
        ),
    ],
)
def test_a_bad_case_in_a_corpus_is_refused(
    minkref: Any, tmp_path: Path, text: str, code: str
) -> None:
    """Not passed over in silence."""
    path = tmp_path / "bad.json"
    path.write_text(text, encoding="utf-8")
    words = ("verify", "minkref", "--suite", "corpus", "--corpus", str(tmp_path), "--json")
    ran = minkref(*words)
    assert (ran.code, ran.json["error"]["code"]) == (2, code)
    ran = minkref("verify", "minkref", "--case", str(path), "--json")
    assert ran.code == 2 and "bad.json" in ran.out


def test_an_empty_scale_is_no_scale(minkref: Any) -> None:
    assert minkref("verify", "minkref", "--case", "g1+g2@").code == 2
