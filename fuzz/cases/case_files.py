"""Case files of a folder, each at each of its scales."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, cut
from minkref.file_text import text_of_file
from minkref.fuzz.cases.case import CaseName
from minkref.fuzz.cases.space_case_file import is_in_space, read_space_case, scalings_in
from minkref.fuzz.targets.number_text import number_of
from minkref.operand import read_operand

NO_CASES = (".cert.json", ".refusal.json")
SOME_SCALING = "1"  # operands are read before a run, scalings when their turn comes
CHECKOUT = Path(__file__).resolve().parents[2]


def corpus_folder() -> Path:
    """That of the checkout."""
    return CHECKOUT / "degeneracies" / "corpus"


@dataclass(frozen=True)
class CaseFiles:
    """`names`: the cases of a run. `note` says which files are left out."""

    names: tuple[str, ...] = ()
    note: str | None = None


def case_files(folder: Path | None, plane: bool = True, space: bool = True) -> CaseFiles:
    """The cases in the plane, those in space, or both, in the order of the paths. Refuses a folder
    that holds none of these, and a case that cannot be read, be it left out or not."""
    where = folder or corpus_folder()
    names = []
    left_out = []
    for path in sorted(where.rglob("*.json")) if where.is_dir() else []:
        if path.name.endswith(NO_CASES):
            continue
        value = _json_of(path)
        if not isinstance(value, dict) or "schema" not in value:
            continue
        spatial = is_in_space(value)
        found = [f"{path}@{scale}" for scale in scales_in(path, value)]
        if spatial:
            read_space_case(CaseName(str(path), "case files"), path, SOME_SCALING)
        else:
            for part in ("#P", "#Q"):
                read_operand(f"{path}{part}")
        if space if spatial else plane:
            names += found
        else:
            left_out.append(path)
    if not names:
        raise _nothing(where, bool(left_out), plane)
    note = _left_out(len(left_out), plane) if left_out else None
    return CaseFiles(tuple(names), note)


def _nothing(where: Path, left_out: bool, plane: bool) -> Refusal:
    if not left_out:
        what = "there is no case file (case-v1) in this folder"
        mend = "name a folder of case files by --corpus, or take --suite fuzz"
    elif plane:
        what = "all case files in this folder are in space, where no target takes operands"
        mend = "name a target in space, minkref:convex, say, or another folder by --corpus"
    else:
        what = "all case files in this folder are in the plane, where no target takes operands"
        mend = "name a target in the plane, minkref:paper, say, or another folder by --corpus"
    return Refusal(what, str(where), mend, "no-case-files")


def _left_out(count: int, plane: bool) -> str:
    where = "in space" if plane else "in the plane"
    files = "case file" if count == 1 else "case files"
    return f"left out: {count} {files} {where}, where no target takes operands"


def _json_of(path: Path) -> Any:
    """Refuses what is no JSON; other JSON than cases may be in the folder."""
    mend = "mend the file, or take it out of the folder"
    text = text_of_file(path, str(path), mend)
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise Refusal(f"this is not JSON: {cut(str(error))}", str(path), mend, "syntax") from error


def case_document(path: Path) -> dict[str, Any] | None:
    """The JSON of a case; None of any other file."""
    try:
        value = json.loads(text_of_file(path, str(path), ""))
    except (Refusal, ValueError, RecursionError):
        return None
    is_case = isinstance(value, dict) and value.get("schema") == "case-v1"
    return value if is_case else None


def scales_in(path: Path, value: dict[str, Any]) -> list[str]:
    """Those at which a case is asked for."""
    if value.get("schema") != "case-v1":
        return []  # the readers of operands refuse it
    if is_in_space(value):
        return scalings_in(value, str(path))
    scales = value.get("scales")
    if isinstance(scales, list) and scales:
        return [str(scale) for scale in scales]
    return [_within(value.get("interval"))]


def _within(interval: Any) -> str:
    """1, or the end that is nearer to it."""
    ends = interval if isinstance(interval, dict) else {}
    try:
        if "from" in ends and number_of(str(ends["from"])) > 1:
            return str(ends["from"])
        if "to" in ends and number_of(str(ends["to"])) < 1:
            return str(ends["to"])
    except ValueError:
        pass  # the reader of cases refuses it
    return "1"
