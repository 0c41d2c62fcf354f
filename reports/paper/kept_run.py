"""One run of `minkref report paper`, kept with its date and machine, and its verdicts as
Markdown."""

from __future__ import annotations

import json
import os
import platform
import textwrap
from collections import Counter
from collections.abc import Sequence
from datetime import UTC, datetime
from importlib import resources
from pathlib import Path
from typing import Any

from minkref.model_catalogue import all_models
from minkref.reports.paper.entry import RULE

FILE = "kept_run.json"
WIDTH = 120
COMMAND = "minkref report paper"
#: Places and titles of what is timed, which a run without a quiet machine leaves out.
TIMED = {
    "Table 1": "",
    "Fig. 7": "",
    "Fig. 8": "",
    "Section 7.1": "Times of the pre-processing",
    "Fig. 9": "",
    "Fig. 10, Table 2": "",
    "Fig. 11": "",
}


def keep(report: Path, folder: Path) -> None:
    """Writes the run of a report's `paper.json` to a folder, an entry's line after another."""
    entries = json.loads(report.read_text(encoding="utf-8"))
    made = datetime.fromtimestamp(report.stat().st_mtime, tz=UTC)
    head = {
        "date": f"{made:%Y-%m-%d}",
        "machine": _machine(),
        "paper_models": {"monkey", "bird", "neuron"} <= set(all_models()),
    }
    lines = [f'"{key}": {json.dumps(value)},' for key, value in head.items()]
    told = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in entries)
    text = "{\n" + "\n".join(lines) + f'\n"entries": [\n{told}\n]\n' + "}\n"
    (folder / FILE).write_text(text, encoding="utf-8")


def _machine() -> str:
    """The processor, as Linux names it, and the cores."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return f"{os.cpu_count()} cores of {names[0] if names else platform.machine()}"


def kept() -> dict[str, Any] | None:
    """The kept run; None without one."""
    try:
        text = (resources.files(__package__) / FILE).read_text(encoding="utf-8")
    except FileNotFoundError:
        return None
    return dict(json.loads(text))


def verdicts() -> str:
    """The kept run's entries for `docs/paper.md`."""
    run = kept()
    if run is None:
        return _wrapped(f"No run of `{COMMAND}` has been kept: {RULE}") + "\n"
    models = "the paper's models" if run["paper_models"] else "look-alikes of the paper's models"
    counts = Counter(entry["verdict"] for entry in run["entries"])
    told = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    head = (
        f"One run of `{COMMAND}`, of {run['date']}, on {run['machine']}, with {models}: {told}. "
        f"{RULE}"
    )
    missing = [place for place, title in TIMED.items() if not _has(run["entries"], place, title)]
    if missing:
        told = "; ".join(f"{place} {TIMED[place]}".strip() for place in missing)
        head += f" This run was not whole: nothing was timed of {told}."
    return "\n\n".join([_wrapped(head), *map(_entry, run["entries"])]) + "\n"


def _has(entries: Sequence[dict[str, Any]], place: str, title: str) -> bool:
    return any(one["place"] == place and one["title"].startswith(title) for one in entries)


def _entry(entry: dict[str, Any]) -> str:
    parts = [
        _wrapped(f"**{entry['place']}, {entry['title']}: {entry['verdict']}.** {entry['why']}")
    ]
    if entry["claims"]:
        parts.append("\n".join(_item(_claim(claim)) for claim in entry["claims"]))
    if entry["unlike"]:
        parts.append(_wrapped(f"Unlike the paper: {_joined(entry['unlike'])}."))
    return "\n\n".join(parts)


def _joined(texts: Sequence[str]) -> str:
    return "; ".join(texts)


def _claim(claim: dict[str, Any]) -> str:
    so = "yes" if claim["holds"] else "no"
    if claim["holds"] and claim["chosen"]:
        so = "consistent"
    return (
        f"“{claim['words']}” ({claim['place']}). Tested: {claim['tested']}. Found: "
        f"{claim['found']}. So: **{so}**."
    )


def _wrapped(text: str) -> str:
    return textwrap.fill(text.strip(), WIDTH, break_long_words=False, break_on_hyphens=False)


def _item(text: str) -> str:
    return textwrap.fill(text, WIDTH, initial_indent="- ", subsequent_indent="  ",
                         break_long_words=False, break_on_hyphens=False)  # fmt: skip
