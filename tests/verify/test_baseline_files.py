"""Malformed baselines are refused: otherwise a typing error could hide a fault."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from minkref.errors import Refusal
from minkref.fuzz.verdicts.baseline import Baseline, read_baseline

ENTRY = {"target": "t", "version": "*", "kind": "missing", "reason": "known"}
HEAD = '{"baseline": "baseline-v1", "entries": '
TEXTS = {
    "not JSON": (HEAD, "not JSON"),
    "entries twice": (HEAD + '[], "entries": []}', "twice"),
    "a field twice": (HEAD + '[{"target": "t", "target": "*"}]}', "twice"),
    "another member": (HEAD + '[], "entires": []}', "did you mean entries"),
    "another field": (HEAD + json.dumps([{**ENTRY, "reasons": "x"}]) + "}", "did you mean reason"),
    "a field missing": (HEAD + '[{"target": "t"}]}', "lacks one of"),
    "another kind": (HEAD + json.dumps([{**ENTRY, "kind": "mising"}]) + "}", "did you mean"),
    "deep": ("[" * 100_000, "not JSON"),
}


def refusal(path: Path) -> Refusal:
    with pytest.raises(Refusal) as refused:
        read_baseline(path)
    return refused.value


@pytest.mark.parametrize("name", TEXTS)
def test_what_is_no_baseline_is_refused(name: str, tmp_path: Path) -> None:
    text, word = TEXTS[name]
    path = tmp_path / "baseline.json"
    path.write_text(text, encoding="utf-8")
    refused = refusal(path)
    assert word in refused.what + refused.mend
    assert refused.where.startswith(str(path))


def test_a_file_of_any_length_is_read_to_a_length_only(tmp_path: Path) -> None:
    path = tmp_path / "baseline.json"
    with path.open("wb") as stream:
        stream.truncate(1 << 33)
    assert "longer than" in refusal(path).what


def test_a_baseline_is_read_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "baseline.json"
    value: Any = {"baseline": "baseline-v1", "entries": [ENTRY]}
    path.write_text(json.dumps(value), encoding="utf-8")
    read = read_baseline(path)
    assert isinstance(read, Baseline)
    assert read.entries[0].__dict__ == ENTRY
