"""Case files of a folder, each at each of its scales."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, cut
from minkref.operand import read_operand

NO_CASES = (".cert.json", ".refusal.json")
CHECKOUT = Path(__file__).resolve().parents[2]


def corpus_folder() -> Path:
    """That of the checkout."""
    return CHECKOUT / "degeneracies" / "corpus"


def case_files(folder: Path | None) -> tuple[str, ...]:
    """Names of cases, in the order of the paths. Refuses a folder that holds none, and a case that
    cannot be read."""
    where = folder or corpus_folder()
    names = []
    for path in sorted(where.rglob("*.json")) if where.is_dir() else []:
        if path.name.endswith(NO_CASES) or not _is_meant_as_case(path):
            continue
        for part in ("#P", "#Q"):
            read_operand(f"{path}{part}")
        names += [f"{path}@{scale}" for scale in scales_of(path)]
    if not names:
        raise Refusal(
            "there is no case file (case-v1) in this folder",
            str(where),
            "name a folder of case files by --corpus, or take --suite fuzz",
            "no-case-files",
        )
    return tuple(names)


def _is_meant_as_case(path: Path) -> bool:
    """Refuses what is no JSON; other JSON than cases may be in the folder."""
    try:
        value = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        mend = "mend the file, or take it out of the folder"
        raise Refusal(f"this is no JSON: {cut(str(error))}", str(path), mend, "syntax") from error
    return isinstance(value, dict) and "schema" in value


def scales_of(path: Path) -> list[str]:
    """Those at which the case is asked for; empty where the file is no case."""
    try:
        value = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return []
    if not isinstance(value, dict) or value.get("schema") != "case-v1":
        return []
    scales = value.get("scales")
    if isinstance(scales, list) and scales:
        return [str(scale) for scale in scales]
    return [_within(value.get("interval"))]


def _within(interval: Any) -> str:
    """1, or the end that is nearer to it."""
    ends = interval if isinstance(interval, dict) else {}
    try:
        if "from" in ends and Fraction(str(ends["from"])) > 1:
            return str(ends["from"])
        if "to" in ends and Fraction(str(ends["to"])) < 1:
            return str(ends["to"])
    except (ValueError, ZeroDivisionError):
        pass  # the reader of cases refuses it
    return "1"
