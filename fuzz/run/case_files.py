"""Case files in a folder, each at each of its scales."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, cut
from minkref.file_text import text_of_file
from minkref.fuzz.setting import Setting
from minkref.fuzz.settings import SETTINGS, setting_of_document

NO_CASES = (".cert.json", ".refusal.json")
CHECKOUT = Path(__file__).resolve().parents[2]


def corpus_folder() -> Path:
    """Returns the checkout's corpus."""
    return CHECKOUT / "degeneracies" / "corpus"


@dataclass(frozen=True)
class CaseFiles:
    """`names`: a run's cases. `note` lists left-out files."""

    names: tuple[str, ...] = ()
    note: str | None = None


def case_files(folder: Path | None, settings: Collection[Setting] = SETTINGS) -> CaseFiles:
    """Returns the cases for these settings, ordered by path. Refuses a folder without any, and an
    unreadable case, whether left out or not."""
    where = folder or corpus_folder()
    names = []
    left_out: Counter[Setting] = Counter()
    for path in sorted(where.rglob("*.json")) if where.is_dir() else []:
        if path.name.endswith(NO_CASES):
            continue
        value = _json_of(path)
        if not isinstance(value, dict) or "schema" not in value:
            continue
        setting = setting_of_document(value)
        found = [f"{path}@{scale}" for scale in scales_in(path, value)]
        setting.refuse_bad_operands(path)
        if setting in settings:
            names += found
        else:
            left_out[setting] += 1
    if not names:
        raise _nothing(where, left_out)
    notes = [_left_out(count, setting) for setting, count in left_out.items()]
    return CaseFiles(tuple(names), "; ".join(notes) or None)


def _nothing(where: Path, left_out: Collection[Setting]) -> Refusal:
    if not left_out:
        what = "there is no case file (case-v1) in this folder"
        mend = "name a folder of case files by --corpus, or take --suite fuzz"
    else:
        places = " or ".join(setting.where for setting in left_out)
        targets = " or ".join(setting.target for setting in left_out)
        what = f"all case files in this folder are {places}, where no target takes operands"
        mend = f"name a target {places}, {targets}, say, or another folder by --corpus"
    return Refusal(what, str(where), mend, "no-case-files")


def _left_out(count: int, setting: Setting) -> str:
    files = "case file" if count == 1 else "case files"
    return f"left out: {count} {files} {setting.where}, where no target takes operands"


def _json_of(path: Path) -> Any:
    """Reads JSON, refusing other text; the folder may hold JSON other than cases."""
    mend = "mend the file, or take it out of the folder"
    text = text_of_file(path, str(path), mend)
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise Refusal(f"this is not JSON: {cut(str(error))}", str(path), mend, "syntax") from error


def case_document(path: Path) -> dict[str, Any] | None:
    """Returns a case's JSON; None for any other file."""
    try:
        value = json.loads(text_of_file(path, str(path), ""))
    except (Refusal, ValueError, RecursionError):
        return None
    is_case = isinstance(value, dict) and value.get("schema") == "case-v1"
    return value if is_case else None


def scales_in(path: Path, value: dict[str, Any]) -> list[str]:
    """Returns the scales at which the file asks."""
    if value.get("schema") != "case-v1":
        return []  # the readers of operands refuse it
    return setting_of_document(value).scales_in(value, path)
