"""Case files of a folder, each at each of its scales."""

from __future__ import annotations

import json
from pathlib import Path

from minkref.errors import Refusal

CHECKOUT = Path(__file__).resolve().parents[2]


def corpus_folder() -> Path:
    """That of the checkout."""
    return CHECKOUT / "degeneracies" / "corpus"


def case_files(folder: Path | None) -> tuple[str, ...]:
    """Names of cases, in the order of the paths. Refuses a folder that holds none."""
    where = folder or corpus_folder()
    names = []
    for path in sorted(where.rglob("*.json")) if where.is_dir() else []:
        names += [f"{path}@{scale}" for scale in scales_of(path)]
    if not names:
        raise Refusal(
            "there is no case file (case-v1) in this folder",
            str(where),
            "name a folder of case files by --corpus, or take --suite fuzz",
            "no-case-files",
        )
    return tuple(names)


def scales_of(path: Path) -> list[str]:
    """Those at which the case is asked for; empty where the file is no case."""
    try:
        value = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return []
    if not isinstance(value, dict) or value.get("schema") != "case-v1":
        return []
    scales = value.get("scales")
    return [str(scale) for scale in scales] if isinstance(scales, list) and scales else ["1"]
