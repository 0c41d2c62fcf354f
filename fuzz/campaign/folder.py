"""A folder with campaigns: heads, states, shrunk findings; `fuzz/ledgers` manages the ledger."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from minkref.errors import Refusal
from minkref.file_text import text_of_file
from minkref.output.documents import write_atomically
from minkref.output.output_folder import make_folder

FORMAT = "campaign-v1"
DIGITS = 12
#: Members of a head that do not change the work.
TOLD = ("name", "id")


def campaign_id(head: Mapping[str, Any]) -> str:
    """Identifies the work of a campaign: its cases, targets, versions and limits."""
    work = {name: value for name, value in head.items() if name not in TOLD}
    text = json.dumps(work, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]


def head_path(folder: Path, campaign: str) -> Path:
    return folder / "campaigns" / f"{campaign}.json"


def state_path(folder: Path, campaign: str) -> Path:
    return folder / "state" / f"{campaign}.json"


def small_path(folder: Path, campaign: str, key: str) -> Path:
    """Returns the place of a shrunk finding."""
    digest = hashlib.sha256(key.encode()).hexdigest()[:16]
    return folder / "kinds" / campaign / f"{digest}.json"


def write_json(path: Path, value: Any) -> None:
    """Writes a file at once, or not at all."""
    make_folder(path.parent)
    write_atomically(path, json.dumps(value, separators=(",", ":")) + "\n")


def read_json(path: Path) -> dict[str, Any]:
    """Reads a file of the folder. Refuses others."""
    mend = "remove it: the next run makes it again"
    try:
        value = json.loads(text_of_file(path, str(path), mend))
    except (ValueError, RecursionError) as error:
        raise Refusal("this is no JSON", str(path), mend, "bad-campaign") from error
    if not isinstance(value, dict):
        raise Refusal("this is no JSON object", str(path), mend, "bad-campaign")
    return value


def heads(folder: Path) -> Iterator[dict[str, Any]]:
    """Yields the heads of all campaigns. Refuses a folder without any."""
    paths = sorted((folder / "campaigns").glob("*.json"))
    if not paths:
        mend = "name the folder that `minkref campaign run` wrote"
        raise Refusal("there is no campaign in this folder", str(folder), mend, "no-campaign")
    for path in paths:
        head = read_json(path)
        if head.get("format") != FORMAT or campaign_id(head) != path.stem:
            what = "this is not the head of a campaign, or it was changed"
            raise Refusal(what, str(path), "take it from a copy of the folder", "bad-campaign")
        yield head


def ranges_of(numbers: set[int]) -> list[list[int]]:
    """Writes a set as ranges [first, end)."""
    ranges: list[list[int]] = []
    for number in sorted(numbers):
        if ranges and ranges[-1][1] == number:
            ranges[-1][1] = number + 1
        else:
            ranges.append([number, number + 1])
    return ranges
